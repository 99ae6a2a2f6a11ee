// Opens reports in Chromium and uses them as a maker does: node run.mjs PROGRAM SHARED_DATA. Exits with 77, which
// CTest counts as skipped, if the browser, the npm packages or the page itself are missing. RENEW=1 rewrites the
// golden pictures.
import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const [program, shared = '.'] = process.argv.slice(2);
const chromium = process.env.RIPSTOP_CHROMIUM ?? '/usr/bin/chromium';

function skip(reason) {
    console.log(`skipped: ${reason}`);
    process.exit(77);
}

if (!existsSync(chromium)) skip(`no browser at ${chromium} (Debian: chromium); RIPSTOP_CHROMIUM names another`);
if (!existsSync(join(here, '../../apps/report/node_modules/playwright-core')))
    skip('no playwright-core; make setup installs it');

const work = mkdtempSync(join(tmpdir(), 'ripstop-report-'));
const env = {
    ...process.env,
    RIPSTOP_PROGRAM: resolve(program),
    RIPSTOP_SHARED: resolve(shared),
    RIPSTOP_WORK: work,
    RIPSTOP_CHROMIUM: chromium,
};
delete env.NODE_TEST_CONTEXT;
const files = readdirSync(here)
    .filter((name) => name.endsWith('.test.mjs'))
    .sort()
    .map((name) => join(here, name));
const run = spawnSync(process.execPath, ['--test', '--test-reporter=spec', '--test-concurrency=1', ...files], {
    env,
    stdio: 'inherit',
});
rmSync(work, { recursive: true, force: true });
process.exit(run.status ?? 1);

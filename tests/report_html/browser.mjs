// A page of Chromium with a report in it, and the page's errors.
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { after } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import assert from 'node:assert/strict';

const require = createRequire(new URL('../../apps/report/package.json', import.meta.url));
const { chromium } = require('playwright-core');
const axe = readFileSync(require.resolve('axe-core/axe.min.js'), 'utf8');
const golden = join(dirname(fileURLToPath(import.meta.url)), 'golden');

const quiet = [
    '--no-sandbox',
    '--disable-quic',
    '--no-first-run',
    '--disable-background-networking',
    '--disable-component-update',
    '--disable-sync',
];
export const withWebGL = ['--use-angle=swiftshader', '--enable-unsafe-swiftshader'];
export const withoutWebGL = ['--disable-3d-apis'];

// One browser for all tests of a file that want the same flags.
const browsers = new Map();
async function browserWith(flags) {
    const key = flags.join(' ');
    if (!browsers.has(key))
        browsers.set(
            key,
            await chromium.launch({
                executablePath: process.env.RIPSTOP_CHROMIUM,
                headless: true,
                args: [...quiet, ...flags],
            }),
        );
    return browsers.get(key);
}
after(() => Promise.all([...browsers.values()].map((browser) => browser.close())));

// A new page for `use`, with nothing kept from the pages before it.
async function inPage(flags, wants, use) {
    const context = await (await browserWith(flags)).newContext(wants);
    try {
        await use(await context.newPage());
    } finally {
        await context.close();
    }
}

// Opens a report, passes it to `use`, and requires that it writes nothing to the console and requests nothing.
export const opened = (file, use, { flags = withWebGL, viewport = { width: 1400, height: 900 } } = {}) =>
    inPage(flags, { viewport, reducedMotion: 'reduce' }, async (page) => {
        const complaints = [],
            requests = [];
        page.on('console', (message) => {
            if (['error', 'warning'].includes(message.type()) && !/GPU stall|GL Driver/.test(message.text()))
                complaints.push(message.text());
        });
        page.on('pageerror', (error) => complaints.push(error.message));
        page.on('request', (request) => {
            if (!/^(data|blob):/.test(request.url())) requests.push(request.url());
        });
        const address = pathToFileURL(file).href;
        await page.goto(address);
        await page.waitForFunction(() => performance.getEntriesByName('first-picture').length > 0);
        await use(page);
        assert.deepEqual(complaints, []);
        assert.deepEqual(requests, [address]);
    });

export const withoutScripts = (file, use) =>
    inPage([], { javaScriptEnabled: false }, async (page) => {
        await page.goto(pathToFileURL(file).href);
        await use(page);
    });

// Waits three frames: within two of them a change of the state or of the pointer is followed.
export const followed = (page) =>
    page.evaluate(async () => {
        const frame = () => new Promise((drawn) => requestAnimationFrame(drawn));
        for (let i = 0; i < 3; ++i) await frame();
    });

// Waits until what was done is drawn: a change keeps the canvas busy until its picture rests.
export async function rested(page) {
    await followed(page);
    await page.waitForFunction(() => document.querySelector('canvas.envelope').ariaBusy !== 'true');
}

// The place of the canvas on the page.
export async function canvasBox(page) {
    const box = await page.locator('canvas.envelope').boundingBox();
    return { ...box, centre: [box.x + box.width / 2, box.y + box.height / 2] };
}

// The canvas as `columns` x `rows` mean colours, three numbers each.
export async function thumbnail(page, columns = 24, rows = 18) {
    await rested(page);
    return page.evaluate(
        ([width, height]) => {
            const source = document.querySelector('canvas.envelope');
            const canvas = Object.assign(document.createElement('canvas'), { width: 8 * width, height: 8 * height });
            const context = canvas.getContext('2d', { willReadFrequently: true });
            context.fillStyle = '#fff';
            context.fillRect(0, 0, canvas.width, canvas.height);
            // The full height, centred, because the width depends on the fonts.
            const share = (canvas.width / canvas.height) * source.height;
            context.drawImage(
                source,
                (source.width - share) / 2,
                0,
                share,
                source.height,
                0,
                0,
                canvas.width,
                canvas.height,
            );
            const colours = [];
            for (let y = 0; y < height; ++y)
                for (let x = 0; x < width; ++x) {
                    const { data } = context.getImageData(8 * x, 8 * y, 8, 8);
                    for (let k = 0; k < 3; ++k) {
                        let sum = 0;
                        for (let i = k; i < data.length; i += 4) sum += data[i];
                        colours.push(Math.round(sum / 64));
                    }
                }
            return colours;
        },
        [columns, rows],
    );
}

export const meanDifference = (one, other) =>
    one.reduce((sum, value, i) => sum + Math.abs(value - other[i]), 0) / one.length;

// The difference of two pictures: the mean of the 5 % of cells that differ most, of 255.
export function farthestApart(one, other) {
    const cells = [];
    for (let i = 0; i < one.length; i += 3)
        cells.push(Math.max(...[0, 1, 2].map((k) => Math.abs(one[i + k] - other[i + k]))));
    const worst = cells.toSorted((a, b) => b - a).slice(0, Math.ceil(cells.length / 20));
    return worst.reduce((sum, value) => sum + value, 0) / worst.length;
}

// Gives the picture a fixed size, whatever the fonts. Call it before anything rotates the picture.
export async function fixSize(page) {
    await page.addStyleTag({ content: '.holder { flex: none !important; width: 640px; height: 480px; }' });
    await rested(page);
    await page.getByRole('button', { name: 'Whole envelope' }).click();
}

export const fixedPicture = (page) => thumbnail(page, 32, 24);

// Whether the picture matches the golden one. Runs differ by less than 0.1; the most similar other map of a good
// envelope, whose colours are all pale, differs by 1.6. The tests' limit lies between.
export const mostApart = 0.6;

export async function assertLooksAs(page, name) {
    const now = await fixedPicture(page);
    const file = join(golden, `${name}.json`);
    if (process.env.RENEW) writeFileSync(file, JSON.stringify(now) + '\n');
    assert.ok(existsSync(file), `no golden picture ${name}; RENEW=1 writes it`);
    const apart = farthestApart(now, JSON.parse(readFileSync(file, 'utf8')));
    assert.ok(apart < mostApart, `the picture ${name} is ${apart.toFixed(2)} of 255 apart where it is most so`);
}

// Requires that axe-core finds no violation on the whole page.
export async function assertAccessible(page) {
    await page.evaluate(axe);
    const violations = await page.evaluate(async () =>
        (await window.axe.run()).violations.map(
            (violation) => `${violation.id}: ${violation.nodes.map((node) => node.html.slice(0, 120)).join(' | ')}`,
        ),
    );
    assert.deepEqual(violations, []);
}

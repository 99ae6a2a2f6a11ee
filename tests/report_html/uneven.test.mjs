// A seam with edges of 100 and 900 mm on one side: the page colours each by its place along the seam, as C++ does.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { opened } from './browser.mjs';
import { reports } from './reports.mjs';

const file = reports.uneven();
const options = { skip: file ? false : 'the program was built without the page' };

// An independent version of the palette: from white over light to full orange at 1.
function orange(share) {
    const stops = [
        [0xf7, 0xf5, 0xef],
        [0xf6, 0xb2, 0x6b],
        [0xe0, 0x6c, 0x00],
    ];
    const i = Math.min(1, Math.floor(2 * share));
    return stops[i].map((low, k) => low + (2 * share - i) * (stops[i + 1][k] - low));
}

test('colours the edges of a seam by their lengths', options, () =>
    opened(file, async (page) => {
        const [seam] = JSON.parse(readFileSync(join(dirname(file), 'report.json'), 'utf8')).seams;
        const notches = [{ at_mm: 0, drift_mm: 0 }, ...seam.notches];
        const driftAt = (at) => {
            const i = notches.findLastIndex((notch) => notch.at_mm <= at);
            const [one, next] = [notches[i], notches[i + 1]];
            return one.drift_mm + ((at - one.at_mm) / (next.at_mm - one.at_mm)) * (next.drift_mm - one.drift_mm);
        };
        await page.getByLabel('Colours show').selectOption({ label: 'Seam mismatch' });
        await page.getByRole('button', { name: 'to what is there' }).click();
        const [, end] = (await page.locator('.legend').innerText()).match(/\+(\d+) mm/);
        await page.locator('[role=option]', { hasText: seam.tile_a }).click();
        const painted = await page
            .locator('.panel .piece .rim')
            .evaluateAll((paths) => paths.map((path) => path.getAttribute('stroke').match(/\d+/g).map(Number)));
        assert.equal(painted.length, 3, 'two sewn edges, and those that are not');
        for (const middle of [50, 550]) {
            const expected = orange(-driftAt(middle) / Number(end));
            const apart = painted.map((colour) => Math.max(...colour.map((value, k) => Math.abs(value - expected[k]))));
            assert.ok(Math.min(...apart) < 2.5, `${middle} mm along the seam: ${expected} is none of ${painted.join(' | ')}`);
        }
    }),
);

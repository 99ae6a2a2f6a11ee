// The report of a designed balloon: searching, selecting, colours, and moving through it with the keys.
import assert from 'node:assert/strict';
import { readFileSync, statSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import {
    assertAccessible,
    assertLooksAs,
    canvasBox,
    farthestApart,
    fixedPicture,
    fixSize,
    followed,
    meanDifference,
    mostApart,
    opened,
    rested,
    thumbnail,
} from './browser.mjs';
import { reports } from './reports.mjs';

const file = reports.designed();
const options = { skip: file ? false : 'the program was built without the page' };
const heading = (page) => page.locator('.panel h2').innerText();

test('says at the top that it can be made, and how soon and smoothly it is shown', options, () =>
    opened(file, async (page) => {
        assert.match(
            await page.locator('h1').innerText(),
            /^Manufacturable\. All 360 tiles can be made, and all 696 seams fit\.$/,
        );
        assert.match(await page.title(), /balloon\.obj/);
        const first = await page.evaluate(() => performance.getEntriesByName('first-picture')[0].startTime);
        const {
            centre: [x, y],
        } = await canvasBox(page);
        const counting = page.evaluate(
            () =>
                new Promise((done) => {
                    const start = performance.now();
                    let frames = 0;
                    const step = () =>
                        ++frames && performance.now() - start < 3000
                            ? requestAnimationFrame(step)
                            : done((1000 * frames) / (performance.now() - start));
                    requestAnimationFrame(step);
                }),
        );
        await page.mouse.move(x, y);
        await page.mouse.down();
        for (let i = 0; i < 180; ++i) {
            await page.mouse.move(x + 1.5 * i, y + 10 * Math.sin(i / 10));
            await page.waitForTimeout(8);
        }
        await page.mouse.up();
        const rate = await counting;
        // Wide limits, far from the measured values: they distinguish a page that hangs from a slow one.
        assert.ok(first < 10000, `first picture after ${first.toFixed(0)} ms`);
        assert.ok(rate > 2, `${rate.toFixed(1)} frames/s`);
        console.log(
            `report.html: ${(statSync(file).size / 1e6).toFixed(2)} MB; first picture after ${(first / 1000).toFixed(2)} s; ${rate.toFixed(0)} frames/s while turning`,
        );
    }),
);

test('shows the piece of a tile that is clicked in space', options, () =>
    opened(file, async (page) => {
        const { centre, height } = await canvasBox(page);
        let name = '';
        for (const away of [0, 0.05, 0.1, 0.15]) {
            // not on a seam
            await page.mouse.click(centre[0] + (0.05 + away / 2) * height, centre[1] + away * height);
            name = await heading(page);
            if (/^G\d\dP\d\d/.test(name)) break;
        }
        assert.match(name, /^G\d\dP\d\d\s*can be made/);
        assert.equal(await page.locator('[role=option][aria-selected=true]').innerText(), name.match(/^G\d\dP\d\d/)[0]);
        for (const part of ['.cut', '.sew', '.notches', '.grain', 'image', 'text'])
            assert.ok((await page.locator(`.panel svg.piece ${part}`).count()) > 0, part);
        assert.match(await page.locator('.panel .figures').innerText(), /Warp strain/);
        assert.equal(await page.locator('.panel .edges li').count(), 4);
    }),
);

test('lights up both mates of a seam that is clicked', options, () =>
    opened(file, async (page) => {
        const { centre, width } = await canvasBox(page);
        const tip = page.locator('.tip');
        let found = false;
        for (let dx = 0; dx < width / 4 && !found; dx += 4) {
            await page.mouse.move(centre[0] + dx, centre[1] + 9);
            await followed(page);
            found = (await tip.innerText()).includes('Seam');
            if (found) await page.mouse.click(centre[0] + dx, centre[1] + 9);
        }
        assert.ok(found, 'a seam lies somewhere to the right');
        assert.match(await heading(page), /^Seam S\d+\s*fits/);
        assert.equal(await page.locator('.mates svg.piece').count(), 2);
        assert.equal(await page.locator('.mates .seam-chosen').count(), 2);
        const figures = await page.locator('.panel .figures').innerText();
        assert.match(figures, /As drawn\s+[\d.]+\smm/);
        assert.match(figures, /Mismatch\s+0\.00\smm/);
    }),
);

test('tells strain where the pointer is', options, () =>
    opened(file, async (page) => {
        const { centre } = await canvasBox(page);
        await page.mouse.move(centre[0] + 5, centre[1] + 5);
        await followed(page);
        assert.match(await page.locator('.tip').innerText(), /G\d\dP\d\d[^]*warp [+−]?\d+\.\d\d\s%[^]*shear/);
    }),
);

// The distance of a picture's colours from grey, of 255.
function colourfulness(colours) {
    let sum = 0;
    for (let i = 0; i < colours.length; i += 3) {
        const pixel = colours.slice(i, i + 3);
        sum += Math.max(...pixel) - Math.min(...pixel);
    }
    return (3 * sum) / colours.length;
}

test('opens on colours scaled to what there is, the worst tile chosen; the tolerance is a click away', options, () =>
    opened(file, async (page) => {
        const [, end] = (await page.locator('.legend').innerText()).match(/\+(0\.\d+) %[^]*at most 0\.\d+ %; 2 % allowed/);
        assert.ok(Number(end) < 0.2, end);
        const there = await thumbnail(page);
        const name = (await heading(page)).match(/^G\d\dP\d\d/)[0];
        assert.equal(await page.locator('[role=option][aria-selected=true]').innerText(), name);
        const { tiles } = JSON.parse(readFileSync(join(dirname(file), 'report.json'), 'utf8'));
        const strainOf = ({ strain }) => Math.max(-strain.warp_min_pct, strain.warp_max_pct);
        const most = Math.max(...tiles.map(strainOf));
        assert.ok(strainOf(tiles.find((tile) => tile.name === name)) > 0.999 * most, name);
        const button = (label) => page.getByRole('button', { name: label });
        assert.equal(await button('to what is there').getAttribute('aria-pressed'), 'true');
        await button('to tolerance').click();
        assert.equal(await button('to what is there').getAttribute('aria-pressed'), 'false');
        const tolerance = await thumbnail(page);
        assert.ok(colourfulness(there) > 1.5 * colourfulness(tolerance), `${colourfulness(there)}: there is something to see`);
        await page.getByLabel('Colours show').selectOption({ label: 'Area' });
        assert.match(await page.locator('.legend').innerText(), /−1 %[^]*\+1 %/, 'and what was clicked stays');
    }),
);

test('changes its colours with the map, pinned to the tolerance', options, () =>
    opened(file, async (page) => {
        const warp = await thumbnail(page);
        await page.getByRole('button', { name: 'to tolerance' }).click();
        assert.match(
            await page.locator('.legend').innerText(),
            /Strain along the warp[^]*beyond[^]*−2 %[^]*0[^]*\+2 %[^]*beyond/,
        );
        await page.getByLabel('Colours show').selectOption({ label: 'Tension along the seams' });
        assert.match(await page.locator('.legend').innerText(), /Tension along the seams[^]*−\d+ N[^]*\+\d+ N/);
        const tension = await thumbnail(page);
        assert.ok(meanDifference(warp, tension) > 1.5, 'the bands along the seams show');
        await page.getByLabel('Palette').selectOption({ index: 1 });
        assert.ok(meanDifference(tension, await thumbnail(page)) > 3, 'and so do other colours');
    }),
);

test('would not be taken for another map, a turned envelope or one with a tile chosen', options, () =>
    opened(file, async (page) => {
        await fixSize(page);
        const first = await fixedPicture(page);
        const differs = async (what) => {
            const apart = farthestApart(first, await fixedPicture(page));
            assert.ok(apart > 1.5 * mostApart, `${what}: ${apart.toFixed(2)} of 255 apart`);
        };
        const maps = page.getByLabel('Colours show');
        const names = await maps.locator('option').allInnerTexts();
        assert.ok(names.length >= 6);
        for (const label of names.slice(1)) {
            await maps.selectOption({ label });
            await differs(label);
        }
        await maps.selectOption({ label: names[0] });
        assert.ok(farthestApart(first, await fixedPicture(page)) < 0.1, 'the same again is the same');
        await page.locator('canvas.envelope').focus();
        await page.keyboard.press('Shift+ArrowLeft');
        await differs('turned by a step');
        await page.keyboard.press('Home');
        await page.keyboard.press('ArrowRight');
        await differs('a tile chosen');
    }),
);

test('looks as it did', options, () =>
    opened(file, async (page) => {
        await fixSize(page);
        await assertLooksAs(page, 'designed');
        await page.getByLabel('Palette').selectOption({ index: 1 });
        await assertLooksAs(page, 'designed-rainbow');
    }),
);

test('finds a tile by its name', options, () =>
    opened(file, async (page) => {
        await page.getByRole('searchbox').fill('g07p0');
        assert.equal(await page.locator('[role=option]').count(), 9);
        assert.equal(await page.locator('#tiles tbody tr').count(), 9);
        await page.getByRole('searchbox').press('Enter');
        assert.match(await heading(page), /^G07P01/);
    }),
);

test('tells where else the searched is found', options, () =>
    opened(file, async (page) => {
        await page.getByRole('searchbox').fill('S0007');
        assert.equal(await page.locator('.list .nothing').innerText(), 'None is called “s0007”');
        assert.match(await page.locator('#tiles h2').innerText(), /0 of 360 tiles/);
        assert.match(await page.locator('#seams h2').innerText(), /1 of 696 seams/);
        await page.getByRole('button', { name: '1 seam', exact: true }).click();
        assert.match(await page.locator('.list [role=option]').innerText(), /^S0007/);
    }),
);

test('scrolls with the wheel, and zooms a picture that was clicked', options, () =>
    opened(file, async (page) => {
        const { centre } = await canvasBox(page);
        const before = await thumbnail(page);
        await page.mouse.move(...centre);
        await page.mouse.wheel(0, 150);
        await page.waitForFunction(() => window.scrollY === 150);
        await page.evaluate(() => window.scrollTo(0, 0));
        assert.ok(meanDifference(before, await thumbnail(page)) < 0.1, 'the picture is as it was');
        await page.mouse.click(...centre);
        await page.mouse.wheel(0, -150);
        assert.ok(meanDifference(before, await thumbnail(page)) > 0.5, 'it is nearer');
        assert.equal(await page.evaluate(() => window.scrollY), 0);
    }),
);

test('zooms a piece by its buttons and keys', options, () =>
    opened(file, async (page) => {
        await page.locator('[role=option]').nth(4).click();
        const piece = page.locator('.panel svg.piece');
        const width = async () => Number((await piece.getAttribute('viewBox')).split(' ')[2]);
        const whole = await width();
        await page.getByRole('button', { name: /Zoom in/ }).click();
        const nearer = await width();
        assert.ok(nearer < whole);
        await piece.focus();
        await page.keyboard.press('+');
        assert.ok((await width()) < nearer);
        await page.keyboard.press('Home');
        assert.equal(await width(), whole);
    }),
);

test('is walked with the keys, in the order of the page', options, () =>
    opened(file, async (page) => {
        const stops = [];
        for (let i = 0; i < 12; ++i) {
            await page.keyboard.press('Tab');
            stops.push(
                await page.evaluate(() => {
                    const at = document.activeElement;
                    const style = getComputedStyle(at);
                    return {
                        at: at.getAttribute('aria-label') ?? at.textContent.trim() ?? at.tagName,
                        tag: at.tagName,
                        seen: style.outlineStyle !== 'none' && parseFloat(style.outlineWidth) >= 2,
                    };
                }),
            );
        }
        assert.deepEqual(
            stops.map((stop) => stop.tag),
            [
                ...['INPUT', 'BUTTON', 'BUTTON', 'UL', 'SELECT', 'BUTTON', 'BUTTON', 'SELECT'],
                ...['BUTTON', 'BUTTON', 'CANVAS', 'SECTION'],
            ],
        );
        assert.ok(
            stops.every((stop) => stop.seen),
            'where the focus is can be seen',
        );
        await page.getByRole('button', { name: 'Choose nothing' }).click();
        await page.locator('[role=listbox]').focus();
        for (const key of ['ArrowDown', 'ArrowDown', 'ArrowDown', 'ArrowUp']) await page.keyboard.press(key);
        assert.match(await heading(page), /^G01P02/);
        await page.locator('canvas.envelope').focus();
        await page.keyboard.press('ArrowRight');
        assert.match(await heading(page), /^G01P03/);
        assert.match(await page.locator('[role=status]').innerText(), /^Tile G01P03, can be made/);
        const before = await thumbnail(page);
        for (let i = 0; i < 3; ++i) await page.keyboard.press('Shift+ArrowLeft');
        assert.ok(meanDifference(before, await thumbnail(page)) > 0.5, 'it turns');
        await page.keyboard.press('Escape');
        assert.match(await heading(page), /^Choose a tile/);
    }),
);

test('sorts its tables', options, () =>
    opened(file, async (page) => {
        await page.locator('#tiles').getByRole('button', { name: 'Area m²' }).click();
        const areas = (await page.locator('#tiles tbody tr td:nth-child(4)').allInnerTexts()).map(Number);
        assert.equal(areas.length, 100);
        assert.deepEqual(
            areas,
            areas.toSorted((one, other) => other - one),
        );
        await page.locator('#tiles').getByRole('button', { name: 'Show all 360' }).click();
        assert.equal(await page.locator('#tiles tbody tr').count(), 360);
    }),
);

test('passes axe-core with nothing, a tile and a seam chosen', options, () =>
    opened(file, async (page) => {
        await assertAccessible(page);
        await page.getByRole('button', { name: 'Choose nothing' }).click();
        await assertAccessible(page);
        await page.locator('[role=option]').nth(4).click();
        await assertAccessible(page);
        await page.locator('.panel .edges .link').first().click();
        await rested(page);
        await assertAccessible(page);
    }),
);

test('fits a narrow screen', options, () =>
    opened(
        file,
        async (page) => {
            const wide = await page.evaluate(() => document.documentElement.scrollWidth);
            assert.ok(wide <= 390, `${wide} px wide`);
            const [high, content] = await page.evaluate(() => [
                document.documentElement.scrollHeight,
                document.getElementById('page').offsetHeight,
            ]);
            assert.ok(high <= content + 1, `${high} px high, and ${content} of it are used`);
            await assertAccessible(page);
            await page.locator('[role=option]').nth(3).click();
            const top = await page.locator('.panel h2').evaluate((head) => head.getBoundingClientRect().top);
            assert.ok(top < 844 - 40, `what was tapped is shown at ${top} px`);
        },
        { viewport: { width: 390, height: 844 } },
    ),
);

// The report of an inflated envelope: the slider from drawn to inflated, colours, figures, and on paper.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { assertAccessible, followed, meanDifference, opened, rested, thumbnail, withoutWebGL } from './browser.mjs';
import { reports } from './reports.mjs';

const file = reports.inflated(),
    bare = reports.designed();
const options = { skip: file ? false : 'the program was built without the page' };
const said = file ? JSON.parse(readFileSync(join(dirname(file), 'report.json'), 'utf8')).inflated : null;
const words = (page) => page.locator('.pose-words').innerText();
const colours = (page, label) => page.getByLabel('Colours show').selectOption({ label });
const legend = (page) => page.locator('.legend').innerText();

// Drags the slider's thumb, wherever it is, to a share of the way.
async function drag(page, from, to) {
    const box = await page.locator('#pose').boundingBox();
    const at = (share) => box.x + 8 + share * (box.width - 16); // the thumb is 16 px wide
    await page.mouse.move(at(from), box.y + box.height / 2);
    await page.mouse.down();
    for (let i = 1; i <= 12; ++i) await page.mouse.move(at(from + ((to - from) * i) / 12), box.y + box.height / 2);
    await page.mouse.up();
    await rested(page);
}

test('goes from inflated to drawn and back with the slider', options, () =>
    opened(file, async (page) => {
        assert.equal(await words(page), 'Shown as inflated');
        assert.match(await legend(page), /^Off the drawn shape/);
        await page.getByLabel('Palette').selectOption({ index: 1 });
        const inflated = await thumbnail(page);
        await drag(page, 1, 0);
        assert.equal(await page.locator('#pose').inputValue(), '0');
        assert.equal(await page.locator('.pose-words').textContent(), '');
        const drawn = await thumbnail(page);
        assert.ok(meanDifference(inflated, drawn) > 0.5, `it moves: ${meanDifference(inflated, drawn)}`);
        await drag(page, 0, 0.5);
        assert.match(await words(page), /^Shown (49|50|51) % of the way from drawn to inflated$/);
        const between = await thumbnail(page);
        assert.ok(meanDifference(between, drawn) < meanDifference(inflated, drawn), 'half the way');
        await drag(page, 0.5, 1);
        assert.ok(meanDifference(inflated, await thumbnail(page)) < 0.1, 'and back to the same picture');
        await page.getByLabel('Differences').selectOption('20');
        assert.equal(await words(page), 'Shown as inflated, what differs enlarged 20 times');
        assert.ok(meanDifference(inflated, await thumbnail(page)) > 4 * meanDifference(inflated, drawn));
    }),
);

test('moves the slider with the keys, and says where it is', options, () =>
    opened(file, async (page) => {
        const slider = page.getByRole('slider', { name: 'From drawn to inflated' });
        await slider.focus();
        await page.keyboard.press('Home');
        assert.equal(await slider.getAttribute('aria-valuetext'), 'as drawn');
        for (let i = 0; i < 3; ++i) await page.keyboard.press('ArrowRight');
        assert.equal(await slider.getAttribute('aria-valuetext'), 'Shown 3 % of the way from drawn to inflated');
        await page.keyboard.press('End');
        assert.equal(await slider.getAttribute('aria-valuetext'), 'Shown as inflated');
    }),
);

test('finds what is clicked where it is shown', options, () =>
    opened(file, async (page) => {
        await page.getByLabel('Differences').selectOption('5');
        await rested(page);
        const box = await page.locator('canvas.envelope').boundingBox();
        await page.mouse.move(box.x + 0.53 * box.width, box.y + 0.45 * box.height);
        await followed(page);
        assert.match(
            await page.locator('.tip').innerText(),
            /in flight [+−]?[\d.]+\smm off, [\d.]+\sN\/m, (taut|wrinkled|slack)/,
        );
        await page.mouse.click(box.x + 0.53 * box.width, box.y + 0.45 * box.height);
        assert.match(await page.locator('.panel h2').innerText(), /^(G\d\dP\d\d|Seam S)/);
    }),
);

// The allowed values, by hand: 10 kN/m x 0.2 / (1.4 x 5) for the cloth, 10 kN x 0.5 / (1.4 x 5) for the tapes.
test('colours deviation, tension, stress, wrinkles and tapes', options, () =>
    opened(file, async (page) => {
        await page.getByRole('button', { name: 'to tolerance' }).click();
        const limit = +said.deviation_limit_mm.toPrecision(4);
        assert.ok((await legend(page)).includes(`−${limit} mm`), 'pinned to 0.3 % of the height');
        const seen = [await thumbnail(page)];
        const usable = 'allowed: the usable strength divided by the required factor';
        for (const [label, text] of [
            ['Tension of the cloth', new RegExp(String.raw`0\s+285\.7 N/m[^]*beyond[^]*` + usable)],
            ['Stress along the warp', /\d N\/m/],
            ['Stress along the weft', /\d N\/m/],
            ['Shear stress', /\d N\/m/],
            ['Weft in flight', /−2 %[^]*the limit of the fabric/],
            ['Shear in flight', /−\d+°[^]*the limit of the fabric/],
            ['Wrinkles', /taut\s+wrinkled\s+slack[^]*% of the cloth is wrinkled/],
            ['Force in the load tapes', new RegExp(String.raw`714\.3 N\s[^]*beyond[^]*` + usable)],
        ]) {
            await colours(page, label);
            assert.match(await legend(page), text);
            const now = await thumbnail(page);
            for (const before of seen) assert.ok(meanDifference(now, before) > 1, `${label} is a picture of its own`);
            seen.push(now);
            await page.locator('[role=option]').first().click();
            assert.equal(await page.locator('.panel svg.piece image').count(), 1, 'on the piece too');
            await page.getByRole('button', { name: 'Choose nothing' }).click();
            await page.getByRole('button', { name: 'Whole envelope' }).click();
        }
    }),
);

test('says what it comes to, in words and tables', options, () =>
    opened(file, async (page) => {
        const header = await page.locator('.verdict').innerText();
        assert.equal(header.includes('It does not fly as drawn.'), said.deviation_rms_mm > said.deviation_limit_mm);
        assert.equal(header.includes('It is too weak.'), !said.safe && said.deviation_rms_mm <= said.deviation_limit_mm);
        assert.ok(header.includes(said.says[0]), header);
        const section = await page.locator('#flight').innerText();
        for (const sentence of said.says) assert.ok(section.includes(sentence), sentence);
        assert.match(section, /Height\s+[\d\s]+\smm\s+[\d\s]+\smm\s+[+−]\d+\smm\s+[+−][\d.]+\s%/);
        assert.match(section, /The shape: gas pressure cannot hold it\s+[\d.]+\smm/);
        assert.match(section, /load tapes[^]*10\s?000\sN\s+50\s%[^]*seam S\d+/);
        const weak = page.locator('#flight tr.fails th', { hasText: 'cloth, too weak' });
        assert.equal(await weak.count(), said.safety[0].ok ? 0 : 1);
        await page.locator('#flight .figures .link').click();
        assert.ok((await page.locator('.panel h2').innerText()).startsWith(said.stress_max_tile));
        assert.match(await page.locator('.panel').innerText(), /In flight[^]*Off the drawn shape[^]*Wrinkled/);
        await page.getByRole('button', { name: 'Tape cut mm' }).click();
        await page.locator('#seams tbody .link').first().click();
        assert.match(await page.locator('.panel').innerText(), /Load tape, cut\s+[\d.\s]+mm[^]*up to \d+\sN/);
    }),
);

test('passes axe-core, and fits a narrow screen', options, async () => {
    await opened(file, async (page) => {
        await assertAccessible(page);
        await page.locator('[role=option]').first().click();
        await colours(page, 'Wrinkles');
        await rested(page);
        await assertAccessible(page);
    });
    await opened(
        file,
        async (page) => {
            const wide = await page.evaluate(() => document.documentElement.scrollWidth);
            assert.ok(wide <= 390, `${wide} px wide`);
            await assertAccessible(page);
        },
        { viewport: { width: 390, height: 844 } },
    );
});

test('moves without WebGL too', options, () =>
    opened(
        file,
        async (page) => {
            const inflated = await thumbnail(page);
            await page.getByLabel('Differences').selectOption('20');
            assert.ok(meanDifference(inflated, await thumbnail(page)) > 1);
            await drag(page, 1, 0);
            await page.getByLabel('Differences').selectOption('1');
            assert.ok(meanDifference(inflated, await thumbnail(page)) > 0.3);
        },
        { flags: withoutWebGL },
    ),
);

test('is on paper with its figures and how it is shown', options, async (t) => {
    if (spawnSync('pdftotext', ['-v']).error) return t.skip('no pdftotext (Debian: poppler-utils)');
    await opened(file, async (page) => {
        await page.getByLabel('Differences').selectOption('5');
        await rested(page);
        const paper = join(process.env.RIPSTOP_WORK, 'inflated.pdf');
        writeFileSync(paper, await page.pdf({ preferCSSPageSize: true }));
        const text = spawnSync('pdftotext', ['-layout', paper, '-'], { encoding: 'utf8' }).stdout;
        for (const word of ['enlarged 5 times', 'Why it is off', 'Strength', 'Tape', 'Off the drawn shape'])
            assert.ok(text.includes(word), word);
        assert.ok(!text.includes('Differences'), 'without what only a screen can use');
        const images = spawnSync('pdfimages', ['-list', '-f', '1', '-l', '1', paper], { encoding: 'utf8' }).stdout;
        const [size, unit] = images.match(/ ([\d.]+)([KM])?B? +[\d.]+%$/m).slice(1);
        assert.ok(size * { K: 1e3, M: 1e6 }[unit] > 30000, `with the envelope, a blank sheet has 4 kB: ${images}`);
    });
});

test('has no slider where nothing was inflated', options, () =>
    opened(bare, async (page) => {
        assert.equal(await page.locator('#pose, #flight, .says, optgroup').count(), 0);
        assert.equal(await page.locator('.pose-words').textContent(), '');
    }),
);

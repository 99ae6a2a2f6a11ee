// Reports of a dress that cannot be made: the reasons, the tiles and seams, what to draw instead; and on paper.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { assertAccessible, assertLooksAs, fixSize, opened, thumbnail } from './browser.mjs';
import { reports } from './reports.mjs';

const dress = reports.dress(),
    unequal = reports.unequal();
const options = { skip: dress ? false : 'no dress to flatten, or built without the page' };
const heading = (page) => page.locator('.panel h2').innerText();

test('says why and what to redesign', options, () =>
    opened(dress, async (page) => {
        assert.match(
            await page.locator('h1').innerText(),
            /^Not manufacturable as drawn\. \d+ of 14 tiles cannot be made as drawn\.$/,
        );
        const why = await page.locator('.why').innerText();
        assert.match(why, /Why[^]*tiles: strain along the warp\. Worst panel_\d\d: [\d.]+\s%, allowed 2\s%/);
        assert.match(why, /What to redesign[^]*draw a seam (along|across) the warp/);
        assert.match(why, /tiles? (is|are) missing at[^]*--accept missing_tile/);
        for (const list of await page.locator('.why ul').all())
            assert.ok(await list.evaluate((box) => box.scrollHeight <= box.clientHeight + 1), 'every sentence is seen');
        const legend = await page.locator('.legend').boundingBox();
        assert.ok(legend.y + legend.height < 900, `and the colours with their numbers: ${legend.y + legend.height}`);
        await assertAccessible(page);
    }),
);

test('reaches a failing tile in one click and draws the proposed seam', options, () =>
    opened(dress, async (page) => {
        assert.equal(
            await page.locator('[role=option]').count(),
            await page.locator('[role=option] .mark.bad').count(),
            'those that fail are listed first',
        );
        await fixSize(page);
        await page.getByRole('button', { name: 'Next that fails' }).click();
        assert.match(await heading(page), /cannot be made as drawn/);
        assert.ok((await page.locator('.panel .findings li').count()) > 0);
        assert.ok((await page.locator('.panel .piece .ring').count()) > 0);
        assert.equal(await page.locator('.panel .piece .proposed').count(), 1);
        const box = await page.locator('.panel .piece .proposed').boundingBox(),
            piece = await page.locator('.panel .piece .cut').boundingBox();
        assert.ok(Math.max(box.width, box.height) > 0.3 * Math.min(piece.width, piece.height), 'it crosses the piece');
        assert.match(await page.locator('.proposal').innerText(), /helps most of \d+ tried/);
        await assertLooksAs(page, 'dress-tile');
        await assertAccessible(page);
    }),
);

test('follows a seam that does not fit', options, () =>
    opened(unequal, async (page) => {
        await fixSize(page);
        assert.match(await page.locator('h1').innerText(), /\d+ of 66 seams do not fit/);
        await page.locator('.why .link', { hasText: /^S\d+/ }).click();
        assert.match(await heading(page), /^Seam S\d+\s*does not fit/);
        assert.equal(await page.locator('.mates .seam-chosen').count(), 2);
        assert.equal(await page.locator('.drift polyline.bad').count(), 1);
        assert.match(await page.locator('.drift svg').textContent(), /[\d.]+\smmstart[\d.]+\smm/);
        const figures = await page.locator('.panel .figures').innerText();
        const [, mismatch] = figures.match(/Mismatch\s+([+−][\d.]+)\smm/);
        const [, first, second] = figures.match(
            /On panel_\d\d, edge \d+\s+([\d.]+)\smm[^]*On panel_\d\d, edge \d+\s+([\d.]+)\smm/,
        );
        // Each figure is rounded to 0.1 mm.
        assert.ok(Math.abs(Number(mismatch.replace('−', '-')) - (second - first)) < 0.11, figures);
        await page.locator('.panel .link').first().click();
        assert.match(await heading(page), /^panel_\d\d/);
        await page.getByLabel('Colours show').selectOption({ label: 'Seam mismatch' });
        await assertLooksAs(page, 'unequal-mismatch');
        await assertAccessible(page);
    }),
);

test('lists seams that fail alone', options, () =>
    opened(unequal, async (page) => {
        await page.getByRole('button', { name: /^Seams 66/ }).click();
        const failing = await page.locator('[role=option]').count();
        assert.ok(failing < 66);
        await page.locator('[role=option]', { hasText: 'panel_05 – panel_12' }).first().click();
        assert.equal(await page.locator('.mates .start').count(), 2, 'where it starts is marked on both');
        const scales = await page
            .locator('.mates svg.piece')
            .evaluateAll((pieces) => pieces.map((piece) => piece.getScreenCTM().a));
        // Browsers round widths to 1/64 of a pixel.
        assert.ok(Math.abs(scales[0] / scales[1] - 1) < 1e-3, 'both at one scale');
        await page.getByLabel('only those that fail').uncheck();
        assert.equal(await page.locator('[role=option]').count(), 66);
    }),
);

test('is a document on paper', options, async (t) => {
    if (spawnSync('pdftotext', ['-v']).error) return t.skip('no pdftotext (Debian: poppler-utils)');
    await opened(dress, async (page) => {
        const pdf = await page.pdf({ preferCSSPageSize: true });
        const file = join(process.env.RIPSTOP_WORK, 'dress.pdf');
        writeFileSync(file, pdf);
        const text = spawnSync('pdftotext', ['-layout', file, '-'], { encoding: 'utf8' }).stdout;
        assert.match(text, /Not manufacturable as drawn/);
        assert.match(text, /The pieces that fail/);
        for (const word of ['panel_13', 'S0066', 'What it was judged by', 'Strain along the warp'])
            assert.ok(text.includes(word), word);
        assert.ok(
            !text.includes('Search by name') && !text.includes('Next that fails'),
            'without what only a screen can use',
        );
        assert.ok(pdf.length > 100000, 'with its pictures');
    });
});

test('shows the pictures of a browser without WebGL', options, async () => {
    const { withoutWebGL } = await import('./browser.mjs');
    await opened(
        dress,
        async (page) => {
            assert.match(await page.locator('.hint').innerText(), /no WebGL/);
            const colours = await thumbnail(page);
            assert.ok(colours.filter((value) => value < 150).length > 60, 'there is a dress in the picture');
            const box = await page.locator('canvas.envelope').boundingBox();
            await page.mouse.click(box.x + box.width / 2, box.y + 0.6 * box.height);
            assert.match(await heading(page), /^(panel_\d\d|Seam S)/);
            assert.ok((await page.locator('.panel svg.piece').count()) > 0);
            await assertAccessible(page);
        },
        { flags: withoutWebGL },
    );
});

// Names are treated as text, whatever they contain.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { assertAccessible, opened } from './browser.mjs';
import { nested, reports } from './reports.mjs';

const names = [
    '</script><script>window.hacked=1</script><img src=x onerror=window.hacked=2>',
    'Bílý "dráček" & <b onclick=window.hacked=3>\'RIPSTOP_SHAPES\' ${1}',
];
const file = reports.hostile(names);

test(
    'shows names that are markup as they are and runs none of it',
    { skip: file ? false : 'the program was built without the page' },
    () =>
        opened(file, async (page) => {
            const options = page.locator('[role=option]');
            assert.equal(await options.count(), 2);
            for (const [i, name] of names.entries()) {
                await options.nth(i).click();
                assert.ok((await page.locator('.panel h2').innerText()).startsWith(name), name);
                assert.equal(
                    await page
                        .locator('[role=status]')
                        .innerText()
                        .then((text) => text.includes(name)),
                    true,
                );
            }
            await page.locator('.panel .edges .link').first().click();
            await page.mouse.move(700, 500);
            await page.getByRole('searchbox').fill('<img');
            assert.equal(await page.evaluate(() => window.hacked), undefined);
            assert.equal(await page.locator('img, [onclick], [onerror]').count(), 0);
            await assertAccessible(page);
        }),
);

test(
    'shows the roll once the pieces are laid, and a piece of it that is clicked',
    { skip: file ? false : 'the program was built without the page' },
    () =>
        opened(nested(file), async (page) => {
            assert.match(
                await page.locator('.roll-section').innerText(),
                /[\d.]+ m of cloth 1500 mm wide, [\d.]+ % of it used, 2 pieces/,
            );
            assert.equal(await page.locator('.roll .laid').count(), 2);
            await page.getByRole('button', { name: 'Choose nothing' }).click(); // what is chosen is drawn with a wide pen
            const [one, other] = await Promise.all([0, 1].map((i) => page.locator('.roll .laid').nth(i).boundingBox()));
            // The browser adds some pixels of the pen to the box.
            assert.ok(Math.abs(one.x - other.x) > 0.95 * one.width, 'beside each other');
            assert.ok(Math.abs(one.width / one.height - 1) < 0.02, 'squares');
            await page.locator('.roll .laid').first().click();
            const heading = await page.locator('.panel h2').innerText();
            assert.ok(
                names.some((name) => heading.startsWith(name)),
                heading,
            );
            assert.equal(await page.evaluate(() => window.hacked), undefined);
            assert.ok((await page.locator('.roll .laid.chosen').count()) > 0, 'it is lit on the roll');
            await page.locator('.roll .laid[tabindex="0"]').focus();
            await page.keyboard.press('ArrowRight');
            const label = await page.evaluate(() => document.activeElement.getAttribute('aria-label'));
            await page.keyboard.press('Enter');
            const shown = await page.locator('.panel h2').innerText();
            assert.ok(label.startsWith(shown.slice(0, 20)), `${label}: ${shown}`);
            await assertAccessible(page);
        }),
);

test(
    'is a summary in lines where scripts do not run',
    { skip: file ? false : 'the program was built without the page' },
    async () => {
        const { withoutScripts } = await import('./browser.mjs');
        await withoutScripts(file, async (page) => {
            const text = await page.locator('noscript pre').innerText();
            assert.ok(text.trim().split('\n').length > 2 && !text.includes('\ufffd'), text);
            assert.equal(await page.locator('.starting').isVisible(), false);
        });
    },
);

// Names are text, whatever they say.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { assertAccessible, opened } from './browser.mjs';
import { reports } from './reports.mjs';

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

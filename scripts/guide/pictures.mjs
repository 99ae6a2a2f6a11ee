// Takes the guide's pictures: opens the report in one browser and uses it as a maker does.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { pathToFileURL } from 'node:url';
import { join } from 'node:path';

const flags = [
    '--no-sandbox',
    '--no-first-run',
    '--disable-background-networking',
    '--use-angle=swiftshader',
    '--enable-unsafe-swiftshader',
];

const choose = async (page, name) => {
    await page.getByRole('searchbox').fill(name);
    await page.getByRole('searchbox').press('Enter');
    await page.getByRole('searchbox').fill('');
    await page.evaluate(() => document.activeElement.blur());
};
const whole = (page) => page.screenshot();
const part = (selector) => (page) => page.locator(selector).first().screenshot();

// The top of a part that continues below.
const cropped = (selector, height) => async (page) => {
    const box = await page.locator(selector).first().boundingBox();
    return page.screenshot({ clip: { ...box, height: Math.min(height, box.height) }, fullPage: true });
};

// The lines of a cut file are as thin as a blade; here they are a pixel or two.
const drawingStyle =
    '<style>body{margin:12px}svg{width:100%;height:596px}path{vector-effect:non-scaling-stroke;stroke-width:1.6}</style>';

// name: the file, the actions on it, the part to capture. Recipes for the same file follow one another and share
// one page.
const recipes = {
    report: { file: 'cut-plan/report.html', take: whole },
    roll: { file: 'cut-plan/report.html', take: cropped('.roll-section', 620) },
    tile: { file: 'cut-plan/report.html', use: (page) => choose(page, 'G01P10'), take: whole },
    piece: { file: 'cut-plan/report.html', take: part('.panel'), height: 960 },
    colours: {
        file: 'cut-plan/report.html',
        use: async (page) => {
            await page.getByRole('button', { name: 'Choose nothing' }).click();
            await page.getByRole('button', { name: 'Whole envelope' }).click();
            await page.getByLabel('Colours show').selectOption({ label: 'Shear between the threads' });
        },
        take: (page) => page.locator('.holder').locator('xpath=..').screenshot(),
    },
    failing: { file: 'wide-plan/report.html', take: part('.verdict') },
    proposal: {
        file: 'wide-plan/report.html',
        use: (page) => page.getByRole('button', { name: 'Next that fails' }).click(),
        take: whole,
    },
    mismatch: {
        file: 'by-lscm/report.html',
        use: (page) => page.locator('.why .link', { hasText: /^S\d+/ }).first().click(),
        take: part('.panel'),
        height: 910,
    },
    cutfile: { file: 'cut-plan/cut/tiles/G01P10.svg', take: whole, isDrawing: true },
};
export const pictureNames = Object.keys(recipes);

const showDrawing = (page, file) =>
    page.setContent(drawingStyle + readFileSync(file, 'utf8').replace(/^<\?xml.*\n/, ''));

async function showReport(page, file) {
    await page.goto(pathToFileURL(file).href);
    await page.waitForFunction(() => performance.getEntriesByName('first-picture').length > 0);
}

// One PNG picture for each name. `names` are those of recipes whose files are in the folder.
export async function takePictures(folder, names, executablePath) {
    const require = createRequire(new URL('../../apps/report/package.json', import.meta.url));
    const browser = await require('playwright-core').chromium.launch({ executablePath, headless: true, args: flags });
    const pictures = new Map();
    try {
        let page, shown;
        for (const [name, { file, use, take, isDrawing, height = 860 }] of Object.entries(recipes)) {
            if (!names.includes(name)) continue;
            if (file !== shown) {
                await page?.close();
                page = await browser.newPage({ viewport: { width: 1320, height }, reducedMotion: 'reduce' });
                await (isDrawing ? showDrawing : showReport)(page, join(folder, file));
                shown = file;
            }
            await page.setViewportSize(isDrawing ? { width: 1200, height: 620 } : { width: 1320, height });
            await use?.(page);
            await page.waitForTimeout(400);
            pictures.set(name, await take(page));
        }
    } finally {
        await browser.close();
    }
    return pictures;
}

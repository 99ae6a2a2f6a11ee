// Runs the guide: executes every command of docs/guide.md in order, in a new folder, takes the pictures, and
// writes OUT/guide.html, a single file that contains the pictures, and OUT/pictures/NAME.png.
//
//   node make.mjs [--check] PROGRAM OUT
//
// sh runs the lines of a fence `sh` one by one. After the word, a number is the exit code expected of every line
// (default 0); `norun` skips the fence; `rhino` skips it if openNURBS cannot write a Rhino file. A fence `text`
// right behind it is its output without progress. Without --check these fences are updated in docs/guide.md; with
// it, a different fence is an error. Exits with 77, which CTest counts as skipped, if the browser, the npm
// packages or the report page are missing.
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { delimiter, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { anchor, asHtml, blocksOf } from './markdown.mjs';
import { pictureNames, takePictures } from './pictures.mjs';
import { canWriteRhino, writeRhinoFile } from './rhino_file.mjs';

const root = fileURLToPath(new URL('../..', import.meta.url));
const source = join(root, 'docs/guide.md');
const args = process.argv.slice(2);
const isCheck = args[0] === '--check';
const [program, out] = args.slice(isCheck ? 1 : 0).map((path) => resolve(path));
const chromium = process.env.RIPSTOP_CHROMIUM ?? '/usr/bin/chromium';

function end(code, sentence) {
    (code === 0 || code === 77 ? console.log : console.error)(sentence);
    process.exit(code);
}
if (!existsSync(chromium))
    end(77, `skipped: no browser at ${chromium} (Debian: chromium); RIPSTOP_CHROMIUM names another`);
if (!existsSync(join(root, 'apps/report/node_modules/playwright-core')))
    end(77, 'skipped: no playwright-core; make setup installs it');

// The text as a terminal shows it, without what is erased there.
const withoutProgress = (text) =>
    text
        .split('\n')
        .filter((line) => !/^ *\d+ % done, |^(Reading|Writing|Checking) .* …$/.test(line))
        .join('\n')
        .trimEnd();

// Seconds, rounding noise, and the choice among equally bad tiles differ between machines.
const comparable = (text) =>
    text
        .replace(/\b\d+(\.\d+)? s\b/g, 'N s')
        .replace(/-?\b\d+(\.\d+)?e-\d+\b/g, 'ROUNDING')
        .replace(/^(.*worst: |       strain ).*$/gm, (line) => line.replace(/\((G\d+P\d+|S\d+)\)/g, '(ONE)'));

function run(folder, line, path) {
    const shell = spawnSync('sh', ['-c', `${line} 2>&1`], {
        cwd: folder,
        encoding: 'utf8',
        env: { ...process.env, PATH: path, NO_COLOR: '1', LC_ALL: 'C.UTF-8', CLICOLOR_FORCE: '' },
    });
    return { code: shell.status, text: shell.stdout };
}

// Runs every command block and returns its output; adds faults to `faults`.
function runAll(blocks, folder, faults) {
    const bin = join(folder, '.bin');
    mkdirSync(bin);
    symlinkSync(program, join(bin, 'ripstop'));
    const path = bin + delimiter + process.env.PATH;
    const printed = new Map();
    for (const [i, block] of blocks.entries()) {
        if (block.kind !== 'fence' || block.language !== 'sh' || block.words.includes('norun')) continue;
        if (block.words.includes('rhino')) {
            if (!canWriteRhino()) continue;
            for (const [name, mistakes] of Object.entries({ 'drawn.3dm': true, 'balloon.3dm': false }))
                if (!existsSync(join(folder, name)))
                    writeRhinoFile(join(folder, 'envelope.obj'), join(folder, name), { mistakes });
        }
        const expected = Number(block.words.find((word) => /^\d+$/.test(word)) ?? 0);
        let text = '';
        for (const line of block.lines.map((each) => each.replace(/ +#.*$/, '')).filter(Boolean)) {
            const result = run(folder, line, path);
            text += result.text;
            if (result.code !== expected)
                faults.push(
                    `docs/guide.md:${block.from}: \`${line}\` ended with ${result.code}, the guide says ${expected}:\n${result.text}`,
                );
        }
        const next = blocks[i + 1];
        if (next?.kind === 'fence' && next.language === 'text') printed.set(next, withoutProgress(text));
    }
    return printed;
}

// The first line that differs, in both versions.
function difference(block, text) {
    const now = comparable(text).split('\n'),
        told = comparable(block.lines.join('\n')).split('\n');
    const at = now.findIndex((line, i) => line !== told[i]);
    if (at < 0 && now.length === told.length) return null;
    const place = at < 0 ? now.length : at;
    return `docs/guide.md:${block.from + 1 + place}: the guide says\n    ${told[place] ?? '(nothing)'}\nthe program prints\n    ${now[place] ?? '(nothing)'}`;
}

// Replaces blocks from last to first, so that the numbers of earlier lines stay valid.
function replaced(text, printed) {
    const lines = text.split('\n');
    for (const [block, now] of [...printed].sort(([a], [b]) => b.from - a.from))
        if (difference(block, now)) lines.splice(block.from, block.to - block.from, ...now.split('\n'));
    return lines.join('\n');
}

const nameOf = (path) => path.match(/^\.\.\/build\/guide\/pictures\/([\w-]+)\.png$/)?.[1];
const pathsOf = (blocks) =>
    blocks.filter((block) => block.kind === 'picture').map((block) => block.lines.join(' ').match(/\(([^)]+)\)$/)[1]);

function page(blocks, pictures) {
    const style = readFileSync(new URL('./guide.css', import.meta.url), 'utf8');
    const chapters = blocks
        .filter((block) => block.kind === 'heading' && /^## /.test(block.lines[0]))
        .map((block) => block.lines[0].slice(3));
    const body = asHtml(blocks, {
        picture: (path) => `data:image/png;base64,${pictures.get(nameOf(path)).toString('base64')}`,
        // Other pages exist only beside the sources, wherever this file is read.
        link: (path, words) =>
            /^(https?:|#)/.test(path)
                ? `<a href="${path}">${words}</a>`
                : `${words} (<code>${join('docs', path)}</code> of the sources)`,
    });
    const contents = chapters.map((chapter) => `<li><a href="#${anchor(chapter)}">${chapter}</a></li>`).join('');
    return `<!doctype html>\n<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>A guide to Ripstop</title><style>${style}</style></head>\n<body><nav aria-label="Chapters"><ol>${contents}</ol></nav><main>\n${body}\n</main></body></html>\n`;
}

const folder = mkdtempSync(join(tmpdir(), 'ripstop-guide-'));
const faults = [];
try {
    const text = readFileSync(source, 'utf8');
    const printed = runAll(blocksOf(text), folder, faults);
    if (isCheck) for (const [block, now] of printed) faults.push(difference(block, now) ?? []);
    else writeFileSync(source, replaced(text, printed));
    if (!existsSync(join(folder, 'cut-plan/report.html')) && faults.flat().length === 0)
        end(77, 'skipped: the program was built without the page of the report');
    const blocks = blocksOf(readFileSync(source, 'utf8'));
    const names = pathsOf(blocks).map(nameOf);
    for (const name of names)
        if (!pictureNames.includes(name)) faults.push(`docs/guide.md shows a picture that nobody takes: ${name}`);
    for (const name of pictureNames)
        if (!names.includes(name)) faults.push(`the picture ${name} is taken and not shown`);
    if (faults.flat().length === 0) {
        const pictures = await takePictures(folder, names, chromium);
        mkdirSync(join(out, 'pictures'), { recursive: true });
        for (const [name, bytes] of pictures) writeFileSync(join(out, 'pictures', `${name}.png`), bytes);
        writeFileSync(join(out, 'guide.html'), page(blocks, pictures));
    }
} catch (error) {
    faults.push(error.stack);
} finally {
    rmSync(folder, { recursive: true, force: true });
}
const told = faults.flat();
if (told.length > 0) end(1, `${told.join('\n\n')}\n\n\`make guide\` writes docs/guide.md anew; look at what changed`);
end(0, join(out, 'guide.html'));

// The page's modules have no function of more than 80 lines.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';

const mostLines = 80;
const report = join(dirname(fileURLToPath(import.meta.url)), '../../apps/report');
const vite = createRequire(join(report, 'package.json')).resolve('vite/package.json');
const { parseAst } = await import(pathToFileURL(join(dirname(vite), 'dist/node/index.js')));

// Every function of a module, with its name if it has one and its number of lines, nested functions included.
function functionsOf(text) {
    const found = [];
    const walk = (node, name) => {
        if (Array.isArray(node)) return node.forEach((item) => walk(item, name));
        if (!node || typeof node.type !== 'string') return;
        if (/^(Arrow)?Function(Declaration|Expression)?$/.test(node.type))
            found.push({ name: node.id?.name ?? name, lines: text.slice(node.start, node.end).split('\n').length });
        const named = node.id?.name ?? node.key?.name;
        for (const value of Object.values(node)) if (value && typeof value === 'object') walk(value, named ?? name);
    };
    walk(parseAst(text), 'a module');
    return found;
}

test('finds functions of every kind and counts their lines', () => {
    const text = 'const a = () => {\n\n};\nclass B { c() {\n} }\nfunction d() { return function () {}; }';
    assert.deepEqual(functionsOf(text), [
        { name: 'a', lines: 3 },
        { name: 'c', lines: 2 },
        { name: 'd', lines: 1 },
        { name: 'd', lines: 1 },
    ]);
});

test('has no long function', () => {
    const source = join(report, 'src');
    const modules = readdirSync(source, { recursive: true }).filter((name) => name.endsWith('.js'));
    assert.ok(modules.length > 20, `${modules.length} modules`);
    const long = modules.flatMap((module) =>
        functionsOf(readFileSync(join(source, module), 'utf8'))
            .filter(({ lines }) => lines > mostLines)
            .map(({ name, lines }) => `${module}: ${name} has ${lines} lines`),
    );
    assert.deepEqual(long, []);
});

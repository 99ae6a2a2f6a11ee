// Parses the guide's Markdown into blocks and writes these as HTML: headings, paragraphs, lists, tables, fenced
// code, pictures, links, code and bold.
const fence = /^```(\S*) ?(.*)$/;

// The blocks of a text, in order: { kind, lines } with unchanged lines; fences also have { language, words, from,
// to }.
export function blocksOf(text) {
    const lines = text.split('\n'),
        blocks = [];
    const kindOf = (line) =>
        /^#/.test(line)
            ? 'heading'
            : /^\|/.test(line)
              ? 'table'
              : /^(-|\d+\.) /.test(line)
                ? 'list'
                : /^!\[/.test(line)
                  ? 'picture'
                  : 'text';
    for (let i = 0; i < lines.length; ++i) {
        if (lines[i].trim() === '') continue;
        const opening = lines[i].match(fence);
        const from = i + 1;
        if (opening) {
            while (++i < lines.length && lines[i] !== '```');
            const words = opening[2].split(' ').filter(Boolean);
            blocks.push({ kind: 'fence', language: opening[1], words, from, to: i, lines: lines.slice(from, i) });
            continue;
        }
        const kind = kindOf(lines[i]);
        while (kind !== 'heading' && i + 1 < lines.length && lines[i + 1].trim() !== '' && !fence.test(lines[i + 1]))
            ++i;
        blocks.push({ kind, lines: lines.slice(from - 1, i + 1) });
    }
    return blocks;
}

const escaped = (text) =>
    text.replace(/&/g, '&amp;').replace(/</g, '&lt;').replace(/>/g, '&gt;').replace(/"/g, '&quot;');
export const anchor = (heading) =>
    heading
        .toLowerCase()
        .replace(/[^\p{L}\p{N} -]/gu, '')
        .replace(/ /g, '-');

// Code comes first, so that nothing in it is taken for markup.
function inline(text, link) {
    return escaped(text)
        .split(/(`[^`]+`)/)
        .map((part) =>
            part.startsWith('`')
                ? `<code>${part.slice(1, -1)}</code>`
                : part
                      .replace(/\*\*([^*]+)\*\*/g, '<strong>$1</strong>')
                      .replace(/\*([^*]+)\*/g, '<em>$1</em>')
                      .replace(/\[([^\]]+)\]\(([^)]+)\)/g, (_, words, to) => link(to, words)),
        )
        .join('');
}

function list(lines, link) {
    const items = [];
    for (const line of lines) {
        const begun = line.match(/^(?:-|\d+\.) (.*)$/);
        if (begun) items.push(begun[1]);
        else items[items.length - 1] += ` ${line.trim()}`;
    }
    const tag = lines[0].startsWith('-') ? 'ul' : 'ol';
    return `<${tag}>${items.map((item) => `<li>${inline(item, link)}</li>`).join('')}</${tag}>`;
}

function table(lines, link) {
    const rows = lines.map((line) =>
        line
            .replace(/\\\|/g, '\u0001')
            .split('|')
            .slice(1, -1)
            .map((cell) => cell.trim().replace(/\u0001/g, '|')),
    );
    const row = (cells, tag) => `<tr>${cells.map((cell) => `<${tag}>${inline(cell, link)}</${tag}>`).join('')}</tr>`;
    return `<div class="wide" tabindex="0"><table><thead>${row(rows[0], 'th')}</thead><tbody>${rows
        .slice(2)
        .map((cells) => row(cells, 'td'))
        .join('')}</tbody></table></div>`;
}

// `picture(path)` and `link(path, words)` convert paths. Blocks that may be wider than the page can be scrolled by
// keyboard.
export function asHtml(blocks, { picture, link }) {
    const one = (block) => {
        const text = block.lines.join(' ');
        if (block.kind === 'fence')
            return `<pre tabindex="0" class="${block.language === 'sh' ? 'command' : 'output'}">${escaped(block.lines.join('\n'))}</pre>`;
        if (block.kind === 'table') return table(block.lines, link);
        if (block.kind === 'list') return list(block.lines, link);
        if (block.kind === 'picture') {
            const [, words, path] = text.match(/^!\[([^\]]*)\]\(([^)]+)\)$/);
            return `<figure><img src="${picture(path)}" alt="${escaped(words)}"><figcaption>${inline(words, link)}</figcaption></figure>`;
        }
        if (block.kind !== 'heading') return `<p>${inline(text, link)}</p>`;
        const [, marks, words] = text.match(/^(#+) (.*)$/);
        return `<h${marks.length} id="${anchor(words)}">${inline(words, link)}</h${marks.length}>`;
    };
    return blocks.map(one).join('\n');
}

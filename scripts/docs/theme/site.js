// Light or dark, search, and the place in the list of contents. Works from a folder: nothing is fetched.
const root = document.documentElement;
const base = document.body.dataset.base;

document.getElementById('theme').addEventListener('click', () => {
    const isDark = root.dataset.theme
        ? root.dataset.theme === 'dark'
        : matchMedia('(prefers-color-scheme: dark)').matches;
    root.dataset.theme = isDark ? 'light' : 'dark';
    try {
        localStorage.setItem('theme', root.dataset.theme);
    } catch {} // a browser that keeps nothing
});

const field = document.getElementById('search');
const found = document.getElementById('found');
let loading;

const loadIndex = () =>
    (loading ??= new Promise((done) => {
        const script = document.createElement('script');
        script.src = `${base}/search_index.js`;
        script.onload = done;
        document.head.append(script);
    }));

const words = (text) => text.toLowerCase().split(/[^\p{L}\p{N}_]+/u).filter(Boolean);

// The score of an entry, higher is better; 0 if a word does not occur in it.
function score(entry, asked) {
    const title = entry.title.toLowerCase();
    const text = entry.text.toLowerCase();
    let sum = title === asked.join(' ') || title === asked.join('_') ? 50 : 0;
    for (const word of asked) {
        const isWord = words(title).includes(word);
        const inTitle = isWord ? 20 : title.startsWith(word) ? 15 : title.includes(word) ? 8 : 0;
        const inText = text.includes(word) ? 2 : 0;
        if (inTitle + inText === 0) return 0;
        sum += inTitle + inText;
    }
    return sum - title.length / 100;
}

// The text around the first hit.
function snippet(text, word) {
    const plain = text.replace(/\s+/g, ' ');
    const at = Math.max(0, plain.toLowerCase().indexOf(word) - 40);
    return (at > 0 ? '… ' : '') + plain.slice(at, at + 140);
}

function item(entry, asked) {
    const line = document.createElement('li');
    const link = document.createElement('a');
    link.href = `${base}/${entry.at}`;
    link.textContent = entry.title;
    const small = document.createElement('small');
    small.textContent = `${entry.page}: ${snippet(entry.text, asked[0])}`;
    link.append(small);
    line.append(link);
    return line;
}

async function search() {
    const asked = words(field.value);
    found.hidden = asked.length === 0;
    if (found.hidden) return;
    await loadIndex();
    const best = window.searchIndex
        .map((entry) => ({ entry, score: score(entry, asked) }))
        .filter((each) => each.score > 0)
        .sort((a, b) => b.score - a.score)
        .slice(0, 20);
    found.replaceChildren(...best.map((each) => item(each.entry, asked)));
    if (best.length === 0) found.innerHTML = '<li class="none">Nothing found.</li>';
}

field.addEventListener('input', search);
field.addEventListener('focus', loadIndex);
field.addEventListener('keydown', (event) => {
    const links = [...found.querySelectorAll('a')];
    const at = links.findIndex((link) => link.classList.contains('chosen'));
    if (event.key === 'Escape') found.hidden = true;
    if (event.key === 'Enter') (links[at] ?? links[0])?.click();
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (!step || links.length === 0) return;
    event.preventDefault();
    links[at]?.classList.remove('chosen');
    const next = links[(at + step + links.length) % links.length];
    next.classList.add('chosen');
    next.scrollIntoView({ block: 'nearest' });
});
document.addEventListener('click', (event) => {
    if (!event.target.closest('.search') || event.target.closest('#found a')) found.hidden = true;
});
document.addEventListener('keydown', (event) => {
    if (event.key !== '/' || document.activeElement === field) return;
    event.preventDefault();
    field.focus();
});

// Marks the current heading in the list of contents and scrolls the chosen page into view.
const entries = new Map([...document.querySelectorAll('.contents a')].map((link) => [link.hash.slice(1), link]));
const headings = [...entries.keys()].map((id) => document.getElementById(decodeURIComponent(id))).filter(Boolean);
function mark() {
    const read = headings.filter((heading) => heading.getBoundingClientRect().top < 120).at(-1) ?? headings[0];
    for (const [id, link] of entries) {
        const isRead = read && id === read.id;
        if (isRead && !link.hasAttribute('aria-current')) {
            link.setAttribute('aria-current', 'true');
            link.scrollIntoView({ block: 'nearest' });
        } else if (!isRead) link.removeAttribute('aria-current');
    }
}
if (headings.length > 0) {
    addEventListener('scroll', mark, { passive: true });
    mark();
}
document.querySelector('.pages a[aria-current]')?.scrollIntoView({ block: 'nearest' });

// Makes blocks that are wider than the page scrollable by keyboard.
for (const block of document.querySelectorAll('pre, .wide, main > table'))
    if (block.scrollWidth > block.clientWidth) block.tabIndex = 0;

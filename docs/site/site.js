// What a page does besides its figures: light and dark, the menu on a phone, the search.
const $ = id => document.getElementById(id), root = document.documentElement, base = $('search').dataset.base, lang = root.lang;
$('theme').onclick = () => { root.dataset.theme = root.dataset.theme === 'dark' ? 'light' : 'dark'; try { localStorage.theme = root.dataset.theme; } catch { /* a page that may keep nothing */ } };
$('menu').onclick = () => $('menu').setAttribute('aria-expanded', document.body.classList.toggle('menu'));

/** Opened as a file, without a server, a page may import and fetch nothing: plain scripts have it all in them (folder.mjs). */
const in_folder = location.protocol === 'file:';
const plain = path => new Promise((onload, onerror) => document.head.append(Object.assign(document.createElement('script'), { src: base + path, onload, onerror })));
if (in_folder && document.querySelector('bounce-stage, bounce-figure')) plain('live/live.file.js');

/** What is too wide scrolls by itself; with the keyboard, too. */
const scrollable = () => document.querySelectorAll('pre, .table, .katex-display').forEach(box => { if (box.scrollWidth > box.clientWidth) box.tabIndex = 0; else box.removeAttribute('tabindex'); });
addEventListener('resize', scrollable);
document.fonts.ready.then(scrollable);

let index = null; // loaded when somebody wants to search
const load = async () => {
  if (in_folder) await plain(`assets/search.${lang}.file.js`);
  const { MiniSearch, searched, t, index } = in_folder ? bounceSearch : { ...await import('./minisearch.js').then(all => ({ MiniSearch: all.default })), ...await import('../live/language.js'),
    index: await fetch(`${base}assets/search.${lang}.json`).then(answer => answer.text()) };
  const all = MiniSearch.loadJSON(index, searched(lang));
  return { search: words => all.search(words, { prefix: true, fuzzy: 0.15, boost: { title: 3 } }).slice(0, 8), nothing: t('nothing', lang) };
};
$('search').onfocus = () => { index ??= load(); };
$('search').oninput = async () => {
  const words = $('search').value, { search, nothing } = await index, hits = words.trim() ? search(words) : [];
  if (words !== $('search').value) return; // typed on since
  const item = child => { const li = document.createElement('li'); li.append(child); return li; };
  $('found').replaceChildren(...hits.map(hit => item(Object.assign(document.createElement('a'), { href: base + hit.id, textContent: hit.title }))), ...(words.trim() && !hits.length ? [item(nothing)] : []));
};
document.onkeydown = event => {
  if (event.key === '/' && !/INPUT|TEXTAREA|SELECT|CANVAS/.test(event.target.tagName)) { event.preventDefault(); $('search').focus(); }
  if (event.key === 'Escape') $('found').replaceChildren();
};

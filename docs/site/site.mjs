// node site.mjs DOCS OUT [STAGES]: the pages of DOCS as a site, from the Markdown as it is; STAGES has what the preset `web` made.
// A page keeps its place: deeper/X.md becomes deeper/X.html, README.md index.html, and ja/X.md the Japanese X. Sources that
// lessons link to become pages, too, in code/. It fails on a bad formula, on a link or an anchor to nothing, on a bad marker.
//   <!-- live: 03_damping --set damping=18 -->                    a whole stage in place of the picture below (live/stage.js)
//   <!-- live: 03_damping slider=damping seconds=3 -->            a small figure (live/figure.js says what else it may have)
import { createRequire } from 'node:module';
import { readFileSync, writeFileSync, mkdirSync, cpSync, readdirSync, existsSync, statSync, rmSync } from 'node:fs';
import { basename, dirname, join, normalize, relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import MarkdownIt from 'markdown-it';
import anchor from 'markdown-it-anchor';
import katexInMarkdown from '@vscode/markdown-it-katex';
import hljs from 'highlight.js/lib/core';
import cpp from 'highlight.js/lib/languages/cpp';
import diff from 'highlight.js/lib/languages/diff';
import json from 'highlight.js/lib/languages/json';
import python from 'highlight.js/lib/languages/python';
import MiniSearch from 'minisearch';
import { liveTwin, searchTwin, stageTwin } from './folder.mjs';
import { searched, t } from './live/language.js';

const require = createRequire(import.meta.url);
const [docs, out, stages] = process.argv.slice(2).map(normalize), root = dirname(docs), here = dirname(fileURLToPath(import.meta.url));
const problems = [], read = path => readFileSync(path, 'utf8');
const write = (path, text) => { mkdirSync(dirname(join(out, path)), { recursive: true }); writeFileSync(join(out, path), text); };
rmSync(out, { recursive: true, force: true });

// ---- Markdown
Object.entries({ cpp, diff, json, python }).forEach(([name, language]) => hljs.registerLanguage(name, language));
const languages = { cpp: 'cpp', hpp: 'cpp', diff: 'diff', json: 'json', py: 'python' };
const highlight = (code, language) => languages[language] ? hljs.highlight(code, { language: languages[language] }).value : '';
const slug = text => text.trim().toLowerCase().replace(/[^\p{L}\p{N}\s_-]/gu, '').replace(/\s/g, '-'); // as GitHub does
const md = new MarkdownIt({ html: true, highlight }).use(katexInMarkdown.default ?? katexInMarkdown, { throwOnError: true, strict: 'error' })
  .use(anchor, { slugify: slug, permalink: anchor.permalink.headerLink() });
md.renderer.rules.table_open = () => '<div class="table"><table>';
md.renderer.rules.table_close = () => '</table></div>';

// ---- Which pages there are, and in which order
const folders = ['', 'deeper', 'ja', 'ja/deeper'].filter(folder => existsSync(join(docs, folder)));
const order = folder => { const all = readdirSync(join(docs, folder)).filter(f => f.endsWith('.md')).sort(); return [...all.filter(f => f === 'README.md'), ...all.filter(f => /^\d/.test(f)), ...all.filter(f => !/^\d|README/.test(f))]; };
const front = '../README.md'; // of the project: its Japanese is ja/start.md
const pages = [...existsSync(join(root, 'README.md')) ? [front] : [], ...folders.flatMap(folder => order(folder).map(f => join(folder, f)))];
const page = path => path === front ? 'start.html' : path.replace(/README\.md$/, 'index.html').replace(/\.md$/, '.html');
const title = path => read(join(docs, path)).match(/^# (.*)$/m)?.[1] ?? path;
const language = path => path.startsWith('ja/') ? 'ja' : 'en';
const twin = path => { const other = path === front ? 'ja/start.md' : path === 'ja/start.md' ? front : language(path) === 'ja' ? path.slice(3) : join('ja', path); return pages.includes(other) ? other : ''; };
const titles = new Map(pages.map(path => [path, title(path)])), ids = new Map(), wanted = [], sources = new Set(), search = { en: [], ja: [] };

/** The address in the site of what a page links to. */
function link(from, href) {
  if (/^[a-z]+:/.test(href)) return href;
  const [path, hash] = href.split('#'), file = path ? join(docs, dirname(from), path) : join(docs, from), target = relative(docs, file);
  const address = to => relative(dirname(page(from)), to) + (hash ? '#' + hash : '');
  if (pages.includes(target)) { if (hash) wanted.push([from, target, decodeURIComponent(hash)]); return path ? address(page(target)) : '#' + hash; }
  if (!existsSync(file)) { problems.push(`${from}: ${href} is not there`); return href; }
  if (!target.startsWith('..') && !statSync(file).isDirectory()) { cpSync(file, join(out, target)); return address(target); }
  sources.add(relative(root, file));
  return address(code(relative(root, file)));
}
const code = source => join('code', source, statSync(join(root, source)).isDirectory() ? 'index.html' : '') + (statSync(join(root, source)).isDirectory() ? '' : '.html');

/** `<!-- live: ... -->` as an element of its own, round the picture that follows it. Other comments are for the tests. */
function markers(from, tokens) {
  for (let i = 0; i < tokens.length; ++i) {
    if (tokens[i].type !== 'html_block' || !tokens[i].content.startsWith('<!--')) continue;
    const marker = tokens[i].content.match(/^<!-- live: (\w+)(.*) -->\s*$/);
    tokens[i].content = '';
    if (!marker) continue;
    const options = [], attributes = [];
    for (const [, option, value, key, quoted, plain] of marker[2].matchAll(/(--\S+)\s+(\S+)|(\w+)(?:="([^"]*)"|=(\S+))?/g)) {
      if (option) options.push(option, value); else attributes.push(`${key}="${md.utils.escapeHtml(quoted ?? plain?.replaceAll(',', ' ') ?? '')}"`);
    }
    const small = attributes.some(a => /^(slider|bet|seconds)=/.test(a)), element = small ? 'bounce-figure' : 'bounce-stage';
    if (!existsSync(join(root, 'stages', marker[1]))) problems.push(`${from}: there is no stage ${marker[1]} to be live`);
    tokens[i].content = `<${element} name="${marker[1]}" words="${md.utils.escapeHtml(options.join(' '))}" ${attributes.join(' ')}>`;
    const picture = tokens[i + 2]?.children, is_picture = tokens[i + 1]?.type === 'paragraph_open' && picture?.length === 1 && picture[0].type === 'image';
    const end = Object.assign(Object.create(Object.getPrototypeOf(tokens[i])), tokens[i], { content: `</${element}>` });
    tokens.splice(i + (is_picture ? 4 : 1), 0, end);
    i += is_picture ? 4 : 1;
  }
}

/** A translation without markers of its own gets those of the page that it translates: before the same picture or heading. */
function inherit(tokens, original) {
  const is_live = token => token.type === 'html_block' && token.content.startsWith('<!-- live:');
  const is_place = (token, i, all) => token.type === 'heading_open' && token.tag === 'h2' || token.type === 'paragraph_open' && all[i + 1].children.length === 1 && all[i + 1].children[0].type === 'image';
  if (tokens.some(is_live)) return;
  for (const marker of original.filter(is_live)) {
    const count = original.slice(0, original.indexOf(marker)).filter((token, i) => is_place(token, i, original)).length;
    const at = tokens.indexOf(tokens.filter((token, i) => is_place(token, i, tokens))[count]);
    tokens.splice(at < 0 ? tokens.length : at, 0, marker);
  }
}

// ---- A page
function shell(path, name, body, toc = '') {
  const base = '../'.repeat(page(path).split('/').length - 1), lang = language(path), say = text => t(text, lang), other = path.endsWith('.md') && twin(path);
  const menu = pages.filter(p => language(p) === lang && !p.includes('deeper/')), deeper = p => join(dirname(p), 'deeper', basename(p));
  const entry = (p, text, kind) => `<li class="${kind}${p === path ? ' here' : ''}"><a href="${base}${page(p)}"${p === path ? ' aria-current="page"' : ''}>${text}</a></li>`;
  const nav = menu.map(p => entry(p, md.renderInline(titles.get(p).replace(/^(\d+)\. /, '$1\\. ')), '') + (pages.includes(deeper(p)) ? entry(deeper(p), say('second page'), 'deeper') : '')).join('');
  const live = ['stage', 'figure'].filter(kind => body.includes('<bounce-' + kind)).flatMap((kind, i) => i || lang === 'en' ? kind : [lang, kind]).map(kind => `<script type="module" src="${base}live/${kind}.js"></script>`).join('');
  return `<!doctype html>
<html lang="${lang}"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width,initial-scale=1"><title>${md.utils.escapeHtml(name)} · Bounce</title>
<link rel="icon" href="data:,"><link rel="stylesheet" href="${base}assets/katex.min.css"><link rel="stylesheet" href="${base}assets/site.css">
<script>document.documentElement.dataset.theme = (() => { try { return localStorage.theme } catch {} })() || (matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light')</script></head><body>
<header><button id="menu" aria-label="${say('contents')}" aria-expanded="false">☰</button><a class="home" href="${base}${lang === 'ja' ? 'ja/' : ''}index.html">Bounce</a>
<div class="find"><input id="search" type="search" placeholder="${say('search')}" aria-label="${say('search')}" data-base="${base}"><ul id="found" aria-live="polite"></ul></div>
${other ? `<a class="language" lang="${language(other)}" hreflang="${language(other)}" href="${base}${page(other)}">${lang === 'ja' ? 'English' : '日本語'}</a>` : ''}<button id="theme" aria-label="${say('dark or light')}">◐</button></header>
<div class="columns"><nav aria-label="${say('contents')}"><ul>${nav}</ul></nav><main>${body}</main><aside aria-label="${say('on this page')}">${toc}</aside></div><script defer src="${base}assets/site.js"></script>${live}</body></html>`;
}

for (const path of pages) {
  const tokens = md.parse(read(join(docs, path)), {}), toc = [];
  let section = null;
  ids.set(path, new Set());
  tokens.forEach((token, i) => {
    if (token.type === 'heading_open') {
      const id = token.attrGet('id'), name = tokens[i + 1].children.map(child => child.content).join('');
      ids.get(path).add(id);
      section = { id: page(path) + '#' + id, title: (token.tag === 'h1' ? '' : titles.get(path) + ' › ') + name, text: '' };
      search[language(path)].push(section);
      if (token.tag === 'h2') toc.push(`<li><a href="#${id}">${md.renderer.renderInline(tokens[i + 1].children.filter(child => !child.type.startsWith('link')), md.options, {})}</a></li>`);
    }
    if (section && (token.type === 'inline' || token.type === 'fence')) section.text += token.content + ' ';
    for (const child of token.children ?? []) {
      if (child.type === 'link_open') child.attrSet('href', link(path, child.attrGet('href')));
      if (child.type === 'image') { child.attrSet('src', link(path, child.attrGet('src'))); child.attrSet('loading', 'lazy'); }
    }
  });
  if (language(path) === 'ja' && twin(path)) inherit(tokens, md.parse(read(join(docs, twin(path))), {}));
  markers(path, tokens);
  let body = '';
  try { body = md.renderer.render(tokens, md.options, {}); } catch (error) { problems.push(`${path}: ${error.message}`); }
  const menu = pages.filter(p => dirname(page(p)) === dirname(page(path))), at = menu.indexOf(path), step = (p, text) => p ? `<a href="${relative(dirname(page(path)), page(p))}">${text(md.renderInline(titles.get(p).replace(/^(\d+)\. /, '$1\\. ')))}</a>` : '<span></span>';
  body += `<div class="steps">${step(menu[at - 1], name => '← ' + name)}${step(menu[at + 1], name => name + ' →')}</div>`;
  write(page(path), shell(path, titles.get(path), body, '<ul>' + toc.join('') + '</ul>'));
}
for (const [from, path, id] of wanted) if (!ids.get(path).has(id)) problems.push(`${from}: there is no #${id} in ${path}`);

// ---- Sources as pages, and what all pages load
for (const source of sources) {
  if (statSync(join(root, source)).isDirectory()) {
    const files = readdirSync(join(root, source)).sort();
    files.forEach(file => sources.add(join(source, file)));
    write(code(source), shell(code(source), source, `<h1><code>${source}</code></h1><ul>${files.map(f => `<li><a href="${relative(dirname(code(source)), code(join(source, f)))}">${f}</a></li>`).join('')}</ul>`));
  } else {
    const text = read(join(root, source));
    write(code(source), shell(code(source), source, `<h1><code>${source}</code></h1><pre><code>${highlight(text, source.split('.').pop()) || md.utils.escapeHtml(text)}</code></pre>`));
  }
}
for (const [lang, sections] of Object.entries(search)) {
  const index = new MiniSearch(searched(lang));
  index.addAll(sections.filter((s, i) => s.text && sections.findIndex(o => o.id === s.id) === i));
  if (!sections.length) continue;
  write(`assets/search.${lang}.json`, JSON.stringify(index));
  write(`assets/search.${lang}.file.js`, searchTwin(join(dirname(require.resolve('minisearch')), '../umd/index.js'), join(here, 'live/language.js'), JSON.stringify(index)));
}
const katex = dirname(require.resolve('katex'));
const copy = (from, to) => { mkdirSync(dirname(join(out, to)), { recursive: true }); cpSync(from, join(out, to), { recursive: true }); };
copy(join(katex, 'katex.min.css'), 'assets/katex.min.css');
for (const font of readdirSync(join(katex, 'fonts'))) if (font.endsWith('.woff2')) copy(join(katex, 'fonts', font), 'assets/fonts/' + font);
copy(join(dirname(require.resolve('minisearch')), '..', 'es', 'index.js'), 'assets/minisearch.js');
for (const file of ['site.css', 'site.js']) copy(join(here, file), 'assets/' + file);
copy(join(here, 'live'), 'live');
write('live/live.file.js', liveTwin(['words', 'ja', 'module', 'pen', 'figure', 'stage'].map(name => join(here, `live/${name}.js`))));
for (const wasm of stages ? readdirSync(stages).filter(file => /^\d\d_\w+\.wasm$/.test(file)) : []) {
  const name = wasm.slice(0, -5), [script, code] = ['.js', '.wasm'].map(end => join(stages, name + end));
  copy(script, `live/${name}.js`);
  copy(code, `live/${wasm}`);
  write(`live/${name}.file.js`, stageTwin(name, script, code));
}
console.log(`${pages.length} pages, ${sources.size} sources, ${problems.length} problems`);
problems.forEach(problem => console.log('  ' + problem));
process.exit(problems.length ? 1 : 0);

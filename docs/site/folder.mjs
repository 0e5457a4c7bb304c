// For pages that are opened from a folder, without a server: browsers fetch nothing there and import no module, but they run plain
// scripts. So live/ and the search have plain twins, *.file.js, with their data in them. A page from a server never loads one.
import { readFileSync } from 'node:fs';
import { basename } from 'node:path';

const read = path => readFileSync(path, 'utf8');

/** A module as a function of what it exports and of what gives it others. */
function wrapped(path) {
  const names = [], text = read(path).replace(/^import (\{.*\}) from '(.*)';$/gm, "const $1 = need('$2');").replaceAll('import.meta.url', 'document.baseURI')
    .replace(/^export (const|(?:async )?function) (\w+)/gm, (whole, kind, name) => { names.push(name); return `${kind} ${name}`; });
  return `'./${basename(path)}': (exports, need) => {\n${text}\nObject.assign(exports, { ${names.join(', ')} });\n}`;
}

/** All modules of live/, and where stages come from here. `base` is of the page (site.js). */
export const liveTwin = paths => `{
const modules = {\n${paths.map(wrapped).join(',\n')}\n}, made = new Map(), stages = new Map();
const need = name => { if (!made.has(name)) { const all = {}; made.set(name, all); modules[name](all, need); } return made.get(name); };
const stage = name => {
  if (!stages.has(name)) stages.set(name, new Promise((done, fail) => document.head.append(Object.assign(document.createElement('script'), {
    src: base + 'live/' + name + '.file.js', onload: () => done(globalThis.bounceStage[name]), onerror: () => fail(new Error(name + ' is not there')) }))));
  return stages.get(name);
};
Object.assign(need('./module.js').source, {
  script: async name => (await stage(name)).make,
  code: async name => WebAssembly.compile(Uint8Array.from(atob((await stage(name)).code), letter => letter.charCodeAt())),
});
if (lang === 'ja') need('./ja.js');
need('./figure.js'); need('./stage.js');
}`;

/** A stage's script and its wasm, as text. */
export const stageTwin = (name, script, wasm) =>
  `(globalThis.bounceStage ??= {})['${name}'] = { make: (() => { ${read(script).replaceAll('import.meta.url', 'document.baseURI').replace(/export default (\w+);\s*$/, 'return $1;')} })(),
code: '${readFileSync(wasm).toString('base64')}' };`;

/** What searches, and the words of all pages. `umd`: MiniSearch as a plain script. */
export const searchTwin = (umd, language, index) => `${read(umd)}\n{\nconst exports = {};\n({ ${wrapped(language)} })['./language.js'](exports);
globalThis.bounceSearch = { ...exports, MiniSearch, index: ${JSON.stringify(index)} };\n}`;

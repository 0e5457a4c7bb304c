// A stage's C++ in a page: module.js fetches and compiles it once, each figure gets a run of its own. What the C++ offers
// (common/app/window_web.cpp) is here under its own name: api.state(), api.set('damping', '18').
const compiled = new Map(); // by file: the code, ready to be run
const whole = new Set(); // stages that the page has whole, with their pictures
const types = { // [result, arguments]: s text, n number
  about: 's', state: 's', refusal: 's', answer: 's', move: ' n', draw: ' n', size: ' nn', set: 'sss', method: 'ssn', see: ' sn', press: 'nn', go_back: ' n',
  pointer: 'nnnn', hold: ' n', knock: 'n', path: 'nnnn', values: 'nn', memory: 'n', rows: 'n',
};
const word = { s: 'string', n: 'number', ' ': null };

/** Where a stage's two files come from: its script, and its code compiled. A page without a server has its own way (folder.mjs). */
export const source = {
  script: async (name, where) => (await import(new URL(`./${name}.js`, where))).default,
  code: (name, where) => {
    const url = new URL(`./${name}.wasm`, where);
    return fetch(url).then(answer => WebAssembly.compileStreaming(answer)).catch(() =>
      fetch(url).then(answer => answer.arrayBuffer()).then(bytes => WebAssembly.compile(bytes))); // a server that knows no wasm
  },
};

/** Starts a stage with the words of a command line: '--set damping=18'. `makePen` is of pen.js. Without a pen it needs no pictures:
 *  then it takes the smaller file that has none, unless the page has the whole stage anyway. */
export async function start(stage, words = '', makePen = null, where = import.meta.url) {
  if (makePen) whole.add(stage);
  const name = whole.has(stage) ? stage : stage + '_figure', make = await source.script(name, where);
  let module = null;
  const pen = makePen && makePen(() => module.HEAPF32);
  module = await make({
    arguments: words.split(/\s+/).filter(Boolean), pen,
    kept: key => { try { return Number(localStorage.getItem('bounce ' + key)) || 0; } catch { return 0; } },
    keep: (key, value) => { try { localStorage.setItem('bounce ' + key, value); } catch { /* a page that may keep nothing */ } },
    instantiateWasm(imports, done) {
      if (!compiled.has(name)) compiled.set(name, source.code(name, where));
      compiled.get(name).then(code => WebAssembly.instantiate(code, imports)).then(done);
      return {};
    },
  });
  return Object.assign(connect(module), { pen });
}

/** The functions of a module that runs. */
export function connect(module) {
  const api = { module };
  for (const [name, of] of Object.entries(types)) api[name] = module.cwrap('page_' + name, word[of[0]], [...of.slice(1)].map(t => word[t]));
  const refusal = api.refusal();
  if (refusal) throw new Error(refusal);
  /** The `count` numbers that the last call made. */
  api.numbers = count => module.HEAPF64.slice(api.rows() / 8, api.rows() / 8 + count);
  return api;
}

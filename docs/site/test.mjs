// node test.mjs PROJECT: what must hold of build/site, in node and in headless Chromium. ./course test web builds all that it needs.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { gzipSync } from 'node:zlib';
import { chromium } from 'playwright-core';
import { serve } from './serve.mjs';
import { connect } from './live/module.js';

const project = process.argv[2], site = join(project, 'build/site'), shots = join(project, 'build/site_pictures'), began = performance.now();
let failures = 0, checks = 0;
const check = (good, text) => { ++checks; if (!good) { ++failures; console.log('FAILED: ' + text); } return good; };
/** Our own work. Where others use the machine, too, all of it takes longer: only twice the budget fails. */
const budget = (cost, most, what) => { if (!(cost < most)) console.log(`over the budget: ${what} costs ${cost?.toFixed(1)} ms of ${most}`); check(cost < 2 * most, `${what} costs ${cost?.toFixed(1)} ms, and should cost ${most}`); };
const since = name => console.log(`${name}: ${((performance.now() - began) / 1000).toFixed(0)} s after the start`);
const stages = readdirSync(join(site, 'live')).filter(f => f.endsWith('.wasm')).map(f => f.slice(0, -5));
const median = list => [...list].sort((a, b) => a - b)[list.length >> 1];
const quick = list => [...list].sort((a, b) => a - b)[Math.floor(list.length / 10)]; // what it costs when nobody else uses the machine
check(stages.length === 8, `there are ${stages.length} stages in the site, and not 8`);
mkdirSync(shots, { recursive: true });

// ---- The same bits: the very modules that the pages run, against the table that all builds are held to
class Hash { // FNV-1a over the bits of numbers, as in tests/hard_cases/state_hashes.cpp; in two halves
  high = 0xcbf29ce4; low = 0x84222325;
  add(numbers) {
    for (const byte of new Uint8Array(numbers.buffer, numbers.byteOffset, numbers.byteLength)) {
      this.low = (this.low ^ byte) >>> 0;
      const a = (this.low & 0xffff) * 0x1b3, b = (this.low >>> 16) * 0x1b3 + (a >>> 16); // times 0x100000001b3
      this.high = (Math.imul(this.high, 0x1b3) + (this.low << 8) + (b >>> 16)) >>> 0;
      this.low = ((b << 16) | (a & 0xffff)) >>> 0;
    }
  }
  copy() { return Object.assign(new Hash(), this); }
  get text() { return this.high.toString(16).padStart(8, '0') + this.low.toString(16).padStart(8, '0'); }
}
const modules = new Map();
async function run(name, words) {
  if (!modules.has(name)) {
    const code = await WebAssembly.compile(readFileSync(join(site, `live/${name}.wasm`)));
    const script = join(shots, name + '.mjs'); // so that node takes it for a module
    writeFileSync(script, readFileSync(join(site, `live/${name}.js`)));
    const make = (await import(pathToFileURL(script))).default;
    modules.set(name, words => make({ arguments: words.split(' ').filter(Boolean), kept: () => 0, keep() {}, instantiateWasm(imports, done) { WebAssembly.instantiate(code, imports).then(done); return {}; } }));
  }
  return connect(await modules.get(name)(words));
}
const differ = [], told = [];
for (const line of readFileSync(join(project, 'tests/hard_cases/state_hashes.txt'), 'utf8').trim().split('\n').slice(1)) {
  const [, wanted, kind, name, words] = line.match(/^(\w+) {2}(\w+) +(\w+) (.*?) {2}(?:ends|stops) at/);
  const stage = await run(name, words), hash = new Hash();
  let same = false;
  for (let row = 0; row * 0.05 <= 5 && !same; ++row) { // for how long it ran, the table does not say: 1, 2 or 5 s
    const count = stage.values(row * 0.05);
    if (stage.answer()) { same = hash.text === wanted; break; } // it has no closed form from here on
    hash.add(stage.numbers(count));
    if (![20, 40, 100].includes(row)) continue;
    const end = hash.copy();
    end.add(stage.numbers(stage.memory()));
    same = end.text === wanted;
  }
  (kind === 'arithmetic' ? differ : told).push(same ? '' : line);
}
check(differ.length > 90 && differ.every(line => !line), 'other bits than everywhere:\n' + differ.filter(Boolean).join('\n'));
console.log(`bits: ${differ.filter(l => !l).length} of ${differ.length} arithmetic rows are equal; of ${told.length} rows with functions ${told.filter(Boolean).length} differ, as this C library's do`);
since('bits');

// ---- Sizes
for (const name of stages) {
  const size = f => gzipSync(readFileSync(join(site, 'live', f)), { level: 9 }).length;
  const own = ['module.js', 'words.js', 'figure.js', 'stage.js', 'pen.js'].reduce((sum, f) => sum + size(f), 0), all = size(name + '.js') + size(name + '.wasm') + own;
  console.log(`size: ${name} ${(all / 1000).toFixed(0)} kB (gzip), of which our script ${(own / 1000).toFixed(0)}`);
  check(all <= 180e3, `${name} loads ${all} bytes, and at most 180 kB are allowed`);
}

// ---- In a browser
const server = await serve(site, 0, '/some/where/'), base = `http://127.0.0.1:${server.address().port}/some/where/`;
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', headless: true,
  args: ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync'] });
async function open(width, theme, path) {
  const context = await browser.newContext({ viewport: { width, height: 900 }, deviceScaleFactor: width < 500 ? 2 : 1, colorScheme: theme, hasTouch: width < 500, reducedMotion: 'no-preference' }), page = await context.newPage();
  page.on('pageerror', error => check(false, `${path}: ${error.message}`));
  page.on('console', message => message.type() === 'error' && check(false, `${path}: ${message.text()}`));
  page.on('request', request => check(request.url().startsWith(base) || request.url().startsWith('data:'), `${path} asks for ${request.url()}`));
  page.on('response', response => check(response.status() < 400, `${path}: ${response.status()} for ${response.url()}`));
  await page.goto(base + path);
  return page;
}
const close = page => page.context().close();
/** Two at a time. */
const both = async (list, work) => { const left = [...list], worker = async () => { while (left.length) await work(left.shift()); }; await Promise.all([worker(), worker()]); };
const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const html = folder => readdirSync(join(site, folder)).filter(f => f.endsWith('.html')).map(f => join(folder, f));
const pages = ['', 'deeper', 'ja', 'ja/deeper'].filter(f => existsSync(join(site, f))).flatMap(html);

/** Everything that is live on the page starts; those outside the window, too. */
async function startAll(page, path) {
  const figures = page.locator('bounce-stage, bounce-figure');
  for (let i = 0; i < await figures.count(); ++i) {
    await figures.nth(i).scrollIntoViewIfNeeded();
    const ready = await figures.nth(i).evaluate(figure => new Promise(done => { const look = () => figure.ready ? done(figure.ready) : performance.now() > 20000 ? done(0) : setTimeout(look, 20); look(); }));
    check(ready > 0, `${path}: live figure ${i} does not start`);
  }
  return figures;
}
for (const [width, theme] of [[1280, 'light'], [390, 'dark']]) {
  await both(pages, async path => {
    const page = await open(width, theme, path);
    await startAll(page, path);
    const seen = await page.evaluate(() => ({
      over: document.documentElement.scrollWidth - innerWidth, raw: ((main => { main.querySelectorAll('pre, code, .katex').forEach(e => e.remove()); return main.textContent; })(document.querySelector('main').cloneNode(true)).match(/\$[^$\n]{1,60}\$/g) ?? []).slice(0, 3), bad: document.querySelectorAll('.katex-error').length,
      pictures: [...document.images].filter(i => i.complete && !i.naturalWidth).map(i => i.src), figures: document.querySelectorAll('bounce-stage, bounce-figure').length }));
    check(seen.over <= 1, `${path} is ${seen.over} px too wide at ${width}`);
    check(!seen.raw.length && !seen.bad, `${path}: a formula is not rendered: ${seen.raw}`);
    check(!seen.pictures.length, `${path}: pictures are missing: ${seen.pictures}`);
    if (/^(ja\/)?0[1-8]/.test(path)) check(seen.figures >= 2, `${path} has ${seen.figures} live figures, and not two`);
    await page.evaluate(axe);
    const found = await page.evaluate(() => axe.run({ resultTypes: ['violations'] }).then(r => r.violations.filter(v => /serious|critical/.test(v.impact)).map(v => `${v.id}: ${v.nodes.slice(0, 2).map(n => n.target + ' ' + n.failureSummary?.split('\n')[1]).join('; ')}`)));
    check(!found.length, `${path} at ${width}, ${theme}: ${found.join(' | ')}`);
    await page.evaluate(() => scrollTo(0, 0));
    await page.screenshot({ path: join(shots, `${path.replaceAll('/', '_').replace('.html', '')}_${width}_${theme}.png`) });
    await close(page);
  });
  since(`${pages.length} pages at ${width} px`);
}

// ---- What a reader does
const time = page => page.evaluate(() => JSON.parse(document.querySelector('bounce-stage').api.state()).t);
const ready = page => page.waitForFunction(() => document.querySelector('bounce-stage').ready, null, { timeout: 20000 });
const lesson = name => `${name}.html`;
for (const name of stages) {
  const page = await open(1280, 'light', lesson(name));
  const stage = page.locator('bounce-stage').first();
  await stage.scrollIntoViewIfNeeded();
  await ready(page);
  const first = await page.evaluate(() => document.querySelector('bounce-stage').ready);
  check(first < 1200, `${name}: the first picture takes ${first.toFixed(0)} ms`);
  await page.waitForTimeout(200);
  const at = Number(await stage.getAttribute('at')) || 0, stands = async () => Math.abs(await time(page) - at) < 1e-6;
  check(await stands(), `${name} does not start paused, at ${at} s`);
  check(await page.evaluate(() => { const s = document.querySelector('bounce-stage'); return !s.running; }), `${name} draws while nothing moves`);
  await page.locator('h1').first().click();
  await page.keyboard.press('p');
  await page.waitForTimeout(200);
  check(await stands(), `${name}: P moves it without the focus`);
  await stage.locator('canvas').focus();
  await page.keyboard.press('p');
  await page.waitForTimeout(1500);
  check(Math.abs(await time(page) - at) > 0.3, `${name}: P with the focus does not move it`);
  const most = name.startsWith('05') ? 12 : 4;
  let costs = [];
  for (let second = 0; second < 5 && !(quick(costs) < most); ++second) { // on a busy machine some seconds are quieter than others
    await page.evaluate(() => { document.querySelector('bounce-stage').costs = []; });
    await page.waitForTimeout(1000);
    costs = await page.evaluate(() => document.querySelector('bounce-stage').costs);
  }
  console.log(`${name}: first picture ${first.toFixed(0)} ms, a frame ${median(costs)?.toFixed(1)} ms (median)`);
  budget(quick(costs), most, `${name}: a frame`);
  await page.evaluate(() => scrollTo(0, document.body.scrollHeight));
  await page.waitForTimeout(300);
  const frames = await page.evaluate(() => document.querySelector('bounce-stage').frames);
  await page.waitForTimeout(300);
  check(frames === await page.evaluate(() => document.querySelector('bounce-stage').frames), `${name} draws where nobody sees it`);
  await close(page);
}
since('keys');

// A slider's numbers, against the program's: all of its path, at whole steps.
for (const [name, slider, value, at] of [['01_free_fall', 'gravity', '3.7', '0.5,0.9'], ['02_spring_floor', 'stiffness', '2500', '0.5,2,3'], ['03_damping', 'damping', '43', '0.5,1,2.5'], ['04_three_dimensions', 'velocity', '2.5,0,-0.5', '0.5,1.5'],
  ['05_ball_collision', 'gap', '0.05', '1,2'], ['06_oscillating_floor', 'amplitude', '0.07', '0.5,1'], ['07_tilted_plane', 'damping', '9', '0.5,1'], ['08_racket_game', 'damping', '9', '0.4,0.8']]) {
  const bare = name.startsWith('08') ? ['--player', 'none'] : [], program = join(project, 'build/release/bin', name);
  const rows = execFileSync(program, [...bare, '--headless', '--csv', '-', '--at', at, '--set', `${slider}=${value}`], { stdio: ['ignore', 'pipe', 'ignore'] }).toString().trim().split('\n').slice(1).map(row => row.split(',').map(Number));
  const page = await open(1280, 'light', lesson(name));
  const got = await page.evaluate(async ([name, slider, value, words, times]) => {
    const { start } = await import('./live/module.js');
    const { penFor } = await import('./live/pen.js');
    const { control } = await import('./live/words.js');
    const api = await start(name, words, penFor(document.createElement('canvas').getContext('2d'))), about = JSON.parse(api.about());
    const row = control(about.parameters.find(p => p.name === slider), document.body, text => api.set(slider, text));
    value.split(',').forEach((part, i) => { row.inputs[i].value = row.place(+part); });
    row.inputs[0].dispatchEvent(new Event('input')); // as a hand does
    const numbers = api.numbers(api.path(times.at(-1), 1 + Math.round(times.at(-1) / about.dt), 0)), wide = 1 + about.columns.length * about.balls, all = [];
    for (let i = 0; i + wide <= numbers.length; i += wide) if (times.some(t => Math.abs(numbers[i] - t) < about.dt / 2)) all.push(...Array.from({ length: about.balls }, (_, b) => [...numbers.slice(i + 1 + b * about.columns.length, i + 1 + (b + 1) * about.columns.length)]));
    return all;
  }, [name, slider, value, bare.join(' '), at.split(',').map(Number)]);
  const values = rows.map(row => row.slice(1)), worst = Math.max(...values.map((row, i) => Math.max(...row.map((v, j) => Math.abs(v - (got[i]?.[j] ?? NaN))))));
  check(got.length === values.length && worst <= 1e-12, `${name}: slider ${slider} at ${value}: ${worst} away from the program`);
  await close(page);
}
since('sliders');

// The survey of stage 6: it is seen when a slider moves, and a click in it goes to that amplitude.
{
  const page = await open(1280, 'light', '06_oscillating_floor.html'), stage = page.locator('bounce-stage').first(), canvas = stage.locator('canvas');
  await stage.scrollIntoViewIfNeeded();
  await ready(page);
  const seen = () => page.evaluate(() => { const { api } = document.querySelector('bounce-stage'); return [JSON.parse(api.state()).surveyed, +JSON.parse(api.about()).parameters.find(p => p.name === 'amplitude').text]; });
  await canvas.evaluate(e => e.scrollIntoView({ block: 'end' })); // below the head of the page
  const box = await canvas.boundingBox(), click = () => page.mouse.click(box.x + box.width * 480 / 840, box.y + box.height * 630 / 720);
  await click();
  const [none, still] = await seen();
  check(!none && still === 0.06, `stage 6: a survey that nobody sees takes a click: ${still}`);
  await stage.getByText('every amplitude').click();
  await page.waitForTimeout(500);
  await canvas.evaluate(e => e.scrollIntoView({ block: 'end' }));
  await click();
  const [surveyed, amplitude] = await seen();
  check(surveyed && amplitude > 0.08 && amplitude < 0.09, `stage 6: a click in the survey goes to ${amplitude} m`);
  await close(page);
}

// The bet, a small figure's slider, the chart of errors, the game, sound, best score, search, theme, many balls
let page = await open(1280, 'light', '03_damping.html');
await startAll(page, '03_damping.html');
const bet = page.locator('bounce-figure[bet]');
check(await bet.locator('path.line').getAttribute('d') === '', 'the bet shows its answer before it is played');
await bet.locator('input').fill('0.5');
await bet.locator('.play').click();
await page.waitForFunction(() => { const f = document.querySelector('bounce-figure[bet]'); return f.shown && !f.playing; }, null, { timeout: 20000 });
check(/0\.5 m .*0\.619 m .*0\.119 m/.test(await bet.locator('.facts').textContent()), 'the bet does not say how far off it is: ' + await bet.locator('.facts').textContent());
const small = page.locator('bounce-figure[slider]'), before = await small.locator('path.line').getAttribute('d');
await small.locator('input').first().fill('0.5');
check(before !== await small.locator('path.line').getAttribute('d'), 'the small figure does not follow its slider');
const redraws = await small.evaluate(figure => { const all = []; for (let i = 0; i < 21; ++i) { figure.querySelector('input').value = i / 20; figure.querySelector('input').dispatchEvent(new Event('input')); all.push(figure.cost); } return all; });
console.log(`a slider of a small figure to its whole curve: ${median(redraws).toFixed(1)} ms (median)`);
const errors = page.locator('bounce-stage[errors]');
await errors.scrollIntoViewIfNeeded();
await page.waitForFunction(() => { const s = document.querySelector('bounce-stage[errors]'); return s.ready && !JSON.parse(s.api.state()).busy; }, null, { timeout: 30000 });
const picture = page.locator('bounce-stage').first(), canvas = picture.locator('canvas');
await canvas.scrollIntoViewIfNeeded();
await canvas.focus();
await page.keyboard.press('r');
const box = await canvas.boundingBox(), at = (x, y) => [box.x + x / 840 * box.width, box.y + y / 840 * box.width]; // as in the window
await page.mouse.move(...at(449, 124)); // the ball, at 1 m
await page.mouse.down();
await page.mouse.move(...at(449, 300), { steps: 5 });
await page.waitForTimeout(200);
const height = await picture.evaluate(stage => JSON.parse(stage.api.state()).height / 9.81);
check(height > 0.4 && height < 0.55, `the ball does not follow the mouse: it is at ${height} m`);
await page.mouse.up();
for (const [key, what] of [['o', 'slow'], ['l', 'lens'], ['e', 'errors'], ['F1', 'help']]) {
  await page.keyboard.press(key);
  check(await picture.evaluate((stage, what) => JSON.parse(stage.api.state())[what], what), `the key ${key} does nothing`);
}
await errors.screenshot({ path: join(shots, 'errors.png') });
await page.locator('#search').fill('restitution');
await page.waitForFunction(() => document.querySelectorAll('#found a').length > 2);
await page.locator('#theme').click();
check(await page.evaluate(() => document.documentElement.dataset.theme) === 'dark', 'the theme does not change');
await close(page);

page = await open(1280, 'light', '08_racket_game.html');
await ready(page);
check(await page.evaluate(async () => { // plays by itself: ten hits
  const { start } = await import('./live/module.js'), { penFor } = await import('./live/pen.js');
  const api = await start('08_racket_game', '--player autopilot', penFor(document.createElement('canvas').getContext('2d')));
  api.press('p'.charCodeAt());
  let hits = 0;
  for (let frame = 0; frame < 6000 && hits < 10; ++frame) { api.move(1 / 60); if (api.knock() > 0) ++hits; }
  return hits;
}) >= 10, 'the autopilot does not hit ten times');
await page.evaluate(() => localStorage.setItem('bounce racket_game_keep-up_30', '7'));
await page.reload();
await ready(page);
await page.locator('bounce-stage canvas').first().click();
check(await page.evaluate(() => { const { api } = document.querySelector('bounce-stage'); api.move(0.01); return api.module.kept?.('racket_game_keep-up_30') ?? Number(localStorage.getItem('bounce racket_game_keep-up_30')); }) === 7, 'the best score is not kept');
await close(page);

page = await open(1280, 'light', '05_ball_collision.html');
let frames = [];
for (let time = 0; time < 4 && !(quick(frames) < 12); ++time) frames = await page.evaluate(async () => { // 300 balls
  const { start } = await import('./live/module.js'), { penFor } = await import('./live/pen.js');
  const canvas = Object.assign(document.createElement('canvas'), { width: 840, height: 720 }), api = await start('05_ball_collision', '--set scene=drop --set count=300', penFor(canvas.getContext('2d'))), costs = [];
  api.press('p'.charCodeAt());
  for (let frame = 0; frame < 200; ++frame) { const from = performance.now(); api.move(1 / 60); for (const part of [0, 1, 2, 3]) api.draw(part); costs.push(performance.now() - from); await new Promise(done => setTimeout(done, 1)); }
  return costs;
});
console.log(`300 balls: a frame ${median(frames).toFixed(1)} ms (median)`);
budget(quick(frames), 12, '300 balls: a frame');
await close(page);

await browser.close();
server.close();
since('all');
console.log(`${checks} checks, ${failures} failed`);
process.exit(failures ? 1 : 0);

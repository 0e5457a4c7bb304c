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
import { testFolder } from './test_folder.mjs';
import { testHands } from './test_hands.mjs';
import { testJapanese } from './test_ja.mjs';

const project = process.argv[2], site = join(project, 'build/site'), shots = join(project, 'build/site_pictures'), began = performance.now();
let failures = 0, checks = 0;
const check = (good, text) => { ++checks; if (!good) { ++failures; console.log('FAILED: ' + text); } return good; };
const since = name => console.log(`${name}: ${((performance.now() - began) / 1000).toFixed(0)} s after the start`);
const stages = readdirSync(join(site, 'live')).filter(f => /^\d\d_.*\.wasm$/.test(f) && !f.endsWith('_figure.wasm')).map(f => f.slice(0, -5));
const median = list => [...list].sort((a, b) => a - b)[list.length >> 1];
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

// The smaller modules that figures load without a stage: the same paths as the whole ones, before and after a slider and a method; and texts of numbers.
for (const name of stages) {
  const words = name.startsWith('08') ? '--player none' : '', all = [];
  for (const file of [name, name + '_figure']) {
    const stage = await run(file, words), hash = new Hash(), path = (seconds, exact) => hash.add(stage.numbers(stage.path(seconds, 301, exact)));
    path(2, 1);
    const { parameters, dials } = JSON.parse(stage.about()), told = [];
    for (const { name, text, lowest, highest } of [...dials, ...parameters.filter(p => !p.choices && !p.text.includes(','))]) {
      told.push(stage.set(name, String(lowest + 0.37 * (highest - lowest))), stage.set(name, 'nonsense')); path(1, 0); stage.set(name, text);
    }
    for (const method of ['rk4', 'reference', 'exact']) { told.push(stage.method(method, 0.002)); path(1, 1); }
    all.push(hash.text + told + stage.about().replace(/"(game|space|survey|keys)":("[^"]*"|\[.*?\]|\w+),/g, ''));
  }
  check(all[0] === all[1] && all[0].includes('is not allowed'), `${name}: a small figure is not as the whole stage:\n${all.join('\n')}`);
}
{
  const stage = await run('01_free_fall_figure', ''), said = { '100000': '1e+05', '123456': '123456', '1.2345e5': '123450', '0.0001': '1e-04', '0.00012': '0.00012', '-2.5': '-2.5', '1e15': '1e+15', '123456789012345': '123456789012345', '-0': '-0', '+7': '7', '.5': '0.5' };
  for (const [text, wanted] of Object.entries(said)) check(stage.set('position', text) === '' && JSON.parse(stage.about()).parameters.find(p => p.name === 'position').text === wanted, `${text} is said as ${JSON.parse(stage.about()).parameters.find(p => p.name === 'position').text}, and not ${wanted}`);
  for (const text of ['', '0x10', 'Infinity', '1e999', '1e-999', '5e', '1_0', '+-1', 'nan']) check(/is not allowed/.test(stage.set('position', text)), `'${text}' is taken for a number`);
  for (let i = 0; i < 2000; ++i) { const value = (Math.random() - .5) * 10 ** (40 * Math.random() - 25); stage.set('position', String(value)); check(Number(JSON.parse(stage.about()).parameters[2].text) === value, `${value} is not read back`); }
}
since('bits');

// ---- Sizes
for (const name of stages) {
  const size = f => gzipSync(readFileSync(join(site, 'live', f)), { level: 9 }).length;
  const sum = files => files.reduce((all, f) => all + size(f), 0), shared = ['module.js', 'words.js'], small = sum([...shared, 'figure.js', name + '_figure.js', name + '_figure.wasm']), whole = sum(['stage.js', 'pen.js', name + '.js', name + '.wasm']);
  console.log(`size: ${name} ${(small / 1000).toFixed(1)} kB (gzip) for small figures, ${(whole / 1000).toFixed(1)} more for the whole stage`);
  check(small <= 120e3, `${name} loads ${small} bytes for its small figures, and at most 120 kB are allowed`);
  check(whole <= 250e3, `${name} loads ${whole} bytes more for a whole stage, and at most 250 kB are allowed`);
}

// ---- In a browser
const server = await serve(site, 0, '/some/where/'), base = `http://127.0.0.1:${server.address().port}/some/where/`;
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', headless: true,
  args: ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync'] });
async function open(width, theme, path, before = null) { // before: runs in the page, ahead of all else
  const context = await browser.newContext({ viewport: { width, height: 900 }, deviceScaleFactor: width < 500 ? 2 : 1, colorScheme: theme, hasTouch: width < 500, reducedMotion: 'no-preference' }), page = await context.newPage();
  if (before) await page.addInitScript(before);
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

/** Our own work in a frame [ms], the median over so many tenths of a second: what the processor spent on the page's script, by the clock of its
 *  thread, so that it is the same where others use the machine, too. `count`: of the frames so far, in the page. */
async function ownWork(page, count, tenths = 60) {
  const cdp = await page.context().newCDPSession(page), costs = [];
  await cdp.send('Performance.enable', { timeDomain: 'threadTicks' });
  const now = async () => ({ frames: await page.evaluate(count), spent: (await cdp.send('Performance.getMetrics')).metrics.find(m => m.name === 'ScriptDuration').value });
  for (let i = 0, last = await now(); i < tenths; ++i) {
    await page.waitForTimeout(100);
    const next = await now();
    if (next.frames > last.frames) costs.push(1000 * (next.spent - last.spent) / (next.frames - last.frames));
    last = next;
  }
  return median(costs);
}
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
const lessons = pages.filter(path => /^(ja\/)?0[1-8]/.test(path)); // in all widths and colours; other pages have nothing that depends on both
for (const [width, theme, of] of [[1280, 'light', pages], [390, 'dark', pages], [1280, 'dark', lessons], [390, 'light', lessons]]) {
  await both(of, async path => {
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
  since(`${of.length} pages at ${width} px, ${theme}`);
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
  const work = await ownWork(page, () => document.querySelector('bounce-stage').frames), costs = await page.evaluate(() => document.querySelector('bounce-stage').costs);
  console.log(`${name}: first picture ${first.toFixed(0)} ms, a frame ${work?.toFixed(2)} ms of the processor (median; by the clock ${median(costs)?.toFixed(2)})`);
  check(work < most, `${name}: a frame costs ${work?.toFixed(2)} ms, and at most ${most} are allowed`);
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
    const row = control(about.parameters.find(p => p.name === slider), text => api.set(slider, text));
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
await page.locator('bounce-stage').first().scrollIntoViewIfNeeded();
await page.waitForFunction(() => document.querySelector('bounce-stage').ready, null, { timeout: 30000 });
const truth = await page.evaluate(() => document.querySelector('bounce-stage').toggles.exact.textContent);
check(truth === 'reference', `the button for what stage 5 is compared with says '${truth}', and there is no exact solution`);
await page.evaluate(async () => { // 300 balls
  const { start } = await import('./live/module.js'), { penFor } = await import('./live/pen.js');
  const canvas = Object.assign(document.createElement('canvas'), { width: 840, height: 720 }), api = await start('05_ball_collision', '--set scene=drop --set count=300', penFor(canvas.getContext('2d')));
  api.press('p'.charCodeAt());
  window.pictures = 0;
  const frame = () => { api.move(1 / 60); for (const part of [0, 1, 2, 3]) api.draw(part); ++window.pictures; requestAnimationFrame(frame); };
  frame();
});
const work = await ownWork(page, () => window.pictures);
console.log(`300 balls: a frame ${work?.toFixed(2)} ms of the processor (median)`);
check(work < 12, `300 balls: a frame costs ${work?.toFixed(2)} ms, and at most 12 are allowed`);
await close(page);

await testHands({ check, open, close, ready });
since('hands');
const japanese = pages.filter(path => /^ja\/0[1-8]/.test(path));
await testJapanese({ check, open, close, startAll, lessons: japanese, both, shots });
since('Japanese');
await testFolder({ check, browser, site, startAll });
await browser.close();
server.close();
since('all');
console.log(`${checks} checks, ${failures} failed`);
process.exit(failures ? 1 : 0);

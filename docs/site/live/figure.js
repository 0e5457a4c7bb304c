// A small figure in a lesson: one curve, and one slider that draws all of it anew.
//   <bounce-figure name="03_damping" words="--set damping=18" slider="damping" seconds="3">
// slider: parameters, `velocity.x` a component of one, `dt` the step, `method` a choice of methods.
// y, x: columns of the trace (x: t, in place of one), or y=apart, how far the height is from that by formula; of ball `ball`
// (from 0), and pale of `other`. exact: the curve by formula, dashed. beside: the words of a second run, pale. xrange, yrange: what is shown.
// bet: what the reader guesses before anything is drawn, and then plays. He drags a flag to the height of the second top (top2), of
// any top (tops), to where the first touch begins (touch1), to the end (end). With a slider his bet is the slider's number, for the top to
// be at `goal`: what is asked then, such as the racket's speed, is no place in the picture, so the flag stands at the goal.
import { start } from './module.js';
import { control, html, named, say, watch } from './words.js';

const H = 300, left = 48, top = 18, bottom = H - 40;

const svg = (name, attributes, parent) => {
  const element = document.createElementNS('http://www.w3.org/2000/svg', name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  parent?.append(element);
  return element;
};
/** Round numbers that cut [low, high] into about `count` parts. */
function ticks(low, high, count) {
  const raw = (high - low) / count, ten = 10 ** Math.floor(Math.log10(raw)), step = [1, 2, 5, 10].find(s => s * ten >= raw) * ten, all = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i) all.push([i * step, (i * step).toFixed(Math.max(0, -Math.floor(Math.log10(step) + 1e-9)))]);
  return all;
}
const asked = { top1: 'the height of the first top', top2: 'the height of the second top', top3: 'the height of the third top', tops: 'the height of a top', touch1: 'when the first touch begins', touch4: 'where the fourth touch begins', end: 'where the curve ends' };
const short = value => String(+value.toPrecision(3));

/** The tops of a curve, and where a touch begins: there the velocity, which gravity only lowers, begins to grow. */
function moments(points, up) {
  const tops = [], touches = [];
  for (let i = 1; i + 1 < points.length; ++i) {
    if (points[i][1] >= points[i - 1][1] && points[i][1] > points[i + 1][1]) tops.push(points[i]);
    if (up[i + 1] > up[i] && up[i] <= up[i - 1]) touches.push(points[i]);
  }
  return { tops, touches };
}

class Figure extends HTMLElement {
  connectedCallback() {
    watch(this, () => this.begin().catch(error => { this.append(html('p', { className: 'warning' }, String(error.message ?? error))); console.error(error); }),
      seen => { this.seen = seen; if (seen && this.parked) { this.parked(); this.parked = null; } });
  }
  get right() { return this.wide - 16; }
  get(name, otherwise) { return this.getAttribute(name) ?? otherwise; }

  async begin() {
    const began = performance.now(), name = this.get('name'), words = this.get('words', '');
    this.api = await start(name, words);
    this.other = this.hasAttribute('beside') ? await start(name, this.get('beside')) : null;
    this.about = JSON.parse(this.api.about());
    this.seconds = +this.get('seconds', 3);
    this.bet = (this.get('bet', '').match(/^(\D+)(\d*)$/) ?? []).slice(1);
    const units = { t: 's', v: 'm/s', vx: 'm/s', vy: 'm/s', vz: 'm/s' }, called = { t: 'time', y: 'height', v: 'velocity', apart: 'how far apart' };
    this.axes = ['x', 'y'].map((axis, i) => { const column = this.get(axis, i ? 'y' : 't'); return { column, title: `${say(called[column] ?? column)} [${units[column] ?? 'm'}]` }; });
    this.wide = Math.max(320, Math.min(640, this.clientWidth - 20));
    this.build();
    this.compute();
    this.ready = performance.now() - began;
  }
  build() {
    this.svg = svg('svg', { viewBox: `0 0 ${this.wide} ${H}`, role: 'img', 'aria-label': `${say(this.about.title)}: ${this.axes[1].title}, ${this.axes[0].title}` });
    this.grid = svg('g', {}, this.svg);
    for (const line of ['pale', 'formula', 'floor', 'line']) this[line] = svg('path', { class: line }, this.svg);
    this.head = svg('circle', { r: 6, class: 'head', visibility: 'hidden' }, this.svg);
    this.status = html('p', { className: 'facts', 'aria-live': 'polite' });
    const plain = words => words.replace(/--set (\w+)=(\S+)/g, (whole, name, value) => `${named(name)} = ${value}`).replace(/--(\w+)/g, (whole, option) => named(option));
    const setting = [plain(this.get('words', '')), this.other ? say('pale: ' + plain(this.get('beside'))) : '', this.hasAttribute('other') ? say('pale: the other ball') : ''].filter(Boolean).join(' · ');
    this.rows = this.get('slider', '').split(/\s+/).filter(Boolean).map(name => this.slider(name));
    this.play = html('button', { type: 'button', className: 'play', onclick: () => this.toggle() }, this.bet.length ? say('play and see') : say('play'));
    const again = this.bet.length && !this.rows.length ? [html('button', { type: 'button', onclick: () => { this.end(); this.shown = false; this.show(0); } }, say('bet again'))] : [];
    this.replaceChildren(this.svg, ...this.rows, html('div', { className: 'buttons' }, this.play, ...again), this.status, html('p', { className: 'setting' }, setting));
    if (this.bet.length) this.buildFlag();
  }

  slider(name) {
    const { api } = this, [whole, component] = name.split('.'), parameter = this.about.parameters.concat(this.about.dials).find(p => p.name === whole);
    const apply = set => text => {
      const wrong = set(text);
      if (!wrong) { this.end(); this.shown = false; this.about = JSON.parse(api.about()); this.compute(); }
      return wrong;
    };
    if (name === 'dt') return control({ name: 'time step', unit: 's', meaning: '', text: String(this.about.dt), lowest: 1e-3, highest: .2 }, apply(text => api.method(this.about.method, +text)));
    if (name === 'method') return control({ name, unit: '', meaning: '', text: this.about.method, choices: this.about.methods }, apply(text => api.method(text, this.about.dt)));
    if (!component) return control(parameter, apply(text => api.set(name, text)));
    const parts = parameter.text.split(','), at = 'xyz'.indexOf(component);
    return control({ ...parameter, name: `${whole} ${component}`, text: parts[at] }, apply(text => { parts[at] = text; return api.set(whole, parts.join(',')); }));
  }

  /** The curve of a ball, from the start to the end: points [x, y], the velocity upwards at each, the floor; by formula. */
  path(api, ball) {
    const columns = this.about.columns, balls = this.about.balls, wants = this.hasAttribute('exact') || this.axes[1].column === 'apart';
    const numbers = api.numbers(api.path(this.seconds, +this.get('rows', 1201), wants ? 1 : 0)), half = columns.length * balls, wide = 1 + half * (wants ? 2 : 1);
    const at = column => column === 't' ? 0 : 1 + ball * columns.length + columns.indexOf(column), y = at(this.axes[1].column === 'apart' ? 'y' : this.axes[1].column), x = at(this.axes[0].column);
    const v = columns.includes('v') ? at('v') : at('vy'), [from, to] = this.get('xrange', '-1e9,1e9').split(/[ ,]/).map(Number), path = { points: [], up: [], ground: [], exact: [], trouble: api.answer() };
    for (let i = 0; i + wide <= numbers.length; i += wide) {
      const across = numbers[i + x];
      if (across < from || across > to) continue;
      path.points.push([across, this.axes[1].column === 'apart' ? Math.abs(numbers[i + y] - numbers[i + y + half]) : numbers[i + y]]);
      path.up.push(numbers[i + v]);
      if (columns.includes('floor')) path.ground.push([across, numbers[i + at('floor')]]);
      if (this.hasAttribute('exact')) path.exact.push([numbers[i + x + (x ? half : 0)], numbers[i + y + half]]);
    }
    return path;
  }
  compute() {
    const before = performance.now();
    this.run = this.path(this.api, +this.get('ball', 0));
    if (this.other) this.pale_ ??= this.path(this.other, +this.get('ball', 0));
    if (this.hasAttribute('other')) this.pale_ = this.path(this.api, +this.get('other'));
    this.range();
    this.formula.setAttribute('d', this.d(this.run.exact));
    const level = this.about.columns.includes('y') && this.axes[1].column === 'y' && !this.hasAttribute('nofloor');
    this.floor.setAttribute('d', this.run.ground.length ? this.d(this.run.ground) : level ? `M${left} ${this.Y(0)}H${this.right}` : '');
    const { points, up } = this.run, { tops, touches } = moments(points, up), [what, which] = this.bet, n = (+which || 1) - 1;
    this.found = () => ({ top: tops[n], touch: touches[n], end: points.at(-1), tops: tops.reduce((best, top) => !best || Math.abs(top[1] - this.guess) < Math.abs(best[1] - this.guess) ? top : best, undefined) })[what];
    this.status.textContent = say(this.run.trouble) || (this.run.exact.length ? say('dashed: by formula') : '');
    this.cost = performance.now() - before;
    this.show(this.bet.length && !this.shown ? 0 : 1);
  }
  d(points) { return points.map(([x, y], i) => (i ? 'L' : 'M') + this.X(x).toFixed(1) + ' ' + Math.max(-1e4, Math.min(1e4, this.Y(y))).toFixed(1)).join(''); }
  /** What the axes show: all of the first curve, and more when a later one needs it. */
  range() {
    const all = [this.run, this.pale_].filter(Boolean).flatMap(r => [...r.points, ...r.ground, ...r.exact]).filter(p => p.every(Number.isFinite));
    [0, 1].forEach(i => {
      let low = Math.min(...all.map(p => p[i])), high = Math.max(...all.map(p => p[i]));
      if (i) { low = Math.min(low, 0); high += .08 * (high - low); }
      if (i && this.hasAttribute('yrange')) [low, high] = this.get('yrange').split(/[ ,]/).map(Number); // so that it does not tell the answer
      if (!(high > low)) high = low + 1;
      this.low ??= []; this.high ??= [];
      this.low[i] = Math.min(this.low[i] ?? low, Math.max(low, -1e3)); this.high[i] = Math.max(this.high[i] ?? high, Math.min(high, 1e3));
    });
    const [x0, y0] = this.low, [x1, y1] = this.high;
    this.X = x => left + (this.right - left) * (x - x0) / (x1 - x0);
    this.Y = y => bottom - (bottom - top) * (y - y0) / (y1 - y0);
    this.grid.replaceChildren();
    for (const [y, text] of ticks(y0, y1, 5)) { svg('path', { d: `M${left} ${this.Y(y)}H${this.right}`, class: 'grid' }, this.grid); svg('text', { x: left - 6, y: this.Y(y) + 5, class: 'end' }, this.grid).textContent = text; }
    for (const [x, text] of ticks(x0, x1, 6)) svg('text', { x: this.X(x), y: bottom + 18, class: 'middle' }, this.grid).textContent = text;
    svg('text', { x: this.right, y: H - 4, class: 'end' }, this.grid).textContent = this.axes[0].title;
    svg('text', { x: left - 40, y: 12 }, this.grid).textContent = this.axes[1].title;
  }
  /** The curve as far as this share of it. */
  show(share) {
    const count = Math.round(share * (this.run.points.length - 1)), head = this.run.points[count];
    const pale = this.pale_?.points ?? [], with_time = this.hasAttribute('other') ? Math.round(share * pale.length) : pale.length;
    this.pale.setAttribute('d', this.d(pale.slice(0, with_time)));
    this.line.setAttribute('d', share > 0 ? this.d(this.run.points.slice(0, count + 1)) : '');
    this.head.setAttribute('visibility', share > 0 && share < 1 ? 'visible' : 'hidden');
    if (head) { this.head.setAttribute('cx', this.X(head[0])); this.head.setAttribute('cy', this.Y(head[1])); }
    this.mark(share);
  }

  // ---- The bet
  get along() { return this.bet[0] === 'touch' ? 0 : 1; } // the axis that it is on
  get unit() { return this.axes[this.along].column === 't' ? 's' : 'm'; }
  buildFlag() {
    const { along } = this, goal = this.get('goal');
    this.answer = svg('circle', { r: 7, class: 'answer' }, this.svg);
    this.flag = svg('g', { class: 'flag' }, this.svg);
    svg('path', { d: along ? `M${left} 0H${this.right}` : `M0 ${top}V${bottom}` }, this.flag);
    svg('path', { d: along ? `M${left} 0l26 -9v18z` : `M0 ${bottom}l-9 -26h18z`, class: 'cloth' }, this.flag);
    this.put = value => {
      this.guess = Math.max(this.low[along], Math.min(this.high[along], value));
      this.flag.setAttribute('transform', along ? `translate(0 ${this.Y(this.guess)})` : `translate(${this.X(this.guess)} 0)`);
      if (!this.input) return;
      [this.input.min, this.input.max, this.input.value] = [this.low[along], this.high[along], this.guess];
      this.said.textContent = `${short(this.guess)} ${this.unit}`;
      this.input.setAttribute('aria-valuetext', this.said.textContent);
    };
    if (goal) { this.guess = +goal; return; }
    this.input = html('input', { type: 'range', step: 'any', 'aria-label': say('your bet'), oninput: () => this.put(+this.input.value) });
    this.said = html('output');
    this.play.parentElement.before(html('label', { className: 'row' }, html('span', {}, say('your bet')), this.input, this.said));
    const drag = event => {
      if (!event.buttons || this.shown) return;
      const box = this.svg.getBoundingClientRect(), x = (event.clientX - box.left) / box.width * this.wide, y = (event.clientY - box.top) / box.height * H;
      this.put(along ? this.low[1] + (bottom - y) / (bottom - top) * (this.high[1] - this.low[1]) : this.low[0] + (x - left) / (this.right - left) * (this.high[0] - this.low[0]));
    };
    this.svg.addEventListener('pointerdown', event => { this.svg.setPointerCapture(event.pointerId); drag(event); });
    this.svg.addEventListener('pointermove', drag);
    this.svg.style.touchAction = 'none';
  }
  mark(share) {
    if (!this.flag) return;
    const { along, unit, input } = this;
    this.put(this.guess ?? (this.low[along] + 2 * this.high[along]) / 3);
    if (input) input.disabled = share > 0;
    const found = share > 0 ? this.found() : undefined, is_there = found && share * (this.run.points.length - 1) >= this.run.points.indexOf(found);
    this.answer.setAttribute('visibility', is_there ? 'visible' : 'hidden');
    if (share === 0) this.status.textContent = input ? say(`Drag the flag to your bet: ${asked[this.bet.join('')] ?? asked.tops}.`) : say('Set your bet, then play.');
    if (share === 1 && !found) this.status.textContent = say('It does not come to that.');
    if (!is_there) return;
    this.answer.setAttribute('cx', this.X(found[0])); this.answer.setAttribute('cy', this.Y(found[1]));
    this.status.textContent = `${say(input ? 'your bet' : 'wanted')}: ${short(this.guess)} ${unit} · ${say('answer')}: ${short(found[along])} ${unit} · ${say('you are off by')} ${short(Math.abs(this.guess - found[along]))} ${unit}`;
  }

  // ---- Time
  toggle() {
    if (this.playing) return this.end();
    let t = 0, last = performance.now();
    this.length = this.hasAttribute('xrange') ? this.run.points.at(-1)[0] - this.run.points[0][0] : this.seconds;
    const rate = Math.max(1, this.length / 6);
    this.playing = true; this.shown = true; this.play.textContent = say('pause');
    const frame = now => {
      if (!this.playing) return;
      if (!this.seen) { this.parked = () => { last = performance.now(); requestAnimationFrame(frame); }; return; }
      t += Math.min(.1, (now - last) / 1000) * rate;
      last = now;
      this.frames = (this.frames ?? 0) + 1;
      if (t >= this.length) return this.end();
      this.show(t / this.length);
      requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
  }
  end() {
    if (this.playing) { this.playing = false; this.show(1); }
    this.play.textContent = this.bet.length ? say('play and see') : say('play');
  }
}
customElements.define('bounce-figure', Figure);

// <bounce-stage name="03_damping" words="--set damping=18">: a whole stage in a lesson. The C++ draws its picture on a <canvas>;
// what can be moved are the page's own elements, made from the stage's table of parameters. Attribute `at`: it has run so far
// [s]; `errors`: speed against error, at once. What stands between the tags (the lesson's picture) is seen until then, and where there is no JavaScript.
import { start } from './module.js';
import { penFor } from './pen.js';
import { control, html, named, say, watch } from './words.js';

const scene = [0, 0, 748, 540], energy = [748, 0, 92, 540], plots = [[0, 540, 420, 180], [420, 540, 420, 180]], chart = [64, 16, 340, 452], strip = [0, 540, 840, 180];
const held = { ArrowLeft: 1, ArrowRight: 2, ArrowUp: 4, ArrowDown: 8, ' ': 16, a: 32, d: 64, w: 128, s: 256 }; // a game's, while they are down
const smallest = 11; // px, of text
const short = value => Math.abs(value) < 1e-12 ? '0' : String(+value.toPrecision(3));
const steps = [1e-5, 2e-5, 5e-5, 1e-4, 2e-4, 5e-4, 1e-3, 2e-3, 5e-3, 1e-2, 2e-2, 5e-2, 0.1];

/** Where the parts of the picture go on a canvas of this width, and how high it is: as in the window, or on a phone below each other. */
function arrange(width, about, { errors, surveyed, section }) {
  const put = (part, from, x, y, scale) => ({ part, from, x, y, scale });
  if (about.game) { const across = width > 620 ? 1280 : 720; return { height: width * 720 / across, parts: [put(0, [0, 0, across, 720], 0, 0, width / across)] }; }
  if (width > 620) {
    const s = width / 840, all = [put(0, scene, 0, 0, s), put(1, energy, 748 * s, 0, s),
      ...(surveyed && !section ? [put(5, strip, 0, 540 * s, s)] : [put(surveyed ? 5 : 2, plots[0], 0, 540 * s, s), put(3, plots[1], 420 * s, 540 * s, s)])];
    return { height: 720 * s, parts: errors ? [...all, put(4, chart, 64 * s, 16 * s, s)] : all };
  }
  const s = width / 840, t = width / 440, c = width / 340, top = errors ? 452 * c : 540 * s;
  const first = errors ? [put(4, chart, 0, 0, c)] : [put(0, scene, 0, 0, s), put(1, energy, 748 * s, 0, s)];
  return { height: top + 2 * 180 * t, parts: [...first, put(surveyed ? 5 : 2, plots[0], 0, top, t), put(3, plots[1], 0, top + 180 * t, t)] };
}

let audio = null; // begins with the first gesture
function knock(speed) { // as of a bar that is hit: the faster, the louder and the brighter (common/app/sound.cpp)
  const strength = Math.min(1, Math.max(.05, speed / 6)), now = audio.currentTime;
  for (const [times, share] of [[1, .7], [2.76, .3]]) {
    const tone = audio.createOscillator(), loud = audio.createGain();
    tone.frequency.value = (220 + 260 * strength) * times;
    loud.gain.setValueAtTime(0, now); loud.gain.linearRampToValueAtTime(.6 * strength * share, now + .001); loud.gain.setTargetAtTime(0, now + .001, .018);
    tone.connect(loud).connect(audio.destination); tone.start(now); tone.stop(now + .12);
  }
}

class Stage extends HTMLElement {
  connectedCallback() {
    watch(this, () => this.begin().catch(error => { this.append(html('p', { className: 'warning' }, String(error.message ?? error))); console.error(error); }),
      seen => { this.seen = seen; this.wake(); });
  }

  async begin() {
    const began = performance.now();
    this.canvas = html('canvas', { tabIndex: 0, role: 'application' });
    this.ctx = this.canvas.getContext('2d', { alpha: false });
    const api = this.api = await start(this.getAttribute('name'), this.getAttribute('words') ?? '', penFor(this.ctx));
    this.about = JSON.parse(api.about());
    if (this.hasAttribute('errors')) api.press('e'.charCodeAt());
    this.runTo(Number(this.getAttribute('at')));
    if (matchMedia('(prefers-reduced-motion: reduce)').matches) { api.see('calm', 1); api.see('trail', 0); }
    this.canvas.setAttribute('aria-label', `${say(this.about.title)}. ${say(this.about.question)} P: ${say('play')}, F1: ${say('help')}.`);
    this.down = 0; this.frames = 0; this.costs = []; this.parts = [];
    this.build(); this.listen(); this.update(); this.draw();
    this.ready = performance.now() - began;
    this.wake();
  }

  /** As far as the moment that the lesson talks about. */
  runTo(at) {
    const { api } = this, now = () => JSON.parse(api.state()).t;
    if (!at) return;
    api.see('forces', 1); // as in the picture whose place it takes
    api.press('p'.charCodeAt());
    for (let t = now(), n = 0; t < at - 1e-9 && n < 1000; t = now(), ++n) api.move(Math.min(.05, at - t));
    api.press('p'.charCodeAt());
  }

  // ---- What can be moved
  build() {
    const { api, about } = this;
    const button = (text, key, title = text) => html('button', { type: 'button', title: say(title), 'aria-label': say(title), onclick: event => this.press(key, event.detail > 0) }, text === title ? say(text) : text);
    const see = (what, text = what) => html('button', { type: 'button', onclick: () => { api.see(what, this.state[what] ? 0 : 1); this.changed(); } }, say(text));
    this.play = button('play', 'p'); this.play.className = 'play';
    this.toggles = about.game ? { muted: button('sound', 'm'), help: button('help', '?') } : {
      slow: button('slow', 'o'), lens: button('lens', 'l'), forces: see('forces'), exact: see('exact', about.truth), trail: see('trail'),
      ...(about.space ? { above: button('from above', 't') } : {}), errors: button('errors', 'e'),
      ...(about.survey ? { survey: button(`every ${about.survey}`, 'b'), section: button('section', 'n') } : {}), help: button('help', '?') };
    this.scrub = html('input', { type: 'range', min: 0, max: 1, step: 'any', 'aria-label': say('time'), oninput: () => { api.go_back(+this.scrub.value); this.changed(); } });
    this.clock = html('output'); this.facts = html('p', { className: 'facts' });
    this.energies = ['height', 'spring', 'motion', 'lost'].map(name => { const number = html('b'); return { name, number, item: html('span', { className: name }, say(name) + ' ', number) }; });
    this.energy = html('p', { className: 'energy' }, say('energy'), ...this.energies.map(e => e.item));
    this.warning = html('p', { className: 'warning', 'aria-live': 'polite' });
    this.help = html('div', { className: 'keys', hidden: true }, ...about.keys.map(text => html('span', {}, say(text))));
    this.controls = new Map();
    const row = parameter => {
      const one = control(parameter, text => { const wrong = api.set(parameter.name, text); this.changed(); return wrong; });
      this.controls.set(parameter.name, one);
      return one;
    };
    const main = [...about.dials, ...about.sliders.map(name => about.parameters.find(p => p.name === name))];
    const rest = about.parameters.filter(p => !about.sliders.includes(p.name));
    this.method = html('select', { onchange: () => this.useMethod() }, ...about.methods.map(m => html('option', { value: m }, m)));
    this.dt = html('select', { onchange: () => this.useMethod() });
    const copy = html('button', { type: 'button', onclick: async () => {
      try { await navigator.clipboard.writeText('./course play ' + this.command()); copy.textContent = say('copied'); } catch { copy.textContent = './course play ' + this.command(); }
    } }, say('copy the command'));
    const full = html('button', { type: 'button', onclick: () => this.canvas.requestFullscreen?.() }, say('full screen'));
    const swing = html('button', { type: 'button', onpointerdown: () => this.hold(16, true), onpointerup: () => this.hold(16, false), onpointerleave: () => this.hold(16, false) }, say('swing'));
    const buttons = [this.play, button('◂', ',', 'step back'), button('▸', '.', 'step forward'), button('restart', 'r'), ...Object.values(this.toggles), ...(about.game ? [swing, button('next game', 'g'), full] : [])];
    this.replaceChildren(this.canvas, html('p', { className: 'question' }, html('b', {}, say(about.title) + '. '), about.game ? '' : say(about.question)),
      html('div', { className: 'buttons' }, ...buttons), this.help, ...(about.game ? [this.warning] : [
        html('div', { className: 'row' }, html('span', {}, say('time')), this.scrub, this.clock), ...main.map(row),
        html('label', { className: 'row' }, html('span', {}, say('method')), this.method, html('output')),
        html('label', { className: 'row' }, html('span', {}, say('time step')), this.dt, html('output')), this.energy, this.facts, this.warning,
        html('details', {}, html('summary', {}, say('more parameters')), ...rest.map(row), copy)]));
  }
  useMethod() { this.warning.textContent = say(this.api.method(this.method.value, +this.dt.value)); this.changed(); }
  command() { return JSON.parse(this.api.about()).command.replace(/^0?(\d+)\S*/, '$1'); }

  /** After what a reader did: the controls show what holds now, and the picture is drawn anew. */
  changed() {
    this.about = JSON.parse(this.api.about());
    this.update(); this.wake(); this.once = true;
  }
  update() {
    const { about } = this;
    for (const parameter of [...about.parameters, ...about.dials]) this.controls.get(parameter.name)?.show(parameter.text);
    this.method.value = about.method;
    this.dt.disabled = about.by_events;
    this.dt.replaceChildren(...[...new Set([...steps, about.dt])].sort((a, b) => a - b).map(dt => html('option', { value: dt, selected: dt === about.dt }, dt + ' s')));
    this.tell();
  }
  /** Ten times a second at most: numbers beside the picture. */
  tell() {
    const state = this.state = JSON.parse(this.api.state());
    const put = (element, text) => { if (element.textContent !== text) element.textContent = text; };
    put(this.play, say(state.paused ? 'play' : 'pause')); this.play.setAttribute('aria-label', this.play.textContent);
    for (const [name, button] of Object.entries(this.toggles)) button.setAttribute('aria-pressed', name === 'muted' ? !state.muted : state[name]);
    put(this.warning, state.trouble ? '! ' + say(state.trouble) : '');
    if (this.about.game) return;
    this.help.hidden = !state.help;
    this.scrub.min = state.earliest; this.scrub.max = Math.max(state.t, state.earliest + 1e-9); this.scrub.value = state.t;
    put(this.clock, state.t.toFixed(2) + ' s');
    for (const { name, number } of this.energies) put(number, short(state[name]) + ' J');
    put(this.facts, [state.evaluations ? say(`${short(state.evaluations)} force evaluations a second`) : say('by formula, without steps'),
      state.off === null ? '' : say(`off by ${short(state.off)} m`), state.rate === 1 ? '' : say(`time runs at ${state.rate.toPrecision(2)}`)].filter(Boolean).join(' · '));
  }

  // ---- Keys and pointer. Keys count only while the picture has the focus.
  press(key, byPointer = false) {
    if (!this.api.press(key.charCodeAt())) return false;
    if (key === 'n' && this.about.game) document.getElementById('theme')?.click(); // by night: the page's own switch
    if (byPointer && (key === 'p' || this.about.game)) this.canvas.focus({ preventScroll: true });
    this.changed();
    return true;
  }
  hold(bit, on) { this.api.hold(this.down = on ? this.down | bit : this.down & ~bit); if (on) this.wake(); }
  listen() {
    const { canvas, about } = this, wake = () => { audio ??= new (window.AudioContext ?? window.webkitAudioContext)(); };
    this.addEventListener('pointerdown', wake); this.addEventListener('keydown', wake);
    canvas.onkeydown = event => {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      const key = event.key.length === 1 ? event.key.toLowerCase() : event.key, bit = about.game && held[key];
      if (bit) { this.hold(bit, true); event.preventDefault(); return; }
      const code = { ArrowRight: '.', ArrowLeft: ',', F1: '?', '=': '+' }[key] ?? key;
      if (code.length === 1 && this.press(code)) event.preventDefault();
    };
    canvas.onkeyup = event => { const bit = held[event.key.length === 1 ? event.key.toLowerCase() : event.key]; if (bit) this.hold(bit, false); };
    canvas.onblur = () => this.hold(~0, false);
    const point = (kind, event) => { // in pixels of the window, within the part that is there
      const box = canvas.getBoundingClientRect(), share = Math.min(box.width / this.wide, box.height / this.high); // in full screen there is a margin
      const x = (event.clientX - box.left - (box.width - this.wide * share) / 2) / share, y = (event.clientY - box.top - (box.height - this.high * share) / 2) / share;
      const part = this.parts.findLast(p => x >= p.x && y >= p.y && x <= p.x + p.from[2] * p.scale && y <= p.y + p.from[3] * p.scale) ?? this.parts[0];
      return this.api.pointer(kind, part.from[0] + (x - part.x) / part.scale, part.from[1] + (y - part.y) / part.scale);
    };
    canvas.style.touchAction = about.game ? 'none' : 'pan-y';
    const is_second = event => about.game && event.pointerType === 'touch' && !event.isPrimary; // on a game a finger moves; a second one is the button, and so is a tap
    canvas.onpointermove = event => { if (is_second(event)) return; point(0, event); if (!this.state.paused || this.used) this.wake(); };
    canvas.onpointerdown = event => {
      if (is_second(event)) { this.hold(16, true); return; }
      if (event.isPrimary) this.since = [event.timeStamp, event.clientX, event.clientY];
      canvas.focus({ preventScroll: true });
      this.used = point(about.game && event.pointerType === 'touch' && event.isPrimary ? 0 : 1, event);
      if (this.used) canvas.setPointerCapture(event.pointerId);
      this.changed();
    };
    canvas.onpointerup = canvas.onpointercancel = event => {
      if (is_second(event)) { this.hold(16, false); return; }
      const [t, x, y] = this.since ?? [0, 0, 0];
      if (about.game && event.type === 'pointerup' && event.pointerType === 'touch' && event.isPrimary && event.timeStamp - t < 200 && Math.hypot(event.clientX - x, event.clientY - y) < 20) {
        this.hold(16, true);
        setTimeout(() => this.hold(16, false), 250);
      }
      point(2, event); this.used = 0; this.changed();
    };
    canvas.addEventListener('touchstart', event => { if (this.used) event.preventDefault(); }, { passive: false });
    new ResizeObserver(() => this.wake()).observe(canvas);
    new MutationObserver(() => this.wake()).observe(document.documentElement, { attributeFilter: ['data-theme'] });
  }

  // ---- Frames: only while it is seen, and runs, or something changed
  wake() {
    this.once = true;
    if (this.api && this.seen && !this.running) { this.running = true; this.last = 0; requestAnimationFrame(now => this.frame(now)); }
  }
  frame(now) {
    const before = performance.now(), seconds = this.last ? Math.min(.1, (now - this.last) / 1000) : 0;
    this.last = now; this.once = false;
    this.api.move(seconds);
    const speed = this.api.knock();
    if (speed > 0 && audio) { audio.resume(); knock(speed); }
    this.draw();
    if (now - (this.told ?? 0) > 100) { this.told = now; this.tell(); }
    ++this.frames; this.costs.push(performance.now() - before); if (this.costs.length > 600) this.costs.shift();
    const goes = this.seen && (!this.state.paused || this.used || this.state.busy || this.once);
    if (goes) requestAnimationFrame(next => this.frame(next)); else { this.running = false; this.tell(); }
  }
  draw() {
    const { canvas, ctx, api } = this, { pen } = api, full = document.fullscreenElement === canvas;
    const wide = full ? Math.min(innerWidth, innerHeight * 1280 / 720) : canvas.clientWidth, { height, parts } = arrange(wide, this.about, this.state);
    api.see('narrow', wide > 620 ? 0 : 1);
    const dots = Math.min(3, devicePixelRatio || 1), w = Math.round(wide * dots), h = Math.round(height * dots);
    if (canvas.width !== w || canvas.height !== h) { canvas.width = w; canvas.height = h; canvas.style.aspectRatio = `${w}/${h}`; }
    this.wide = wide; this.high = height; this.parts = parts;
    if (this.about.game) api.size(parts[0].from[2], 720);
    pen.dark = document.documentElement.dataset.theme === 'dark';
    ctx.setTransform(1, 0, 0, 1, 0, 0); ctx.fillStyle = pen.colour(0xfafaf7ff); ctx.fillRect(0, 0, w, h);
    for (const { part, from, x, y, scale } of parts) {
      ctx.save();
      ctx.setTransform(scale * dots, 0, 0, scale * dots, (x - from[0] * scale) * dots, (y - from[1] * scale) * dots);
      if (part === 0 || part === 4) { ctx.beginPath(); ctx.rect(...from); ctx.clip(); }
      pen.grow = part === 1 && scale < .7 ? 0 : Math.max(1, Math.min(2.6, smallest / (13 * scale)));
      if (part === 4) { ctx.fillStyle = pen.colour(0xfafaf7ff); ctx.fillRect(...from); }
      api.draw(part);
      pen.flush();
      ctx.restore();
    }
  }
}
customElements.define('bounce-stage', Stage);

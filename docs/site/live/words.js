// Words of the figures, and elements of the page.
const known = new Map(), patterns = []; // what the page's language says, if it is not English
const escaped = text => text.replace(/[.+?^${}()|[\]\\]/g, '\\$&');

/** Takes a table from English to another language (ja.js). A * stands for what is put in. */
export function learn(table) {
  for (const [english, other] of Object.entries(table)) {
    if (english.includes('*')) patterns.push([new RegExp(`^${escaped(english).replaceAll('*', '(.+?)')}$`), other.split('*')]); else known.set(english, other);
  }
}
/** The text in the language of the page; as it is, where no table has it. */
export function say(text) {
  if (!patterns.length || known.has(text)) return known.get(text) ?? text;
  for (const [pattern, parts] of patterns) {
    const found = text.match(pattern);
    if (found) return parts.map((part, i) => part + (i < found.length - 1 ? say(found[i + 1]) : '')).join('');
  }
  const sentences = text.replace(/\. +(?=[A-Z])/g, '.\n').split('\n');
  return sentences.length > 1 ? sentences.map(say).join(' ') : text;
}
/** A parameter's name, or one component of it: 'racket_velocity y'. */
export const named = name => name.replaceAll('_', ' ').replace(/^(.+?)( [xyz])?$/, (whole, of, axis = '') => say(of) + axis);

/** An element of the page: html('button', { onclick }, 'play'). What begins with aria- or is `role` becomes an attribute. */
export function html(name, properties = {}, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(properties)) if (/^aria-|^role$|^for$/.test(key)) element.setAttribute(key, value); else element[key] = value;
  element.append(...children);
  return element;
}

/** A slider for a parameter, or one for each component of it, or its choices. `set(text)` returns what is wrong, or ''. */
export function control(parameter, set) {
  const { name, text, lowest, highest, whole, choices } = parameter, label = named(name), unit = say(parameter.unit), meaning = say(parameter.meaning);
  if (choices) {
    const select = html('select', { onchange: () => set(select.value), title: meaning }, ...choices.map(c => html('option', { value: c, selected: c === text }, c)));
    select.show = text => { select.value = text; };
    return Object.assign(html('label', { className: 'row' }, html('span', {}, label), select, html('output')), { show: select.show });
  }
  const log = lowest > 0 && highest >= 50 * lowest; // as many places for each power of ten
  const value = x => { const v = log ? lowest * (highest / lowest) ** x : lowest + (highest - lowest) * x; return whole ? Math.round(v) : v; };
  const place = v => log ? Math.log(v / lowest) / Math.log(highest / lowest) : (v - lowest) / (highest - lowest);
  const out = html('output', {}), round = v => String(+(+v).toPrecision(4));
  const show = text => { out.textContent = text.split(',').map(round).join(', ') + (unit ? ' ' + unit : ''); };
  const inputs = text.split(',').map((part, i, all) => html('input', { type: 'range', min: 0, max: 1, step: 'any', value: place(+part), title: meaning,
    'aria-label': label + (all.length > 1 ? ' ' + 'xyz'[i] : '') + ': ' + meaning, oninput: () => {
      const wanted = inputs.map(input => round(value(+input.value))).join(','), wrong = set(wanted);
      if (wrong) out.textContent = say(wrong); else show(wanted);
      inputs[i].setAttribute('aria-valuetext', out.textContent);
    } }));
  show(text);
  const row = html('div', { className: 'row' }, html('span', { title: meaning }, label), html('span', { className: 'sliders' }, ...inputs), out);
  /** Moves the slider to another value without setting it. */
  row.show = text => { if (!row.contains(document.activeElement)) { text.split(',').forEach((part, i) => { inputs[i].value = place(+part); }); show(text); } };
  row.inputs = inputs; row.value = value; row.place = place;
  return row;
}

/** Calls `begin` when the element comes near, and `seen(whether)` as it comes into view and leaves it, or its tab does. */
export function watch(element, begin, seen) {
  let inside = false;
  const tell = () => seen(inside && !document.hidden);
  new IntersectionObserver(list => { inside = list.at(-1).isIntersecting; tell(); }).observe(element);
  document.addEventListener('visibilitychange', tell);
  const near = new IntersectionObserver(list => { if (list.at(-1).isIntersecting) { near.disconnect(); begin(); } }, { rootMargin: '600px' });
  near.observe(element);
}

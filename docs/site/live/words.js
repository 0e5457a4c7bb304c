// What the figures say, by the language of the page. (What a parameter means comes from the C++, in English.)
const said = {
  ja: {
    play: '再生', pause: '一時停止', restart: '最初から', 'step back': '一歩戻る', 'step forward': '一歩進む', slow: 'スロー', lens: '接触レンズ',
    time: '時間', method: '計算法', 'time step': '時間刻み', forces: '力', exact: '厳密解', trail: '軌跡', 'from above': '真上から', errors: '誤差と計算量', 'every amplitude': 'すべての振幅', section: 'ポアンカレ断面',
    energy: 'エネルギー', spring: 'ばね', motion: '運動', lost: '失われた分', sound: '音', help: 'キー一覧', 'full screen': '全画面', swing: '打つ', 'next game': '次の遊び方', 'more parameters': 'その他のパラメータ', 'copy the command': 'コマンドをコピー', copied: 'コピーしました',
    'off by': '厳密解とのずれ', 'force evaluations a second': '力の計算 (毎秒)', 'by formula, without steps': '数式による (刻みなし)', 'time runs at': '時間の速さ',
    'dashed: by formula': '破線: 数式による', height: '高さ', 'your bet': 'あなたの予想', answer: '答え', 'you are off by': '予想とのずれ', 'play and see': '再生して確かめる', 'bet again': '予想し直す',
    'how far apart': '差', wanted: '目標', 'Set your bet, then play.': '予想を決めてから再生する。', 'pale: ': '淡い線: ', 'pale: the other ball': '淡い線: もう一つのボール',
    'Drag the flag to your bet': '旗を予想の位置まで動かす', 'the height of the first top': '最初の頂点の高さ', 'the height of the third top': '三番目の頂点の高さ', 'the height of a top': '頂点の高さ',
    'when the first touch begins': '最初に触れる時刻', 'where the fourth touch begins': '四回目に触れる位置', 'where the curve ends': '曲線の終わりの値', 'It does not come to that.': 'そこまで起こらない。',
    mass: '質量', gravity: '重力加速度', position: '初期位置', velocity: '初速度', radius: '半径', stiffness: 'ばね定数', damping: '減衰係数', contact: '接触',
    amplitude: '振幅', 'angular frequency': '角振動数', phase: '位相', normal: '法線', tilt: '傾き', scene: '場面', gap: '隙間', count: '個数',
  },
};
export const say = (text, element) => said[(element.closest('[lang]')?.lang || 'en').slice(0, 2)]?.[text] ?? text;
export const named = (name, element) => say(name.replaceAll('_', ' '), element);

/** An element of the page: html('button', { onclick }, 'play'). What begins with aria- or is `role` becomes an attribute. */
export function html(name, properties = {}, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(properties)) if (/^aria-|^role$|^for$/.test(key)) element.setAttribute(key, value); else element[key] = value;
  element.append(...children);
  return element;
}

/** A slider for a parameter, or one for each component of it, or its choices. `set(text)` returns what is wrong, or ''. */
export function control(parameter, element, set) {
  const { name, unit, meaning, text, lowest, highest, whole, choices } = parameter, label = named(name, element);
  if (choices) {
    const select = html('select', { onchange: () => set(select.value), title: meaning }, ...choices.map(c => html('option', { value: c, selected: c === text }, c)));
    select.show = text => { select.value = text; };
    return Object.assign(html('label', { className: 'row' }, html('span', {}, label), select, html('output')), { show: select.show });
  }
  const log = lowest > 0 && highest >= 50 * lowest; // as many places for each power of ten
  const value = x => { const v = log ? lowest * (highest / lowest) ** x : lowest + (highest - lowest) * x; return whole ? Math.round(v) : v; };
  const place = v => log ? Math.log(v / lowest) / Math.log(highest / lowest) : (v - lowest) / (highest - lowest);
  const out = html('output', {}), round = v => String(+(+v).toPrecision(4));
  const say_ = text => { out.textContent = text.split(',').map(round).join(', ') + (unit ? ' ' + unit : ''); };
  const inputs = text.split(',').map((part, i, all) => html('input', { type: 'range', min: 0, max: 1, step: 'any', value: place(+part), title: meaning,
    'aria-label': label + (all.length > 1 ? ' ' + 'xyz'[i] : '') + ': ' + meaning, oninput: () => {
      const wanted = inputs.map(input => round(value(+input.value))).join(','), wrong = set(wanted);
      if (wrong) out.textContent = wrong; else say_(wanted);
      inputs[i].setAttribute('aria-valuetext', out.textContent);
    } }));
  say_(text);
  const row = html('div', { className: 'row' }, html('span', { title: meaning }, label), html('span', { className: 'sliders' }, ...inputs), out);
  /** Moves the slider to another value without setting it. */
  row.show = text => { if (!row.contains(document.activeElement)) { text.split(',').forEach((part, i) => { inputs[i].value = place(+part); }); say_(text); } };
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

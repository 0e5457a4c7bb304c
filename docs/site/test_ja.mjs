// A Japanese page speaks Japanese in its figures, too: on their canvas, in their controls, and when something is wrong. Part of test.mjs.
// English stays what is typed on a command line (methods, choices, parameters' words), units, and what is printed on keys.
const names = /^(semi-implicit-euler|explicit-euler|velocity-verlet|rk4|rk4-events|flight-rk4|exact|reference|euler|may-pull|push-only|relative|absolute|fixed-switch|pair|break|cradle|tower|drop|keep-up|target|blind|slowing|speeding|on|off|none|nonsense|player|dt|auto|course|play|set|LX|LZ|Space|Esc)$/;
const units = /^(kg|rad|cm|mm|um|nm|pm|km|ms|us|ns|mN|uN|kN|MN|mJ|uJ|nJ|pJ|kJ|GN|e)$/;

const listen = () => {
  window.drawn = new Set();
  const own = CanvasRenderingContext2D.prototype.fillText;
  CanvasRenderingContext2D.prototype.fillText = function (words, ...rest) { window.drawn.add(words); own.call(this, words, ...rest); };
};
const english = texts => [...new Set(texts.flatMap(text => (text.match(/[A-Za-z][\w-]+/g) ?? []).filter(word => !names.test(word) && !units.test(word) && !/^(\d|rk|[A-Z]\d|e-?\d)/.test(word)).map(word => `${word} (in: ${text})`)))];

export async function testJapanese({ check, open, close, startAll, lessons, both, shots }) {
  await both(lessons, async path => {
    const page = await open(1280, 'light', path, listen);
    const figures = await startAll(page, path);
    for (let i = 0; i < await figures.count(); ++i) {
      await figures.nth(i).scrollIntoViewIfNeeded();
      await figures.nth(i).evaluate(async figure => {
        const frame = () => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)));
        if (figure.localName === 'bounce-figure') { figure.querySelector('.play').click(); await frame(); figure.toggle(); return; }
        for (const what of ['forces', 'survey', 'section']) figure.api.see(what, 1);
        figure.changed(); await frame();
        for (const key of figure.about.game ? '?gg?p' : 'p?etotlp') { figure.press(key); await frame(); }
        for (const { name } of figure.about.parameters) { // what is refused is said in Japanese
          const wrong = figure.api.set(name, 'nonsense'), { say } = await import(new URL('../live/words.js', document.baseURI));
          window.drawn.add(say(wrong).replace(name, ''));
        }
        if (!figure.about.game) { figure.api.method('explicit-euler', 0.1); figure.changed(); figure.tell(); await frame(); }
      });
    }
    const texts = await page.evaluate(() => [...window.drawn, ...[...document.querySelectorAll(':is(bounce-stage, bounce-figure) :not(option, script)')].flatMap(element =>
      [...[...element.childNodes].filter(node => node.nodeType === 3).map(node => node.data), element.title ?? '', element.getAttribute('aria-label') ?? '', element.getAttribute('aria-valuetext') ?? ''])]);
    check(texts.length > 80, `${path}: only ${texts.length} texts are seen`);
    const left = english(texts);
    check(!left.length, `${path}: English in the figures:\n  ${left.join('\n  ')}`);
    await figures.first().scrollIntoViewIfNeeded();
    await figures.first().screenshot({ path: `${shots}/words_${path.replaceAll('/', '_')}.png` });
    await close(page);
  });
}

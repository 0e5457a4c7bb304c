// What hands do with the game, and what a page does when nobody looks: touch, sound, full screen, a tab behind another. Part of test.mjs.

/** Notes when a page begins to make sounds, and every tone that it plans. It is still the browser's own AudioContext. */
const spy = () => {
  window.sounds = [];
  const Own = window.AudioContext;
  window.AudioContext = class extends Own {
    constructor() { super(); window.sounds.push({ kind: 'begin', allowed: navigator.userActivation.isActive }); }
    createOscillator() {
      const tone = super.createOscillator(), start = tone.start.bind(tone);
      tone.start = when => { window.sounds.push({ kind: 'tone', when, now: this.currentTime, state: this.state }); start(when); };
      return tone;
    }
  };
};
const canvasOf = page => stage(page).locator('canvas');
const stage = page => page.locator('bounce-stage').first();
/** Where the racket is [m], from the numbers that --save would write (round.hpp). */
const racket = page => stage(page).evaluate(({ api }) => { const all = api.numbers(api.memory()); return { x: all[9], y: all[11], z: all[13] }; });
const touches = page => page.evaluate(() => window.sounds.filter(sound => sound.kind === 'tone').length);

export async function testHands({ check, open, close, ready }) {
  // ---- Two fingers on a phone
  let page = await open(390, 'light', '08_racket_game.html');
  await stage(page).scrollIntoViewIfNeeded();
  await ready(page);
  await canvasOf(page).evaluate(element => element.scrollIntoView({ block: 'center' }));
  const box = await canvasOf(page).boundingBox(), cdp = await page.context().newCDPSession(page);
  const fingers = (type, ...all) => cdp.send('Input.dispatchTouchEvent', { type, touchPoints: all.map(([x, y], id) => ({ x: box.x + x * box.width, y: box.y + y * box.height, id })) });
  const settle = () => page.waitForTimeout(400);
  await stage(page).locator('.play').tap();
  await fingers('touchStart', [.5, .7]);
  await settle();
  const middle = await racket(page);
  await fingers('touchMove', [.8, .7]);
  await settle();
  const aside = await racket(page);
  check(aside.x - middle.x > .15, `one finger moves to the right, and the racket goes from ${middle.x} to ${aside.x} m`);
  check(Math.abs(aside.y - middle.y) < .02, `one finger alone swings: the racket goes from ${middle.y} to ${aside.y} m`);
  const scrolled = await page.evaluate(() => scrollY);
  await fingers('touchStart', [.8, .7], [.2, .5]);
  let highest = aside.y, x = aside.x;
  for (let look = 0; look < 15; ++look) { const now = await racket(page); highest = Math.max(highest, now.y); x = now.x; await page.waitForTimeout(20); }
  check(highest - aside.y > .05, `a second finger goes down, and the racket only rises by ${highest - aside.y} m`);
  check(Math.abs(x - aside.x) < .05, `a second finger swings, and the racket moves from ${aside.x} to ${x} m`);
  await fingers('touchEnd');
  await fingers('touchStart', [.8, .7]);
  await fingers('touchMove', [.8, .3]);
  await fingers('touchEnd');
  check(scrolled === await page.evaluate(() => scrollY), 'a finger on the game moves the page');
  await close(page);

  // ---- Sound: none before a gesture; then a tone at each touch
  page = await open(1280, 'light', '08_racket_game.html', spy);
  await ready(page);
  await page.mouse.move(2, 400); // beside the game
  await page.waitForTimeout(300);
  check(await page.evaluate(() => window.sounds.length) === 0, 'a page makes an AudioContext before any gesture');
  await canvasOf(page).focus();
  await page.keyboard.press('p');
  await page.waitForFunction(() => window.sounds.some(sound => sound.kind === 'tone'), null, { timeout: 20000 }).catch(() => {});
  const sounds = await page.evaluate(() => window.sounds);
  check(sounds[0]?.kind === 'begin' && sounds[0].allowed, `sound does not begin with a gesture: ${JSON.stringify(sounds[0])}`);
  const tone = sounds.find(sound => sound.kind === 'tone');
  check(tone?.state === 'running' && Math.abs(tone.when - tone.now) < .1, `the first touch makes no tone at once: ${JSON.stringify(tone)}`);
  await stage(page).getByText('sound', { exact: true }).click();
  const before = await touches(page), hits = () => stage(page).evaluate(({ api }) => JSON.parse(api.state()).t);
  const then = await hits();
  await page.waitForTimeout(3000);
  check(await hits() > then + 1 && await touches(page) === before, 'it sounds where the sound is off');

  // ---- By night, and in full screen
  await canvasOf(page).focus();
  await page.keyboard.press('n');
  check(await page.evaluate(() => document.documentElement.dataset.theme) === 'dark', 'N does not make a game dark');
  await stage(page).getByText('full screen').click();
  await page.waitForFunction(() => document.fullscreenElement, null, { timeout: 5000 }).catch(() => {});
  await page.waitForTimeout(300);
  const full = await page.evaluate(() => { const { width: w, height: h, localName: tag } = document.fullscreenElement ?? {}; return { tag, w, h, wide: innerWidth, high: innerHeight }; });
  check(full.tag === 'canvas' && full.w === full.wide && Math.abs(full.w / full.h - 16 / 9) < .02, `the game does not fill the screen: ${JSON.stringify(full)}`);
  const aim = async (x, y) => { await page.mouse.move(x, y, { steps: 3 }); await page.waitForTimeout(2500); return racket(page); };
  const there = await aim(.75 * 1280, 90 + .7 * 720); // the picture is 1280 x 720 in the middle of 1280 x 900
  await page.evaluate(() => document.exitFullscreen());
  await page.waitForTimeout(300);
  await canvasOf(page).scrollIntoViewIfNeeded();
  const place = await canvasOf(page).boundingBox(), here = await aim(place.x + .75 * place.width, place.y + .7 * place.height);
  check(Math.abs(there.x - here.x) < .02 && Math.abs(there.z - here.z) < .02 && Math.abs(here.x) > .2, `the mouse means another place in full screen: ${JSON.stringify([there, here])}`);
  check(await canvasOf(page).evaluate(canvas => Math.abs(canvas.clientWidth / canvas.clientHeight - 16 / 9) < .02 && canvas.clientWidth < 800), 'after full screen the picture is not as before');

  // ---- A tab behind another costs nothing, and goes on when it is seen
  // A browser without a window hides no tab. So the page is told as a browser would; here frames still come to who asks for them.
  const frames = () => stage(page).evaluate(element => element.frames);
  const hide = hidden => page.evaluate(hidden => { Object.defineProperty(document, 'hidden', { configurable: true, value: hidden }); document.dispatchEvent(new Event('visibilitychange')); }, hidden);
  await page.keyboard.press('r');
  await page.waitForTimeout(200);
  const seen = await frames();
  await page.waitForTimeout(300);
  check(await frames() > seen, 'the game does not run before its tab is hidden');
  await hide(true);
  await page.waitForTimeout(200);
  const hidden = await frames();
  await page.waitForTimeout(1000);
  check(await frames() === hidden, `a hidden tab draws ${await frames() - hidden} frames in a second`);
  await hide(false);
  await page.waitForTimeout(500);
  check(await frames() > hidden, 'a tab that is seen again stands still');
  await close(page);
}

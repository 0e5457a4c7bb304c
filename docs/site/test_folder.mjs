// The site as a folder on a stick: opened as a file, without a server. Part of test.mjs.
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

export async function testFolder({ check, browser, site, startAll }) {
  for (const path of ['02_spring_floor.html', '06_oscillating_floor.html', '08_racket_game.html', 'ja/03_damping.html', 'deeper/05_ball_collision.html']) {
    const page = await browser.newPage({ viewport: { width: 1280, height: 900 } });
    page.on('pageerror', error => check(false, `${path} as a file: ${error.message}`));
    await page.goto(pathToFileURL(join(site, path)).href);
    const figures = await startAll(page, `${path} as a file`), stages = page.locator('bounce-stage');
    if (!path.startsWith('deeper')) check(await figures.count() >= 2, `${path} as a file has no live figures`);
    if (await stages.count()) {
      await stages.first().scrollIntoViewIfNeeded();
      const time = () => stages.first().evaluate(stage => JSON.parse(stage.api.state()).t), before = await time();
      await stages.first().locator('.play').click();
      await page.waitForTimeout(700);
      check(await time() > before + .1, `${path} as a file: the stage does not play`);
      check(/[ぁ-ん一-龠]/.test(await stages.first().locator('.question').textContent()) === path.startsWith('ja'), `${path} as a file speaks the wrong language`);
    }
    await page.locator('#search').fill(path.startsWith('ja') ? '反発係数' : 'restitution');
    await page.waitForFunction(() => document.querySelectorAll('#found a').length > 2, null, { timeout: 10000 }).catch(() => check(false, `${path} as a file: the search finds nothing`));
    await page.close();
  }
}

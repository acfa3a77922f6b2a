// What the page says, for everybody, and that no text of a file can do anything.
import assert from 'node:assert/strict';
import {readFile} from 'node:fs/promises';
import {test} from 'node:test';

import {drawn, from_packages, open, with_browser} from './support.mjs';

const holder = with_browser();

for (const [theme, width] of [['dark', 1100], ['light', 1100], ['dark', 480]]) {
  test(`axe finds nothing to mend, ${theme}, ${width} pixels wide`, async () => {
    const page = await open(holder.browser, 'small.html', {colorScheme: theme, width});
    await drawn(page);
    await page.evaluate(() => document.querySelectorAll('details').forEach((part) => {
      part.open = true;
    }));
    await page.evaluate(await readFile(from_packages.resolve('axe-core/axe.min.js'), 'utf8'));
    const found = await page.evaluate(
        async () => (await axe.run()).violations.map((v) => [v.id, v.nodes.map((n) => n.html)]));
    assert.deepEqual(found, []);
    await page.keyboard.press('?');
    const in_help =
        await page.evaluate(async () => (await axe.run('#help')).violations.map((v) => v.id));
    assert.deepEqual(in_help, []);
  });
}

test('the colour bar lies in the picture and has unit and values', async () => {
  const page = await open(holder.browser, 'small.html');
  await drawn(page);
  assert.match(await page.locator('#bar_title').textContent(), /\[YI\/2R²\]/);
  assert.ok((await page.locator('#bar_ticks span').count()) >= 2);
  const stage = await page.locator('#stage').boundingBox();
  const bar = await page.locator('#bar').boundingBox();
  assert.ok(bar.height > 5 && bar.width > 100, JSON.stringify(bar));
  assert.ok(bar.y > stage.y && bar.y + bar.height < stage.y + stage.height, JSON.stringify(stage));
});

test('provenance names version, commit, seed, residual, balance and configuration', async () => {
  const page = await open(holder.browser, 'small.html');
  await drawn(page);
  const text = await page.locator('#provenance').textContent();
  for (const word of ['wirepack', 'commit', 'seed', 'residual', 'balance of work', 'command'])
    assert.ok(text.includes(word), word);
  assert.match(await page.locator('#config').textContent(), /\[cavity\]/);
});

test('the table has a line for every frame', async () => {
  const page = await open(holder.browser, 'small.html');
  await drawn(page);
  assert.equal(
      await page.locator('#numbers tbody tr').count(), await page.evaluate(() => frame_count));
});

test('texts of the file and its name are shown and never run', async () => {
  const page = await open(holder.browser, 'hostile.html');
  const dialogs = [];
  page.on('dialog', (dialog) => { dialogs.push(dialog.message()); dialog.dismiss(); });
  await drawn(page);
  assert.equal(await page.evaluate(() => document.documentElement.dataset.hurt), undefined);
  assert.equal(await page.locator('img').count(), 0);
  assert.deepEqual(dialogs, []);
  assert.match(await page.locator('#name').textContent(), /<img src=x onerror/);
  assert.match(await page.locator('#config').textContent(), /<\/script><script>/);
  assert.deepEqual(page.complaints, []);
});

test('a script or a style that is not the page\'s own does not run', async () => {
  const page = await open(holder.browser, 'small.html');
  await drawn(page);
  await page.evaluate(() => {
    const script = document.createElement('script');
    script.textContent = 'document.documentElement.dataset.hurt = 1';
    document.body.append(script);
  });
  assert.equal(await page.evaluate(() => document.documentElement.dataset.hurt), undefined);
});

test('without WebGL the page says so, and curves and numbers are there', async () => {
  const page = await open(holder.browser, 'small.html', {});
  await page.addInitScript(() => { HTMLCanvasElement.prototype.getContext = () => null; });
  await page.reload();
  await page.waitForSelector('#message:not([hidden])');
  assert.match(await page.locator('#message').textContent(), /no WebGL2/);
  assert.ok(await page.locator('#curve_force path.curve').getAttribute('d'));
});

// Slider, curves, keys, buttons and touch do what they say.
import assert from 'node:assert/strict';
import {readFile} from 'node:fs/promises';
import {test} from 'node:test';

import {drawn, luminance, open, standard_deviation, state_of, with_browser} from './support.mjs';

const holder = with_browser();
const picture = async (page) =>
    luminance(holder.browser, await page.locator('#stage').screenshot());
const differing = (a, b) => a.filter((v, k) => Math.abs(v - b[k]) > 12).length / a.length;

// The stage with nothing on it but the wire.
const bare = (page) => page.evaluate(() => {
  for (const part of document.querySelectorAll('#legend, .views')) part.style.display = 'none';
  state.outline = false;
  redraw();
});

test('the picture is not blank, and nothing is asked of a network', async () => {
  const page = await open(holder.browser, 'small.html');
  await drawn(page);
  await bare(page);
  await drawn(page);
  assert.ok(standard_deviation(await picture(page)) > 8);
  assert.deepEqual(page.requests.filter((url) => !url.startsWith('file:')), []);
  assert.deepEqual(page.complaints, []);
});

test('a canvas without its wire would be found blank', async () => {
  const page = await open(holder.browser, 'small.html');
  await drawn(page);
  await bare(page);
  await page.evaluate(() => {
    scene.set_nodes(new Float32Array(3), new Float32Array(1));
    redraw();
  });
  await drawn(page);
  assert.ok(standard_deviation(await picture(page)) < 8);
});

test('the slider shows the frame and the numbers of its moment', async () => {
  const page = await open(holder.browser, 'small.html');
  await drawn(page);
  const last = await picture(page);
  const frames = await page.evaluate(() => frame_count);
  assert.ok(frames > 5);
  await page.locator('#time').fill('1');
  await drawn(page);
  assert.equal((await state_of(page)).frame, 1);
  assert.match(await page.locator('#moment').textContent(), new RegExp(`frame 2 of ${frames}`));
  const expected = await page.evaluate(() => shown(past.force.values[frame_rows[1]]));
  assert.match(
      await page.locator('#curve_force output').textContent(),
      new RegExp('^' + expected.replace('.', '\\.')));
  assert.ok(differing(last, await picture(page)) > 0.005);
  assert.equal(await page.locator('#numbers tr[aria-current]').getAttribute('data-frame'), '1');
});

test('the positions of a frame are those of the file to half a quantum', async () => {
  const page = await open(holder.browser, 'ring.html');
  await drawn(page);
  const off = await page.evaluate(async () => {
    const xyz = await positions_of(0), n = xyz.length / 3;
    let worst = 0;
    for (let i = 0; i < n; ++i) {
      const angle = 2 * Math.PI * i / (n - 1),
            exact = [6 * Math.cos(angle), 0, 6 * Math.sin(angle)];
      exact.forEach((c, k) => { worst = Math.max(worst, Math.abs(c - xyz[k * n + i])); });
    }
    return [n, worst / run.frames[0].quantum];
  });
  assert.equal(off[0], 361);
  assert.ok(off[1] < 0.51, `${off[1]} quanta`);
});

test('a click on a curve goes to the frame nearest to it', async () => {
  const page = await open(holder.browser, 'small.html');
  await drawn(page);
  const box = await page.locator('#curve_force svg').boundingBox();
  await page.mouse.click(box.x + box.width * (44 + 0.5 * 288) / 340, box.y + box.height / 2);
  const off = await page.evaluate(() => {
    const phis = frame_rows.map((row) => past.density.values[row]),
          half = past.density.values.at(-1) / 2;
    const nearest = Math.min(...phis.map((phi) => Math.abs(phi - half)));
    return Math.abs(Math.abs(phis[state.frame] - half) - nearest) / half;
  });
  assert.ok(off < 0.02, `${off}`);
});

test('play goes through the frames and stops at the last one', async () => {
  const page = await open(holder.browser, 'small.html');
  await drawn(page);
  await page.evaluate(() => set_frame(frame_count - 3));
  await page.locator('#play').click();
  await page.waitForFunction(() => state.frame === frame_count - 1 && !playing);
  assert.equal(await page.locator('#play').getAttribute('aria-pressed'), 'false');
});

test('every key of the list does what it says', async () => {
  const page = await open(holder.browser, 'small.html');
  await drawn(page);
  await page.locator('#stage').focus();
  const after = async (key) => {
    await page.keyboard.press(key);
    return state_of(page);
  };
  const start = await state_of(page);
  for (const key of ['ArrowLeft', 'ArrowUp', '<']) {
    const opposite = {ArrowLeft: 'ArrowRight', ArrowUp: 'ArrowDown', '<': '>'}[key];
    assert.notDeepEqual((await after(key)).turn, start.turn, key);
    const back = (await after(opposite)).turn;
    back.forEach((c, k) => assert.ok(Math.abs(c - start.turn[k]) < 1e-9, opposite));
  }
  assert.equal((await after('+')).zoom, 1.25);
  assert.equal((await after('-')).zoom, 1);
  assert.deepEqual((await after('z')).turn, [1, 0, 0, 0]);
  assert.deepEqual((await after('0')).turn, start.turn);
  assert.equal((await after(',')).frame, start.frame - 1);
  assert.equal((await after('.')).frame, start.frame);
  assert.equal((await after('Home')).frame, 0);
  assert.equal((await after('End')).frame, start.frame);
  assert.equal((await after('c')).cut, true);
  assert.equal((await after(']')).cut_at, 0.5);
  assert.equal((await after('[')).cut_at, 0);
  assert.deepEqual((await after('a')).cut_normal, [0, 0, 1]);
  const side = (await state_of(page)).cut_side;
  assert.equal((await after('f')).cut_side, -side);
  assert.equal((await after('v')).cut_axis, 'view');
  assert.equal((await after('e')).section, true);
  assert.equal((await after('o')).outline, false);
  assert.equal((await after('3')).field, 2);
  assert.equal((await after('l')).log, false);
  await page.keyboard.press('d');
  assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), 'dark');
  await page.keyboard.press('?');
  assert.ok(await page.locator('#help').isVisible());
  assert.ok((await page.locator('#keys dt').count()) >= 24);
  await page.keyboard.press('Escape');
  await page.keyboard.press('Home');
  await page.keyboard.press(' ');
  assert.equal(await page.evaluate(() => playing), true);
});

test('a cut takes away what lies beyond and nothing else', async () => {
  const page = await open(holder.browser, 'straight.html');
  await drawn(page);
  // seen from the side: the wire lies along y from -7 to 7 with its round ends, cut at y = 2
  await page.evaluate(() => {
    Object.assign(
        state,
        {frame: 0, cut: true, cut_normal: [0, 1, 0], cut_at: 2, cut_side: 1, outline: false});
    look('x');
    show_everything();
  });
  await drawn(page);
  const [left, right] = await page.evaluate(() => {
    const shot = picture_of(1, true, false), {width, height} = shot;
    const {data} = shot.getContext('2d').getImageData(0, Math.floor(height / 2), width, 1);
    const filled = [...Array(width).keys()].filter((x) => data[4 * x + 3] > 127);
    const at = (x) => (x + 0.5 - width / 2) * length_per_pixel();
    return [at(filled[0]), at(filled.at(-1))];
  });
  assert.ok(Math.abs(left + 7) < 0.1, `${left}`);
  assert.ok(Math.abs(right - 2) < 0.1, `${right}`);
});

test('the saved picture has the chosen size and the look of the screen', async () => {
  const page = await open(holder.browser, 'small.html');
  await drawn(page);
  await page.locator('#factor').selectOption('2');
  const [download] = await Promise.all(
      [page.waitForEvent('download', {timeout: 120000}), page.locator('#save').click()]);
  const png = await readFile(await download.path());
  const stage = await page.locator('#stage').boundingBox();
  assert.equal(png.readUInt32BE(16), 2 * Math.round(stage.width));
  assert.equal(png.readUInt32BE(20), 2 * Math.round(stage.height));
  assert.match(download.suggestedFilename(), /^small_\d+\.png$/);
  const saved = standard_deviation(await luminance(holder.browser, png));
  const seen = standard_deviation(await picture(page));
  assert.ok(Math.abs(saved / seen - 1) < 0.25, `${saved} and ${seen}`);
});

test('a link brings the same view back, and a wrong one does no harm', async () => {
  const page = await open(holder.browser, 'small.html');
  await drawn(page);
  await page.evaluate(() => { set_frame(2); set_cut(true); move_cut(1.5); set_field(3); });
  await drawn(page);
  const hash = new URL(page.url()).hash;
  const again = await open(holder.browser, 'small.html', {hash});
  await drawn(again);
  const [one, other] = [await state_of(page), await state_of(again)];
  assert.deepEqual([other.frame, other.cut, other.cut_at, other.field], [2, true, 1.5, 3]);
  assert.equal(other.range.length, one.range.length);
  const wrong = await open(
      holder.browser, 'small.html',
      {hash: '#%7B%22frame%22%3A9e99%2C%22map%22%3A%22constructor%22%2C%22turn%22%3A%5B0%5D%7D'});
  await drawn(wrong);
  assert.deepEqual(wrong.complaints, []);
});

test('one finger turns, two fingers zoom', async () => {
  const page = await open(holder.browser, 'small.html', {hasTouch: true});
  await drawn(page);
  const touch = await page.context().newCDPSession(page);
  const send = (type, ...points) => touch.send(
      'Input.dispatchTouchEvent', {type, touchPoints: points.map(([x, y], id) => ({x, y, id}))});
  const start = await state_of(page);
  await send('touchStart', [300, 300]);
  await send('touchMove', [360, 300]);
  await send('touchEnd');
  const turned = await state_of(page);
  assert.notDeepEqual(turned.turn, start.turn);
  assert.equal(turned.zoom, 1);
  await send('touchStart', [300, 300], [400, 300]);
  await send('touchMove', [250, 300], [450, 300]);
  await send('touchEnd');
  const zoom = (await state_of(page)).zoom;
  assert.ok(Math.abs(zoom - 2) < 0.05, `${zoom}`);
});

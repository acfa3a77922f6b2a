// The cut faces have the area and the colour that they must have.
import assert from 'node:assert/strict';
import {test} from 'node:test';

import {drawn, open, show, with_browser} from './support.mjs';

const holder = with_browser();

// Area of what is drawn in the picture that the page saves, in a^2; partly covered pixels count in
// part.
const drawn_area = (page) => page.evaluate(() => {
  const shot = picture_of(2, true, false);
  const {data} = shot.getContext('2d').getImageData(0, 0, shot.width, shot.height);
  let cover = 0;
  for (let k = 3; k < data.length; k += 4) cover += data[k] / 255;
  return cover * (length_per_pixel() / (2 * wire_radius)) ** 2;
});

function expect_area(measured, exact) {
  assert.ok(Math.abs(measured / exact - 1) < 0.01, `area ${measured} instead of ${exact}`);
}

const only_the_face = {outline: false, section: true, cut: true, zoom: 2};

test('a straight wire cut across shows a disc of area pi a^2', async () => {
  const page = await open(holder.browser, 'straight.html');
  await drawn(page);
  await show(
      page,
      {...only_the_face, frame: 0, cut_normal: [0, 1, 0], cut_at: 0.37, cut_side: 1, zoom: 6});
  await page.keyboard.press('n');
  await drawn(page);
  expect_area(await drawn_area(page), Math.PI);
});

test('a straight wire cut at an angle shows an ellipse of area pi a^2 / cos', async () => {
  const page = await open(holder.browser, 'straight.html');
  await drawn(page);
  await show(
      page,
      {...only_the_face, frame: 1, cut_normal: [0, 1, 0], cut_at: 0.37, cut_side: 1, zoom: 6});
  await page.keyboard.press('n');
  await drawn(page);
  expect_area(await drawn_area(page), Math.PI / 0.8);
});

test('a ring cut through its axis shows two discs of the sections of a torus', async () => {
  const page = await open(holder.browser, 'ring.html');
  await drawn(page);
  await show(page, {...only_the_face, cut_normal: [0, 0, 1], cut_at: 0, cut_side: 1});
  await page.keyboard.press('n');
  await drawn(page);
  expect_area(await drawn_area(page), 2 * Math.PI);
});

test(
    'a ring cut along its plane, half a radius above the middle, shows a band of width 2 a cos 30',
    async () => {
      const page = await open(holder.browser, 'ring.html');
      await drawn(page);
      await show(
          page, {...only_the_face, cut_normal: [0, 1, 0], cut_at: 0.5, cut_side: 1, zoom: 1.2});
      await page.keyboard.press('n');
      await drawn(page);
      expect_area(await drawn_area(page), 2 * Math.PI * 6 * Math.sqrt(3));
    });

test('a face seen from the side where the wire is shows nothing', async () => {
  const page = await open(holder.browser, 'straight.html');
  await drawn(page);
  await show(page, {...only_the_face, frame: 0, cut_normal: [0, 1, 0], cut_at: 0, cut_side: 1});
  await page.keyboard.press('n');
  await page.keyboard.press('f');
  await drawn(page);
  assert.equal(await drawn_area(page), 0);
});

test('the middle of a face has the colour that the bar gives to its value', async () => {
  const page = await open(holder.browser, 'straight.html');
  await drawn(page);
  await show(
      page, {...only_the_face, frame: 0, cut_normal: [0, 1, 0], cut_at: 3, cut_side: 1, zoom: 6});
  await page.keyboard.press('n');
  await drawn(page);
  const [pixel, expected] = await page.evaluate(async () => {
    const shot = picture_of(1, true, false);
    const at = 3;  // of -6 ... 6, along which the energy per length grows from 0.1 to 10
    const value = 10 ** (-1 + 2 * (at + 6) / 12);
    const high = decoded(run.fields[0], 255);
    const share = place(value * high / 10, state.range, state.log);
    const list = stops(state.map), k = Math.floor(share * 32), part = share * 32 - k;
    const colour = [0, 1, 2].map(
        (c) => list[3 * k + c] * (1 - part) + list[3 * Math.min(32, k + 1) + c] * part);
    const middle = [shot.width / 2, shot.height / 2].map(Math.floor);
    return [[...shot.getContext('2d').getImageData(...middle, 1, 1).data], colour];
  });
  expected.forEach(
      (c, k) => assert.ok(Math.abs(pixel[k] - c) <= 6, `colour ${pixel} instead of ${expected}`));
});

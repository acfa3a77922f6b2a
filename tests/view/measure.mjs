// Measures pages in headless Chromium with software GL, and prints the table of
// data/docs/viewing.md, the machine and the commits of the programs that made the pages.
//   VIEW_PACKAGES=FOLDER VIEW_RESULTS=. node tests/view/measure.mjs PAGE.html...
import {statSync} from 'node:fs';
import os from 'node:os';
import path from 'node:path';

import {drawn, launch, open} from './support.mjs';

// Pictures per second while the view is turned for some seconds.
async function rate(page) {
  const [count, seconds] = await page.evaluate(async () => {
    const start = performance.now(), before = painter.pictures;
    while (performance.now() - start < 4000) {
      turn_view([0, 1, 0], 0.03);
      await new Promise(requestAnimationFrame);
    }
    return [painter.pictures - before, (performance.now() - start) / 1000];
  });
  return count / seconds;
}

const makers = new Set();
console.log(
    '| page | nodes | frames | size | first picture | fine picture | ' +
    'pictures per second, turning |');
console.log('|---|---|---|---|---|---|---|');
for (const file of process.argv.slice(2)) {
  const browser = await launch();
  const start = Date.now();
  const page = await open(browser, path.resolve(file), {width: 1180, height: 710});
  await page.waitForSelector('html[data-pictures]', {state: 'attached', timeout: 120000});
  const first = (Date.now() - start) / 1000;
  await drawn(page);
  const fine = (Date.now() - start) / 1000;
  const [nodes, frames, maker] = await page.evaluate(() => [
    run.frames.at(-1).nodes, frame_count,
    run.provenance.find(([label]) => label === 'page made by')[1],
  ]);
  makers.add(maker);
  const pictures = await rate(page);
  const size = (statSync(file).size / 1e6).toFixed(2);
  console.log(`| ${path.basename(file, '.html')} | ${nodes} | ${frames} | ${size} MB | ${
      first.toFixed(1)} s | ${fine.toFixed(1)} s | ${pictures.toFixed(1)} |`);
  await browser.close();
}
const cpus = os.cpus();
console.log(`\n${cpus.length} x ${cpus[0].model}, load ${os.loadavg()[0].toFixed(1)}; pages by ${
    [...makers].join('; ')}`);

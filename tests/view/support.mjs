// What the browser tests share. VIEW_PACKAGES names the folder with the npm packages, VIEW_RESULTS
// that with the pages of make_results.py.
import {existsSync} from 'node:fs';
import {createRequire} from 'node:module';
import path from 'node:path';
import {pathToFileURL} from 'node:url';
import {after, before} from 'node:test';

const packages = path.join(process.env.VIEW_PACKAGES, 'package.json');
export const from_packages = createRequire(packages);
export const results = process.env.VIEW_RESULTS;

// Software GL: the same pixels on every machine.
const browser_arguments = [
  '--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
  '--disable-dev-shm-usage', '--hide-scrollbars', '--force-device-scale-factor=1',
];

export async function launch() {
  const executablePath = process.env.CHROMIUM || '/usr/bin/chromium';
  if (!existsSync(executablePath)) {
    throw new Error(`there is no ${executablePath}; apps/dependencies --tests installs chromium`);
  }
  const {chromium} = from_packages('playwright-core');
  return chromium.launch({executablePath, args: browser_arguments});
}

// One browser per file of tests.
export function with_browser() {
  const holder = {};
  before(async () => { holder.browser = await launch(); });
  after(async () => { await holder.browser?.close(); });
  return holder;
}

// Opens a page from the disk, and notes whatever it complains of or asks the network for.
export async function open(
    browser, name, {hash = '', width = 1100, height = 700, ...options} = {}) {
  const context =
      await browser.newContext({viewport: {width, height}, acceptDownloads: true, ...options});
  const page = await context.newPage();
  page.complaints = [];
  page.requests = [];
  page.on('console', (message) => {
    if (message.type() === 'error') page.complaints.push(message.text());
  });
  page.on('pageerror', (error) => page.complaints.push(error.message));
  page.on('request', (request) => page.requests.push(request.url()));
  const file = path.isAbsolute(name) ? name : path.join(results, name);
  await page.goto(pathToFileURL(file).href + hash);
  return page;
}

// Until the picture has all of its samples.
export const drawn = (page) =>
    page.waitForSelector('html[data-drawn]', {state: 'attached', timeout: 120000});

// Changes the state as a link does, and waits for its picture.
export async function show(page, changes) {
  await page.evaluate((values) => { Object.assign(state, values); show_everything(); }, changes);
  await drawn(page);
}

export const state_of = (page) => page.evaluate(() => JSON.parse(JSON.stringify(state)));

// The pixels that a screenshot has, as luminance 0 ... 255.
export async function luminance(browser, png) {
  const page = await (await browser.newContext()).newPage();
  const values = await page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes], {type: 'image/png'}));
    const ink = new OffscreenCanvas(image.width, image.height).getContext('2d');
    ink.drawImage(image, 0, 0);
    const {data} = ink.getImageData(0, 0, image.width, image.height);
    return Array.from(
        {length: data.length / 4},
        (_, k) =>
            Math.round(0.2126 * data[4 * k] + 0.7152 * data[4 * k + 1] + 0.0722 * data[4 * k + 2]));
  }, png.toString('base64'));
  await page.context().close();
  return values;
}

export function standard_deviation(values) {
  const mean = values.reduce((sum, v) => sum + v, 0) / values.length;
  return Math.sqrt(values.reduce((sum, v) => sum + (v - mean) ** 2, 0) / values.length);
}

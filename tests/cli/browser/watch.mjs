// Opens pages of desmo view in Chromium as a reader would and prints what happened, as JSON:
//   node watch.mjs CHROMIUM PAGE...
// Whether that is right is for the test to say.
import {readFile} from 'node:fs/promises';
import {pathToFileURL} from 'node:url';
import {chromium} from 'playwright-core';

const [executablePath, ...files] = process.argv.slice(2);
const flags = [
  '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking',
  '--disable-component-update', '--disable-sync',
];
const patience = 240000;  // ms; a busy machine must not decide
const widths = [1400, 800, 400];

const frames = page => page.evaluate(
    () => new Promise(drawn => requestAnimationFrame(() => requestAnimationFrame(drawn))));

// Returns what the page computes once it is as expected, as plots follow a new width later. Gives up
// after so long that only a page that never gets there is meant: who reads the result judges.
async function settled(page, compute, expected) {
  const end = Date.now() + patience;
  for (;;) {
    await frames(page);
    const value = await page.evaluate(compute);
    if (value === expected || Date.now() > end) return value;
  }
}

async function open(page, address) {
  await page.goto(address);
  await page.waitForFunction(() => document.documentElement.dataset.state === 'ready');
  await frames(page);
}

// Ten instants over the motion: positions in the picture, values in the plots at all levels.
async function numbers(page) {
  await page.locator('#choice summary').click();
  for (const box of await page.locator('#levels input').all()) await box.check();
  await page.waitForFunction(() => document.querySelectorAll('#panels .drawing').length ===
      document.querySelectorAll('#panels .drawing svg').length);
  await frames(page);
  return page.evaluate(() => Array.from({length: 10}, (_, j) => {
    const k = Math.round(j * (desmo.instants - 1) / 9);
    desmo.show(k);
    return {index: desmo.index(k), positions: desmo.positions(), values: desmo.values(k)};
  }));
}

// How many shapes the picture has.
const variety = page => page.locator('#stage :is(line, path, circle, rect, polygon)').count();

// What the picture says in words; colours by body; names.
async function words(page, result) {
  await page.locator('#colours').selectOption('body');
  result.bodies = await page.locator('#legend li').allTextContents();
  await page.locator('#colours').selectOption('group');
  await page.locator('#names').setChecked(true);
  result.words = await page.locator('#stage text').allTextContents();
}

// What the reader can save: the texts of the picture and of the numbers.
async function saved(page) {
  const result = {};
  for (const what of ['picture', 'data']) {
    const [file] = await Promise.all([page.waitForEvent('download'), page.locator(`#save_${what}`).click()]);
    result[what] = {name: file.suggestedFilename(), text: await readFile(await file.path(), 'utf8')};
  }
  return result;
}

// The space bar plays; arrow keys go by an instant; a trace, arrows and names are shown.
async function play(page, result) {
  await page.evaluate(() => desmo.show(0));
  const before = await page.evaluate(() => desmo.positions());
  await page.locator('#slider').focus();
  await page.keyboard.press('Space');
  await page.waitForFunction(before => JSON.stringify(desmo.positions()) !== JSON.stringify(before), before);
  result.label_when_playing = await page.locator('#play').getAttribute('aria-label');
  await page.keyboard.press('Space');
  await page.keyboard.press('Home');
  await page.keyboard.press('ArrowRight');
  result.time_after_one = await page.evaluate(() => Number(document.getElementById('slider').value) - desmo.time(1));
  await page.locator('#velocities').check();
  await page.locator('#accelerations').check();
  await page.evaluate(() => desmo.show(Math.min(7, desmo.instants - 1)));
  const places = await page.evaluate(() => desmo.places());
  const box = await page.locator('#stage').boundingBox();
  const seen = Object.entries(places).find(([, [x, y]]) => x > 5 && y > 5 && x < box.width - 5 && y < box.height - 5);
  result.inside = Object.values(places).filter(
      ([x, y]) => x > 0 && y > 0 && x < box.width && y < box.height).length / Object.keys(places).length;
  await page.mouse.move(box.x + seen[1][0], box.y + seen[1][1]);
  await page.mouse.move(box.x + seen[1][0] + 1, box.y + seen[1][1]);
  await page.locator('#hint').waitFor({state: 'visible'});
  result.hint = await page.locator('#hint').textContent();
  await page.mouse.move(2, 2);
  result.arrows = await page.locator('#stage :is(.velocity, .acceleration)').count();
}

// What shaded intervals say, and the words for them.
async function flags_of(page) {
  const notice = page.locator('#notice');
  const result = {
    notice: await notice.isVisible() ? await notice.textContent() : '', listed: await page.locator('#flags li').allTextContents(), hovered: '',
  };
  const shade = page.locator('#panels svg .mark-rect path').first();
  if (result.listed.length > 0 && await shade.count() > 0) {
    await shade.hover({force: true});
    await page.locator('#hint').waitFor({state: 'visible'});
    result.hovered = await page.locator('#hint').textContent();
  }
  return result;
}

async function look(browser, file) {
  const address = pathToFileURL(file).href;
  const result = {file, requests: [], errors: []};
  const page = await browser.newPage({viewport: {width: widths[0], height: 900}, reducedMotion: 'reduce'});
  page.setDefaultTimeout(patience);
  page.on('request', request => request.url() !== address && result.requests.push(request.url()));
  page.on('console', message => message.type() === 'error' && result.errors.push(message.text()));
  page.on('pageerror', error => result.errors.push(error.message));
  await open(page, address);
  result.flags = await flags_of(page);
  const paper = (await page.pdf({preferCSSPageSize: true})).toString('latin1');
  result.sheets = (paper.match(/\/Type\s*\/Page\b/g) ?? []).length;
  result.variety = await variety(page);
  result.folded = await page.locator('#accurate:not([open]) figure').count();
  result.size = await page.evaluate(() => desmo.size);
  result.legend = await page.locator('#legend li').count();
  result.numbers = await numbers(page);
  await play(page, result);
  await words(page, result);
  result.saved = await saved(page);
  result.overflow = {};
  for (const width of widths) {
    await page.setViewportSize({width, height: 900});
    result.overflow[width] = await settled(page,
        () => document.documentElement.scrollWidth - document.documentElement.clientWidth, 0);
  }
  await page.close();
  return result;
}

const browser = await chromium.launch({executablePath, args: flags, timeout: patience});
try {
  const results = [];
  for (const file of files) results.push(await look(browser, file));
  console.log(JSON.stringify(results));
} finally {
  await browser.close();
}

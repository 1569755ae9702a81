// Opens a page in Chromium as a reader would and prints what happened, as JSON:
//   node open.mjs CHROMIUM PAGE
// Whether that is right is for the test to say.
import {pathToFileURL} from 'node:url';
import {chromium} from 'playwright-core';

const [executablePath, file] = process.argv.slice(2);
const address = pathToFileURL(file).href;
const flags = [
  '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run',
  '--disable-background-networking', '--disable-component-update', '--disable-sync',
];

const patience = 240000;  // ms; a busy machine must not decide

const marks = figure => [...figure.querySelectorAll(
    '.drawing .role-mark :is([aria-roledescription="point"], [aria-roledescription="bar"], [aria-roledescription="rect mark"])')];

// What the hover shows, mark by mark; events are sent to each, as some lie under others.
function hovered(marks) {
  return marks.map(mark => {
    const tell = type => mark.dispatchEvent(new PointerEvent(type, {bubbles: true}));
    tell('pointermove');
    const hint = document.querySelector('.hint');
    const text = hint.hidden ? '' : hint.querySelector('dd:last-of-type').textContent;
    tell('mouseout');
    return hint.hidden ? text : 'the hint stays';
  });
}

// A mark that lies under no other, where a pointer finds it.
function uncovered(marks) {
  return marks.find(mark => {
    mark.scrollIntoView({block: 'center'});
    const {x, y, width, height} = mark.getBoundingClientRect();
    return document.elementFromPoint(x + width / 2, y + height / 2) === mark;
  });
}

async function countMarks(figure) {
  return (await figure.evaluateHandle(marks)).evaluate(found => found.length);
}

// Tab until the focus is on the box of a figure, as someone without a mouse does.
async function focusByKeyboard(page, id) {
  for (let presses = 1; presses < 400; ++presses) {
    await page.keyboard.press('Tab');
    if (await page.evaluate(id => document.activeElement.matches(`#${id} .toggles input`), id))
      return presses;
  }
  return 0;
}

// Opens every section: what is folded has no width.
async function unfold(page) {
  await page.evaluate(() => document.querySelectorAll('details').forEach(one => one.open = true));
}

// Where the first table, figure and sentences end, and what is folded, before anything is opened.
function firstScreen() {
  const bottom = selector =>
      Math.max(...[...document.querySelectorAll(selector)].map(e => e.getBoundingClientRect().bottom));
  const below = document.querySelector('.front .more > .scroll').getBoundingClientRect().top;
  return {
    gap: below - bottom('.front .words'),
    words: bottom('.front .words'), figure: bottom('.front .drawing'), table: bottom('.front .more > .scroll'),
    folded: document.querySelectorAll('details.section:not([open])').length,
  };
}

// The least size of text in figures as drawn, and figures that leave of their column more than a
// few pixels.
function fit() {
  const drawings = [...document.querySelectorAll('.drawing svg')];
  const sizes = drawings.flatMap(svg => {
    const scale = svg.getBoundingClientRect().width / svg.width.baseVal.value;
    return [...svg.querySelectorAll('text')].filter(text => text.textContent.trim())
        .map(text => scale * parseFloat(getComputedStyle(text).fontSize));
  });
  const leaves = svg => svg.closest('.drawing').clientWidth - svg.getBoundingClientRect().width;
  return {
    least_text: Math.min(...sizes),
    too_narrow: drawings.filter(svg => Math.abs(leaves(svg)) > 8).map(svg => svg.closest('figure').id),
  };
}

// Tables that reach beyond the page without a scroller of their own; all that does of the page.
function sideways() {
  const width = document.documentElement.clientWidth;
  const reaches = element => element.getBoundingClientRect().right > width + 1;
  return {
    overflow: document.documentElement.scrollWidth - width,
    outside: [...document.querySelectorAll('table')]
                 .filter(table => reaches(table.closest('.scroll') ?? table)).map(table => table.id),
    tables: [...document.querySelectorAll('table')].filter(table => table.offsetWidth > 0).length,
  };
}

// Tables of which paper does not show everything: not shown, beyond its edge, or cut in a cell.
function cut() {
  const width = document.documentElement.clientWidth;
  const isCut = cell => cell.scrollWidth > cell.clientWidth + 1 ||
      cell.getBoundingClientRect().right > width + 1;
  return [...document.querySelectorAll('table')]
      .filter(table => table.offsetWidth === 0 || [...table.querySelectorAll('th, td')].some(isCut))
      .map(table => table.id);
}

async function live(page) {
  await page.waitForFunction(
      () => [...document.querySelectorAll('figure')].every(figure => figure.dataset.state === 'live'));
}

// Waits for two frames to have been drawn.
function frames(page) {
  return page.evaluate(
      () => new Promise(drawn => requestAnimationFrame(() => requestAnimationFrame(drawn))));
}

// Returns the number of marks once it is as expected and two more frames do not change it. Gives up
// after so long that only a page that never gets there is meant: who reads the result judges.
async function settledMarks(page, figure, expected) {
  const end = Date.now() + patience;
  for (let last = -1;;) {
    const count = await countMarks(figure);
    if (count === last && expected(count) || Date.now() > end) return count;
    last = count;
    await frames(page);
  }
}

// Returns what the hint says once it is shown.
async function hintText(page) {
  await page.locator('.hint').waitFor({state: 'visible'});
  return page.locator('.hint dd').last().textContent();
}

async function look(page, figure) {
  const id = await figure.getAttribute('id');
  const found = {id, marks: await settledMarks(page, figure, count => count > 0)};
  found.texts = await (await figure.evaluateHandle(marks)).evaluate(hovered);
  const mark = await (await figure.evaluateHandle(marks)).evaluateHandle(uncovered);
  await mark.asElement().hover({force: true});
  found.pointer = await hintText(page);
  found.presses = await focusByKeyboard(page, id);
  await page.keyboard.press('Space');
  found.marks_without_first =
      await settledMarks(page, figure, count => 0 < count && count < found.marks);
  await figure.locator('.role-legend-symbol path').first().click();
  found.marks_after_legend = await settledMarks(page, figure, count => count === found.marks);
  return found;
}

const browser = await chromium.launch({executablePath, args: flags, timeout: patience});
const result = {requests: [], errors: [], figures: []};
try {
  // Without smooth scrolling: on a busy machine the page would move between press and release, and
  // the click be lost.
  const page = await browser.newPage({viewport: {width: 1280, height: 900}, reducedMotion: 'reduce'});
  page.setDefaultTimeout(patience);
  page.on('request', request => request.url() !== address && result.requests.push(request.url()));
  page.on('console', message => message.type() === 'error' && result.errors.push(message.text()));
  page.on('pageerror', error => result.errors.push(error.message));
  await page.setViewportSize({width: 1400, height: 900});
  await page.goto(address);
  await page.waitForFunction(
      () => [...document.querySelectorAll('.front figure')].every(f => f.dataset.state === 'live'));
  result.first_screen = await page.evaluate(firstScreen);
  await page.setViewportSize({width: 1280, height: 900});
  await unfold(page);
  await live(page);
  for (const figure of await page.locator('figure').all())
    result.figures.push(await look(page, figure));
  result.layout = {};
  for (const width of [1400, 800, 400]) {
    await page.setViewportSize({width, height: 900});
    await page.reload();
    await unfold(page);
    await live(page);
    result.layout[width] = {...await page.evaluate(sideways), ...await page.evaluate(fit)};
  }
  await page.setViewportSize({width: 1031, height: 703});  // A4 across, less its margins
  await page.reload();
  await page.emulateMedia({media: 'print'});
  await page.evaluate(() => window.dispatchEvent(new Event('beforeprint')));
  result.cut_in_print = await page.evaluate(cut);
} finally {
  await browser.close();
}
console.log(JSON.stringify(result));

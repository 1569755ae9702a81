// Renders Vega-Lite specifications: node render.mjs FOLDER writes name.svg for every name.vl.json
// in it and puts the figures into FOLDER/report.html, when that is there. No canvas, fonts or clock
// is used: the same specification gives the same bytes.
import {existsSync, readFileSync, readdirSync, renameSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import * as vega from 'vega';
import {compile} from 'vega-lite';
import {filled} from './page.mjs';

const suffix = '.vl.json';

async function svg(specification) {
  const view = new vega.View(vega.parse(specification), {renderer: 'none', logLevel: vega.Error});
  const drawing = await view.toSVG();
  view.finalize();
  return drawing + '\n';
}

// Returns a figure for the page: without title and subtitle, which the page has as text, and with a
// transparent background.
async function figure(name, {title, ...design}) {
  const specification =
      compile({...design, config: {...design.config, background: 'transparent'}}).spec;
  return {name, specification, drawing: await svg(specification)};
}

function write(folder, name, text) {
  writeFileSync(join(folder, `.${name}.part`), text);
  renameSync(join(folder, `.${name}.part`), join(folder, name));
  console.log(`rendered: ${name}`);
}

const folder = process.argv[2];
const page = join(folder, 'report.html');
const figures = [];
let failed = false;
async function attempt(file, action) {
  try {
    await action();
  } catch (error) {
    failed = true;
    console.error(`render: ${file}: ${error.message}`);
  }
}

for (const file of readdirSync(folder).filter(name => name.endsWith(suffix)).sort())
  await attempt(join(folder, file), async () => {
    const name = file.slice(0, -suffix.length);
    const design = JSON.parse(readFileSync(join(folder, file), 'utf8'));
    write(folder, `${name}.svg`, await svg(compile(design).spec));
    if (existsSync(page)) figures.push(await figure(name, design));
  });
if (existsSync(page))
  await attempt(page, () => write(folder, 'report.html', filled(readFileSync(page, 'utf8'), figures)));
process.exit(failed ? 1 : 0);

// Renders Vega-Lite specifications to SVG: node render.mjs FOLDER writes name.svg for every
// name.vl.json in it. No canvas, no fonts, no clock: the same specification gives the same bytes.
import {readFileSync, readdirSync, renameSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import * as vega from 'vega';
import {compile} from 'vega-lite';

const suffix = '.vl.json';

async function render(path) {
  const spec = compile(JSON.parse(readFileSync(path, 'utf8'))).spec;
  const view = new vega.View(vega.parse(spec), {renderer: 'none', logLevel: vega.Error});
  const svg = await view.toSVG();
  view.finalize();
  return svg + '\n';
}

const folder = process.argv[2];
let failed = false;
for (const file of readdirSync(folder).filter(name => name.endsWith(suffix)).sort()) {
  const target = file.slice(0, -suffix.length) + '.svg';
  try {
    const svg = await render(join(folder, file));
    writeFileSync(join(folder, `.${target}.part`), svg);
    renameSync(join(folder, `.${target}.part`), join(folder, target));
    console.log(`rendered: ${target}`);
  } catch (error) {
    failed = true;
    console.error(`render: ${join(folder, file)}: ${error.message}`);
  }
}
process.exit(failed ? 1 : 0);

// Puts figures into the page that desmo_report wrote: each as a drawing with its compiled
// specification, and at the end of the page the program that makes them interactive. Filling a
// filled page gives the same page.
import {readFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));

// Returns the code of Vega for the browser, with its licence.
function runtime() {
  const folder = join(here, 'node_modules', 'vega');
  const {version} = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
  const licence = readFileSync(join(folder, 'LICENSE'), 'utf8').trim();
  const code = readFileSync(join(folder, 'build', 'vega.min.js'), 'utf8')
                   .replace(/^\/\/# sourceMappingURL=.*$/m, '').trim();
  return `/*! Vega ${version}\n${licence} */\n${code}`;
}

// Returns a script element. Throws when its code has the end of a script or a comment of the page.
function script(attributes, code) {
  if (/<\/script|<!--/i.test(code)) throw new Error('a script would end in its middle');
  return `<script${attributes}>\n${code}\n</script>`;
}

function json(value) {
  return JSON.stringify(value).replaceAll('<', '\\u003c');
}

// Returns the page with `content` between the two comments of a name.
function between(page, name, content) {
  const begin = `<!-- ${name} -->`, end = `<!-- end of ${name} -->`;
  const from = page.indexOf(begin), to = page.indexOf(end);
  if (from < 0 || to < from) throw new Error(`no place for ${name}`);
  return page.slice(0, from + begin.length) + '\n' + content + '\n' + page.slice(to);
}

export function filled(page, figures) {
  for (const {name, specification, drawing} of figures)
    page = between(
        page, name,
        `<div class="drawing" role="img" aria-labelledby="${name}-title">${drawing.trim()}</div>\n` +
            script(' type="application/json"', json(specification)));
  if (figures.length === 0) return page;
  const program = readFileSync(join(here, 'page.js'), 'utf8').trim();
  return between(page, 'scripts', script('', runtime()) + '\n' + script('', program));
}

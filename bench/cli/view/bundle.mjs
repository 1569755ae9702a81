// Makes the page that `desmo view` fills, as a source of the program:
//   node bundle.mjs SOURCES PACKAGES OUTPUT.cpp
// SOURCES: this folder; PACKAGES: where `npm ci` has put node_modules. The same input gives the
// same bytes. Licences of what is bundled stand in the page.
import {existsSync, readFileSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {join} from 'node:path';

const [sources, packages, output] = process.argv.slice(2);
const {build} = createRequire(join(packages, 'package.json'))('esbuild');
const read = name => readFileSync(join(sources, name), 'utf8').trim();

// Returns the licences of the packages that a bundle contains files of. Each text stands there
// once, under the names of all packages that have it.
function licences(inputs) {
  const names = new Set(Object.keys(inputs).flatMap(
      path => path.match(/node_modules\/((?:@[^/]+\/)?[^/]+)\//)?.[1] ?? []));
  const by_text = new Map();
  for (const name of [...names].sort()) {
    const folder = join(packages, 'node_modules', name);
    const {version} = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
    // Vega's packages without a licence file of their own are under Vega's licence.
    const file = [...['LICENSE', 'LICENSE.md', 'license'].map(n => join(folder, n)),
                  ...(name.startsWith('vega-') ? [join(packages, 'node_modules', 'vega', 'LICENSE')] : []),
                 ].find(existsSync);
    if (!file) throw new Error(`${name} has no licence`);
    const text = readFileSync(file, 'utf8').trim().replaceAll('*/', '* /');
    by_text.set(text, [...(by_text.get(text) ?? []), `${name} ${version}`]);
  }
  return [...by_text].map(([text, owners]) => `${owners.join(', ')}\n${text}`).join('\n\n');
}

async function page() {
  const result = await build({
    entryPoints: [join(sources, 'main.js')], bundle: true, minify: true, format: 'iife', write: false, metafile: true,
    nodePaths: [join(packages, 'node_modules')], absWorkingDir: packages, legalComments: 'none', charset: 'utf8',
    logLevel: 'error',
  });
  const code = result.outputFiles[0].text.trim();
  if (/<\/script|<!--/i.test(code)) throw new Error('a script would end in its middle');
  const script = `/*\n${licences(result.metafile.inputs)}\n*/\n${code}`;
  return read('page.html').replace('@STYLE@', () => read('page.css')).replace('@SCRIPT@', () => script) + '\n';
}

// Returns a text as C++ string literals of at most 12000 bytes, since compilers limit their length.
function literal(text) {
  const bytes = Buffer.from(text, 'utf8');
  const pieces = [];
  for (let at = 0; at < bytes.length; at += 12000)
    pieces.push('"' + [...bytes.subarray(at, at + 12000)].map(escaped).join('') + '"');
  return pieces.join('\n');
}

function escaped(byte) {
  const letter = String.fromCharCode(byte);
  if (byte >= 32 && byte < 127 && !'"\\?'.includes(letter)) return letter;
  return '\\' + byte.toString(8).padStart(3, '0');
}

writeFileSync(output, `#include "bench/cli/view/page_template.h"

namespace desmo::cli {
namespace {
constexpr char page[] =
${literal(await page())};
}  // namespace
const std::string_view page_template{page, sizeof page - 1};
}  // namespace desmo::cli
`);

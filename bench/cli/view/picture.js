// The picture of a mechanism: its drawing, seen by a camera, with what the reader chooses (traces,
// names, arrows). It is SVG as text, made anew for each instant, and can be saved as a file.
import {Camera} from './camera.js';
import {at, plus} from './data.js';
import {draw, layers, usual_length} from './drawing.js';

const arrow = 90;  // length of the arrow of the largest rate [px], where seen at right angles
const rates = {velocity: 'var(--speed)', acceleration: 'var(--pull)'};
const number = x => Math.round(100 * x) / 100;
const escaped = text => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;');
const text = (x, y, words, colour, anchor) =>
    `<text x="${number(x)}" y="${number(y)}" fill="${colour}" text-anchor="${anchor}">${escaped(words)}</text>`;
const heads = Object.entries({...rates, driver: 'var(--driver)'}).map(([name, colour]) =>
    `<marker id="${name}" viewBox="-9 -5 11 10" refX="2" markerWidth="4.4" markerHeight="4" orient="auto">` +
    `<path d="M2 0L-9 5V-5Z" fill="${colour}"/></marker>`).join('');

// Returns the largest number that is not above x and is 1, 2 or 5 times a power of ten.
function round_below(x) {
  const power = 10 ** Math.floor(Math.log10(x));
  return power * (x < 2 * power ? 1 : x < 5 * power ? 2 : 5);
}

// The mechanism at an instant, as the camera sees it: what marks need to write their SVG.
class View {
  constructor({camera, data, colours}, instant) {
    Object.assign(this, {camera, data, instant, colour: data.colour[colours]});
    this.unit = camera.unit;  // size of glyphs, 1 as a rule
    this.length = camera.unit / camera.scale;  // a glyph's pixel, in the mechanism's unit of length
    this.points = data.points.map(point => at(data, point, instant));
  }
  point(p) { return this.points[p]; }
  vector(v) { return at(this.data, this.data.vectors[v], this.instant); }
  px(x) { return this.camera.project(x).slice(0, 2).map(number).join(' '); }
  near(p) { return this.camera.project(this.points[p])[2]; }
  wide(px) { return number(px * this.unit); }
}

export class Picture {
  constructor(stage, data) {
    Object.assign(this, {stage, data, instant: 0, traced: new Map(), shown: {}, colours: 'group', open: []});
    this.marks = draw(data);
    this.camera = new Camera(stage, data, usual_length(data), () => this.draw());
    this.camera.fit();
  }

  // Returns the place of a point in the picture [px].
  screen(p) { return this.camera.project(at(this.data, this.data.points[p], this.instant)).slice(0, 2); }

  // Returns the positions of all points, read from the picture as it is drawn from above and, in
  // space, from the front.
  positions() {
    const {camera, data} = this, kept = {...camera};
    const views = data.dimension === 2 ? [Math.PI / 2] : [Math.PI / 2, 0];
    const seen = views.map(height => {
      camera.look(0, height, Infinity);
      camera.fit();
      return Array.from(this.stage.querySelectorAll('[data-point]'), dot => {
        const {e, f} = dot.transform.baseVal.getItem(0).matrix;
        return [dot.dataset.point, [(e - camera.origin[0]) / camera.scale, (camera.origin[1] - f) / camera.scale]];
      });
    }).map(Object.fromEntries);
    Object.assign(camera, kept);
    this.draw();
    return Object.fromEntries(data.points.map(({name}, p) => [name,
      [...seen[0][p], ...seen.slice(1).map(front => front[p][1])].map((x, axis) => x + camera.middle[axis])]));
  }

  // ---- what there is ----

  // Returns the SVG of all marks, in space from the back to the front: a mark is as near as the
  // mean of its points, and a joint, driver or point is no farther than the links and plates at its
  // points.
  #drawn(view) {
    const {camera} = this;
    const links = new Map();  // by point: nearness of the nearest plate, rail or link there
    const marks = this.marks.map(({layer, body, at: points, svg}) => {
      let near = 0;
      if (camera.spatial) {
        near = points.reduce((sum, p) => sum + view.near(p), 0) / points.length;
        for (const p of points)
          if (layer <= layers.links) links.set(p, Math.max(near, links.get(p) ?? near));
          else near = Math.max(near, links.get(p) ?? near);
      }
      return {near, svg: body > 0 ? `<g data-body="${body}">${svg(view)}</g>` : svg(view)};
    });
    return marks.sort((a, b) => a.near - b.near).map(mark => mark.svg).join('\n');
  }

  #traces(view) {
    const {data} = this;
    return Array.from(this.traced, ([p, owner]) => {
      const path = data.times.map((_, i) =>
        `${i === 0 || data.holes.has(i) ? 'M' : 'L'}${view.px(at(data, data.points[p], i))}`).join('');
      return `<path class="trace" d="${path}" stroke="${view.colour(owner)}" stroke-width="1.3" stroke-opacity=".75"/>`;
    }).join('\n');
  }

  #names() {
    if (!this.shown.names) return '';
    return this.data.points.map(({name}, p) => {
      const [x, y] = this.screen(p);
      return text(x + 9, y - 8, name, 'var(--ink)', 'start');
    }).join('\n');
  }

  #rates() { return Object.keys(rates).filter(kind => this.shown[kind]); }

  // Returns the arrows of velocities or accelerations; that of the largest is `arrow` long.
  #arrows(view, kind) {
    const {data, camera} = this, length = arrow / camera.scale / data.longest[kind];
    return data.points.map((point, p) => {
      const from = view.point(p), to = plus(from, length, at(data, point, this.instant, kind));
      const [[x, y], [u, v]] = [from, to].map(end => camera.project(end));
      return Math.hypot(u - x, v - y) < 1 ? '' : `<path class="${kind}" d="M${view.px(from)}L${view.px(to)}" ` +
          `stroke="${rates[kind]}" stroke-width="2" marker-end="url(#${kind})"/>`;
    }).join('\n');
  }

  // Returns a grid below a spatial mechanism, in a plane of constant z; '' for a plane mechanism.
  #grid(view) {
    const {data, camera} = this;
    if (!camera.spatial) return '';
    const far = 0.8 * data.size, z = data.low[2] - 0.04 * data.size, [x, y] = camera.middle;
    const path = Array.from({length: 17}, (_, k) => (k / 8 - 1) * far).map(off =>
      `M${view.px([x + off, y - far, z])}L${view.px([x + off, y + far, z])}` +
      `M${view.px([x - far, y + off, z])}L${view.px([x + far, y + off, z])}`).join('');
    return `<path d="${path}" stroke="var(--line)"/>`;
  }

  // Returns what stands in the corners: the axes of the ground's frame, and scales of lengths and
  // arrows.
  #scales(width, height) {
    const {data, camera} = this;
    const axes = ['x', 'y', 'z'].slice(0, data.dimension).map((name, axis) => {
      const x = camera.right[axis], y = -camera.up[axis];
      return `<path d="M36 ${height - 36}l${number(22 * x)} ${number(22 * y)}" stroke="var(--soft)" stroke-width="1.5"/>` +
          text(36 + 31 * x, height - 32 + 31 * y, name, 'var(--soft)', 'middle');
    });
    // Returns a bar of a round length that ends at x. scale: pixels for each unit.
    const bar = (scale, x, y, kind, unit, colour, path) => {
      const long = round_below(width / 5 / scale), left = number(x - long * scale);
      return `<path d="${path(left)}" stroke="${colour}" stroke-width="2"${kind && ` marker-end="url(#${kind})"`}/>` +
          text(x, y - 7, `${kind} ${Number(long.toPrecision(1))}${unit === '1' ? '' : ` ${unit}`}`.trim(), colour, 'end');
    };
    const arrows = this.#rates().map(kind => {
      const x = kind === 'velocity' ? 14 + width / 4 : width - 14;
      return bar(arrow / data.longest[kind], x, 28, kind, data.units[kind === 'velocity' ? 1 : 2], rates[kind], left => `M${left} 28H${x}`);
    });
    const right = width - 14, low = height - 12;
    return [...axes, ...arrows, bar(camera.scale, right, low, '', data.units[0], 'var(--soft)',
                                    left => `M${left} ${low - 5}v5H${right}v-5`)].join('\n');
  }

  // Returns the part of the picture that changes from instant to instant.
  #moving() {
    const view = new View(this, this.instant);
    const rings = this.open.map(p => `<circle class="open" r="13" stroke="var(--alarm)" stroke-width="2" ` +
        `transform="translate(${view.px(view.point(p))})"/>`);
    return [`<g${this.stuck ? ' opacity=".5"' : ''}>`, this.#drawn(view), '</g>',
            ...this.#rates().map(kind => this.#arrows(view, kind)), ...rings, this.#names()].join('\n');
  }

  // Returns the picture as SVG.
  svg() {
    const {clientWidth: width, clientHeight: height} = this.stage, view = new View(this, this.instant);
    return [
      `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" font-family="system-ui, sans-serif" ` +
          'font-size="13" fill="none" stroke-linecap="round" stroke-linejoin="round">',
      `<defs>${heads}</defs>`, this.#grid(view), this.#traces(view), '<g class="moving">', this.#moving(), '</g>',
      this.#scales(width, height), '</svg>',
    ].join('\n');
  }

  // Returns the picture as the text of an SVG file: with a background, in the colours of a light
  // page.
  file() {
    const light = document.styleSheets[0].cssRules[0].style;
    return this.svg().replace('\n', '\n<rect width="100%" height="100%" fill="var(--stage)"/>\n')
        .replace(/var\((--\w+)\)/g, (_, name) => light.getPropertyValue(name).trim()) + '\n';
  }

  draw() { this.stage.innerHTML = this.svg(); }

  // ---- what is chosen ----

  show(instant) {
    this.instant = instant;
    this.stage.querySelector('.moving').innerHTML = this.#moving();
  }

  // Shows or hides 'names', or arrows of 'velocity' or 'acceleration'.
  choose(what, shown) {
    this.shown[what] = shown;
    this.draw();
  }

  // Colours bodies by 'group' or by 'body'.
  colourBy(what) {
    this.colours = what;
    this.draw();
  }

  // Shows or hides the path of a point, in the colour of a body.
  trace(p, owner, shown) {
    if (shown) this.traced.set(p, owner);
    else this.traced.delete(p);
    this.draw();
  }

  // Marks points of a constraint that does not close, when the picture is drawn next. stuck: the
  // position shown is not that of the current time.
  mark(points, stuck) { Object.assign(this, {open: points, stuck}); }
}

// The picture of a planar mechanism, in SVG. Everything is placed in pixels by the position and
// scale of the view, so that joints keep their size.
import {arc, marked, shapes} from './geometry.js';
import {at} from './data.js';
import {start} from './main.js';

const names = 'http://www.w3.org/2000/svg';
const joint_size = 6;  // px

function add(parent, tag, attributes) {
  const element = document.createElementNS(names, tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  parent.append(element);
  return element;
}

const place = (element, x, y, angle = 0) =>
    element.setAttribute('transform', `translate(${x} ${y}) rotate(${angle})`);

class PlanarPicture {
  constructor(stage, data) {
    this.data = data;
    this.stage = stage;
    this.svg = add(stage, 'svg', {});
    this.layers = Object.fromEntries(['rails', 'traces', 'bodies', 'drivers', 'arrows', 'joints', 'marks']
        .map(name => [name, add(this.svg, 'g', {class: name})]));
    this.moving = [];  // functions that place what moves: (instant) => …
    this.traced = new Map();
    this.arrows = {velocity: false, acceleration: false};
    this.#build();
    this.instant = 0;
    this.fit();
    this.#steer();
    new ResizeObserver(() => this.fit()).observe(stage);
  }

  // ---- what is where ----

  #world(p, i) { return at(this.data, this.data.points[p], i); }
  #px([x, y]) { return [this.origin[0] + this.scale * x, this.origin[1] - this.scale * y]; }
  screen(p) { return this.#px(this.#world(p, this.instant)); }
  // Returns the position of a point as the picture has it.
  position(p) {
    const [, x, y] = this.points[p].getAttribute('transform').match(/translate\((\S+) (\S+)\)/);
    return [(x - this.origin[0]) / this.scale, (this.origin[1] - y) / this.scale];
  }

  fit() {
    const low = [Infinity, Infinity], high = [-Infinity, -Infinity];
    const step = Math.max(1, this.data.shown >> 7);
    for (let p = 0; p < this.data.points.length; ++p)
      for (let i = 0; i < this.data.shown; i += step)
        this.#world(p, i).forEach((x, axis) => {
          low[axis] = Math.min(low[axis], x);
          high[axis] = Math.max(high[axis], x);
        });
    const {clientWidth: width, clientHeight: height} = this.stage;
    this.svg.setAttribute('viewBox', `0 0 ${width} ${height}`);
    const margin = 46;
    this.scale = Math.min((width - 2 * margin) / (high[0] - low[0] || 1e-9 * this.data.size),
                          (height - 2 * margin) / (high[1] - low[1] || 1e-9 * this.data.size),
                          2 * Math.max(width, height) / this.data.size);
    this.origin = [width / 2 - this.scale * (low[0] + high[0]) / 2,
                   height / 2 + this.scale * (low[1] + high[1]) / 2];
    this.redraw();
  }

  zoom(by, about = [this.stage.clientWidth / 2, this.stage.clientHeight / 2]) {
    this.scale *= by;
    this.origin = this.origin.map((x, axis) => about[axis] + by * (x - about[axis]));
    this.redraw();
  }

  #steer() {
    let from = null;
    this.stage.addEventListener('pointerdown', event => {
      from = [event.clientX, event.clientY];
      this.stage.setPointerCapture(event.pointerId);
      this.stage.classList.add('grabbed');
    });
    this.stage.addEventListener('pointermove', event => {
      if (!from) return;
      this.origin = [this.origin[0] + event.clientX - from[0], this.origin[1] + event.clientY - from[1]];
      from = [event.clientX, event.clientY];
      this.redraw();
    });
    for (const type of ['pointerup', 'pointercancel'])
      this.stage.addEventListener(type, () => {
        from = null;
        this.stage.classList.remove('grabbed');
      });
    this.stage.addEventListener('wheel', event => {
      if (!event.ctrlKey && document.activeElement !== this.stage) return;  // the reader scrolls
      event.preventDefault();
      this.zoom(Math.exp(-event.deltaY / 600), [event.offsetX, event.offsetY]);
    }, {passive: false});
  }

  // ---- what there is ----

  #build() {
    shapes(this.data);
    this.data.bodies.forEach((body, b) => b > 0 && this.#addBody(body));
    for (const [a, b] of this.data.measures) {
      const line = add(this.layers.rails, 'line', {class: 'guide'});
      this.moving.push(i => this.#line(line, this.#world(a, i), this.#world(b, i)));
    }
    for (const joint of this.data.joints) this.#addJoint(joint);
    for (const driver of this.data.drivers) this.#addDriver(driver);
    this.points = this.data.points.map((point, p) => {
      const dot = add(this.layers.marks, 'circle', {r: 2, class: 'dot', fill: 'var(--ink)'});
      this.moving.push(i => place(dot, ...this.#px(this.#world(p, i))));
      return dot;
    });
    this.open = add(this.layers.marks, 'g', {class: 'opened'});
  }

  #addBody(body) {
    const colour = this.data.colour(body.group);
    const group = add(this.layers.bodies, 'g', {class: 'body', style: `color:${colour}`});
    if (body.plate.length > 0) {
      const plate = add(group, 'polygon', {class: 'plate', fill: colour});
      this.moving.push(i => plate.setAttribute(
          'points', body.plate.map(p => this.#px(this.#world(p, i)).join()).join(' ')));
    }
    for (const [a, b] of body.edges) {
      const link = add(group, 'line', {class: 'link', stroke: colour, 'stroke-width': body.plate.length > 0 ? 4 : 6});
      this.moving.push(i => this.#line(link, this.#world(a, i), this.#world(b, i)));
    }
  }

  #line(line, a, b) {
    const [x1, y1] = this.#px(a), [x2, y2] = this.#px(b);
    line.setAttribute('x1', x1), line.setAttribute('y1', y1);
    line.setAttribute('x2', x2), line.setAttribute('y2', y2);
  }

  #addJoint(joint) {
    const grounded = joint.bodies.includes(0);
    if (joint.rail) return this.#addSlider(joint, grounded);
    const [p] = joint.points;
    if (p === undefined) return;
    if (grounded) {
      const pivot = add(this.layers.rails, 'g', {class: 'ground'});
      add(pivot, 'path', {class: 'pivot', d: 'M0 0L-11 17H11Z'});
      add(pivot, 'path', {class: 'hatch', d: 'M-17 17H17M-13 17l-5 7M-6 17l-5 7M1 17l-5 7M8 17l-5 7M15 17l-5 7'});
      this.moving.push(i => place(pivot, ...this.#px(this.#world(p, i))));
    }
    const mark = joint.type === 'fixed'
        ? add(this.layers.joints, 'rect', {class: 'joint', x: -5, y: -5, width: 10, height: 10})
        : add(this.layers.joints, 'circle', {class: 'joint', r: joint_size});
    this.moving.push(i => place(mark, ...this.#px(this.#world(p, i))));
  }

  // A rail along the axis and a block that slides on it: hatched on the ground, in the colour of a
  // body that carries it; or, where neither body has another point, a rod in a sleeve.
  #addSlider(joint, grounded) {
    const {origin, axis, slider, reach} = joint.rail;
    if (!grounded && joint.type === 'prismatic') return this.#addSleeve(joint);
    const sliding = joint.bodies[1] === 0 ? origin : slider, still = sliding === slider ? origin : slider;
    const sign = still === origin ? 1 : -1;
    const carrier = this.data.bodies[joint.bodies[0]];
    const rail = add(this.layers.rails, 'path', grounded ? {class: 'rail'}
        : {class: 'link', stroke: this.data.colour(carrier.group), 'stroke-width': 3});
    const block = add(this.layers.joints, 'rect',
                      {class: 'joint', x: -13, y: -8, width: 26, height: 16, rx: 2});
    const hinge = joint.type === 'revolute_on_slider'
        ? add(this.layers.joints, 'circle', {class: 'joint', r: 4}) : null;
    this.moving.push(i => {
      const d = at(this.data, this.data.vectors[axis], i), o = this.#px(this.#world(still, i));
      const along = [sign * d[0], -sign * d[1]];
      const ends = reach.map(x => x * this.scale);
      const shift = grounded ? 9 : 0;  // the rail runs below the block
      const below = along[0] < 0 ? [along[1], -along[0]] : [-along[1], along[0]];
      const point = (x, off) => `${o[0] + x * along[0] + off * below[0]} ${o[1] + x * along[1] + off * below[1]}`;
      let path = `M${point(ends[0], shift)}L${point(ends[1], shift)}`;
      if (grounded)
        for (let x = ends[0]; x < ends[1]; x += Math.max(9, (ends[1] - ends[0]) / 60))
          path += `M${point(x + 5, shift)}L${point(x, shift + 7)}`;
      rail.setAttribute('d', path);
      const angle = Math.atan2(along[1], along[0]) * 180 / Math.PI;
      const here = this.#px(this.#world(sliding, i));
      place(block, ...here, angle);
      if (hinge) place(hinge, ...here);
    });
  }

  #addSleeve(joint) {
    const {origin, slider, reach} = joint.rail;
    const [outer, inner] = joint.bodies.map(b => this.data.colour(this.data.bodies[b].group));
    const rod = add(this.layers.bodies, 'line', {class: 'link', stroke: inner, 'stroke-width': 4});
    const sleeve = add(this.layers.bodies, 'line', {class: 'sleeve', stroke: outer});
    const most = Math.max(...reach.map(Math.abs)) - 0.06 * this.data.size;
    this.moving.push(i => {
      const o = this.#world(origin, i), s = this.#world(slider, i);
      const long = Math.hypot(s[0] - o[0], s[1] - o[1]) || 1;
      this.#line(rod, o, s);
      this.#line(sleeve, o, o.map((x, k) => x + (s[k] - x) * 0.55 * most / long));
    });
  }

  // An arc or an arrow, from where the driver's coordinate is zero.
  #addDriver(driver) {
    const [p, other] = marked(this.data, driver);
    if (p === undefined) return;
    const line = add(this.layers.drivers, 'path', {class: 'driver'});
    const head = add(this.layers.drivers, 'path', {class: 'driver head', d: 'M2 0L-9 5V-5Z'});
    const degrees = 180 / Math.PI;
    this.moving.push(i => {
      const [x, y] = this.#px(this.#world(p, i));
      if (driver.type === 'angle') {
        const {begin, sweep} = arc(this.data, driver, i), r = 22;
        const on = a => `${x + r * Math.cos(a)} ${y - r * Math.sin(a)}`;
        line.setAttribute('d', `M${x} ${y}L${on(begin)}A${r} ${r} 0 0 ${sweep > 0 ? 0 : 1} ${on(begin + sweep)}`);
        const end = begin + sweep;
        place(head, x + r * Math.cos(end), y - r * Math.sin(end), -end * degrees - Math.sign(sweep) * 90);
        return;
      }
      let from = [x, y], to = [x, y];
      if (other !== undefined) to = this.#px(this.#world(other, i));
      else from = driver.axis === 0 ? [x - 34, y] : [x, y + 34];
      line.setAttribute('d', `M${from.join(' ')}L${to.join(' ')}`);
      const on = axis => from[axis] + (other === undefined ? 1 : 0.75) * (to[axis] - from[axis]);
      place(head, on(0), on(1), Math.atan2(to[1] - from[1], to[0] - from[0]) * degrees);
    });
  }

  // ---- what is chosen ----

  trace(p, colour) {
    if (!colour) {
      this.traced.get(p)?.remove();
      this.traced.delete(p);
      return;
    }
    if (!this.traced.has(p))
      this.traced.set(p, add(this.layers.traces, 'path', {class: 'trace', style: `stroke:${colour}`}));
    this.#drawTraces();
  }

  #drawTraces() {
    for (const [p, path] of this.traced) {
      let d = '';
      this.data.times.forEach((_, i) => {
        const [x, y] = this.#px(this.#world(p, i));
        d += `${i === 0 || this.data.holes.has(i) ? 'M' : 'L'}${x.toFixed(2)} ${y.toFixed(2)}`;
      });
      path.setAttribute('d', d);
    }
  }

  showArrows(kind, shown) {
    this.arrows[kind] = shown;
    this.layers.arrows.querySelectorAll(`.${kind}`).forEach(arrow => arrow.remove());
    if (shown)
      this.data.points.forEach((point, p) => {
        if (point.fixed) return;
        const arrow = add(this.layers.arrows, 'path', {class: kind, 'data-point': p});
        arrow.dataset.kind = kind;
      });
    this.show(this.instant);
  }

  #drawArrows(i) {
    for (const arrow of this.layers.arrows.children) {
      const kind = arrow.dataset.kind, p = Number(arrow.dataset.point);
      const rate = at(this.data, this.data.points[p], i, kind);
      const scale = 90 / this.data.longest(kind);
      const [x, y] = this.#px(this.#world(p, i)), dx = rate[0] * scale, dy = -rate[1] * scale;
      const long = Math.hypot(dx, dy);
      if (long < 1) {
        arrow.setAttribute('d', '');
        continue;
      }
      const ux = dx / long, uy = dy / long, h = Math.min(8, long);
      arrow.setAttribute('d', `M${x} ${y}l${dx} ${dy}l${-h * ux - h / 2 * uy} ${-h * uy + h / 2 * ux}` +
          `l${h * uy} ${-h * ux}l${h * ux - h / 2 * uy} ${h * uy + h / 2 * ux}`);
    }
  }

  // Marks points whose constraint does not close; stuck: the position is not that of this time.
  mark(points, stuck) {
    this.svg.classList.toggle('stuck', stuck);
    this.open.replaceChildren(...points.map(p => {
      const ring = add(this.open, 'circle', {class: 'open', r: 13});
      place(ring, ...this.screen(p));
      return ring;
    }));
  }

  redraw() {
    this.#drawTraces();
    this.show(this.instant);
    this.onRedraw?.();
  }

  show(i) {
    this.instant = i;
    for (const move of this.moving) move(i);
    this.#drawArrows(i);
  }
}

start((stage, data) => new PlanarPicture(stage, data), 'the picture moves and zooms');

// The picture of a planar mechanism, in SVG. Everything is placed in pixels by the position and
// scale of the view, so that joints keep their size.
import {at} from './data.js';
import {shapes} from './geometry.js';
import {start} from './main.js';
import {add, addDriver, addJoint, place, width} from './planar_parts.js';

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

  world(p, i) { return at(this.data, this.data.points[p], i); }
  px([x, y]) { return [this.origin[0] + this.scale * x, this.origin[1] - this.scale * y]; }
  screen(p) { return this.px(this.world(p, this.instant)); }
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
        this.world(p, i).forEach((x, axis) => {
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
      this.moving.push(i => this.line(line, this.world(a, i), this.world(b, i)));
    }
    for (const joint of this.data.joints) addJoint(this, joint);
    for (const driver of this.data.drivers) addDriver(this, driver);
    this.points = this.data.points.map((point, p) => {
      const dot = add(this.layers.marks, 'circle', {r: 2, class: 'dot', fill: 'var(--ink)'});
      this.moving.push(i => place(dot, this.px(this.world(p, i)), this.unit));
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
          'points', body.plate.map(p => this.px(this.world(p, i)).join()).join(' ')));
    }
    for (const [a, b] of body.edges) {
      const link = add(group, 'line', {class: 'link', stroke: colour, style: width(body.plate.length > 0 ? 4 : 6)});
      this.moving.push(i => this.line(link, this.world(a, i), this.world(b, i)));
    }
  }

  line(line, a, b) {
    const [x1, y1] = this.px(a), [x2, y2] = this.px(b);
    line.setAttribute('x1', x1), line.setAttribute('y1', y1);
    line.setAttribute('x2', x2), line.setAttribute('y2', y2);
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
        const [x, y] = this.px(this.world(p, i));
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
      const [x, y] = this.px(this.world(p, i)), dx = rate[0] * scale, dy = -rate[1] * scale;
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
      place(ring, this.screen(p), this.unit);
      return ring;
    }));
  }

  // Joints and links are smaller where bodies are.
  #findUnit() {
    const long = ([p, q]) => Math.hypot(...this.world(p, 0).map((x, axis) => x - this.world(q, 0)[axis]));
    const lengths = this.data.bodies.filter(body => body.edges.length > 0)
        .map(body => Math.max(...body.edges.map(long))).sort((a, b) => a - b);
    const usual = lengths.length > 0 ? this.scale * lengths[lengths.length >> 1] : Infinity;
    this.unit = Math.min(1, Math.max(0.25, usual / 60));
    this.svg.style.setProperty('--unit', this.unit);
  }

  redraw() {
    this.#findUnit();
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

// The view of the mechanism: from which side, how large, and which part. A plane mechanism is seen
// from above. The view shows the whole mechanism until the reader moves or zooms it.
import {dot, minus} from './data.js';

const margin = 46;  // blank border about the mechanism [px]
const distance = 4;  // distance of the eye from the middle of the mechanism, in data.size
const usual = 60;  // length of links [px] below which glyphs are smaller than usual
// Changes of turn and height [rad] by key.
const turns = {ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1]};

export class Camera {
  // usual_length: usual length of a link, in the mechanism's unit of length. moved: called when the
  // view has changed.
  constructor(stage, data, usual_length, moved) {
    Object.assign(this, {stage, data, usual_length, moved, spatial: data.dimension === 3});
    const {low, high} = data;
    this.middle = low.map((x, axis) => (x + high[axis]) / 2);
    this.corners = Array.from({length: 8}, (_, k) => low.map((x, axis) => k >> axis & 1 ? high[axis] : x));
    this.look(...this.spatial ? [0.555, 0.4] : [0, Math.PI / 2]);
    this.#steer();
    new ResizeObserver(() => this.steered ? moved() : this.fit()).observe(stage);
  }

  // Places the eye: its angles about the vertical and above the horizon [rad], and its distance
  // from the middle in sizes of the mechanism.
  look(turn, height, eye = distance) {
    Object.assign(this, {turn, height, eye: eye * this.data.size});
    const [c, s, up] = [Math.cos(turn), Math.sin(turn), Math.sin(height)];
    this.right = [c, s, 0];
    this.up = [-s * up, c * up, Math.cos(height)];
    this.toward = [s * Math.cos(height), -c * Math.cos(height), up];
  }

  // Returns where a position is seen: how far to the right of the middle, how far above it, and how
  // much nearer to the eye. The three are lengths in the mechanism's unit. Perspective enlarges the
  // first two near the eye.
  #seen(x) {
    const d = minus(x, this.middle), near = dot(d, this.toward);
    const grown = 1 / Math.max(1 - near / this.eye, 1e-3);
    return [grown * dot(d, this.right), grown * dot(d, this.up), near];
  }

  // Returns the place of a position in the picture [px], and its nearness as #seen() does.
  project(x) {
    const [right, up, near] = this.#seen(x);
    return [this.origin[0] + this.scale * right, this.origin[1] - this.scale * up, near];
  }

  // Returns the size of glyphs, from 0.25 to 1; 1 is the usual one.
  get unit() { return Math.min(1, Math.max(0.25, this.scale * this.usual_length / usual)); }

  // Shows the whole mechanism, also when the stage changes its size, until the reader moves or
  // zooms.
  fit() {
    this.steered = false;
    const {clientWidth: width, clientHeight: height} = this.stage;
    const seen = this.corners.map(x => this.#seen(x));
    const [right, up] = [0, 1].map(axis => seen.map(x => x[axis]));
    const tiny = 1e-9 * this.data.size;
    this.scale = Math.min((width - 2 * margin) / (Math.max(...right) - Math.min(...right) || tiny),
                          (height - 2 * margin) / (Math.max(...up) - Math.min(...up) || tiny),
                          2 * Math.max(width, height) / this.data.size);
    this.origin = [width / 2 - this.scale * (Math.min(...right) + Math.max(...right)) / 2,
                   height / 2 + this.scale * (Math.min(...up) + Math.max(...up)) / 2];
    this.moved();
  }

  zoom(by, about = [this.stage.clientWidth / 2, this.stage.clientHeight / 2]) {
    this.steered = true;
    this.scale *= by;
    this.origin = this.origin.map((x, axis) => about[axis] + by * (x - about[axis]));
    this.moved();
  }

  #pan(x, y) {
    this.steered = true;
    this.origin = [this.origin[0] + x, this.origin[1] + y];
    this.moved();
  }

  #turn(right, up) {
    this.look(this.turn + right, Math.min(1.55, Math.max(-1.55, this.height + up)));
    if (this.steered) this.moved();
    else this.fit();
  }

  // Dragging moves a plane mechanism and turns a spatial one; with shift, another button or two
  // fingers, it moves either. Two fingers zoom, as does the wheel with ctrl or while the picture
  // has the focus. Arrow keys turn a spatial mechanism while the picture has the focus.
  #steer() {
    const {stage} = this, fingers = new Map();
    if (this.spatial) stage.dataset.turns = 'true';
    const spread = () => {
      const [a, b] = [...fingers.values()];
      return {about: [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2], wide: Math.hypot(a[0] - b[0], a[1] - b[1]) || 1};
    };
    stage.addEventListener('pointerdown', event => {
      fingers.set(event.pointerId, [event.offsetX, event.offsetY]);
      stage.setPointerCapture(event.pointerId);
      stage.classList.add('grabbed');
    });
    stage.addEventListener('pointermove', event => {
      const from = fingers.get(event.pointerId), to = [event.offsetX, event.offsetY];
      if (!from) return;
      const before = fingers.size === 2 && spread();
      fingers.set(event.pointerId, to);
      const moved = [to[0] - from[0], to[1] - from[1]];
      if (before) {
        const {about, wide} = spread();
        this.#pan(about[0] - before.about[0], about[1] - before.about[1]);
        this.zoom(wide / before.wide, about);
      } else if (this.spatial && !event.shiftKey && event.buttons === 1) {
        this.#turn(-moved[0] / 150, moved[1] / 150);
      } else {
        this.#pan(...moved);
      }
    });
    for (const type of ['pointerup', 'pointercancel'])
      stage.addEventListener(type, event => {
        fingers.delete(event.pointerId);
        stage.classList.toggle('grabbed', fingers.size > 0);
      });
    stage.addEventListener('contextmenu', event => this.spatial && event.preventDefault());
    stage.addEventListener('wheel', event => {
      if (!event.ctrlKey && document.activeElement !== stage) return;  // the wheel scrolls the page
      event.preventDefault();
      this.zoom(Math.exp(-event.deltaY / 600), [event.offsetX, event.offsetY]);
    }, {passive: false});
    stage.addEventListener('keydown', event => {
      if (!this.spatial || !turns[event.key] || event.shiftKey) return;
      event.preventDefault();
      this.#turn(...turns[event.key]);
    });
  }
}

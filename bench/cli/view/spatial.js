// The picture of a spatial mechanism, in WebGL. Lengths are over the mechanism's size and about its
// middle. Equal shapes are instances of one mesh, so that a frame is a few calls.
import {
  AmbientLight, BufferGeometry, Color, ConeGeometry, CylinderGeometry, DirectionalLight, Group, Line,
  LineBasicMaterial, Matrix4, MeshBasicMaterial, Scene, SphereGeometry, Vector3, WebGLRenderer,
} from 'three';
import {at} from './data.js';
import {Eye} from './eye.js';
import {shapes} from './geometry.js';
import {Instances, round, thin} from './instances.js';
import {start} from './main.js';
import {addAxes, addDrivers, addGround, addPlates, addRail} from './spatial_parts.js';

const a = new Vector3(), matrix = new Matrix4();

class SpatialPicture {
  constructor(stage, data) {
    Object.assign(this, {stage, data, instant: 0, scene: new Scene(), moving: [], traced: new Map(), arrows: {}});
    shapes(data);
    this.#frameOf();
    this.unit = this.#unit();
    this.renderer = new WebGLRenderer({antialias: true, alpha: true, preserveDrawingBuffer: true});
    this.renderer.debug.checkShaderErrors = false;  // to ask would wait
    stage.append(this.renderer.domElement);
    const reach = [this.low, this.high].map(end => end.map((x, axis) => (x - this.middle[axis]) / data.size));
    this.eye = new Eye(stage, this.renderer, reach, () => this.render());
    this.scene.add(new AmbientLight(0xffffff, 1.6));
    const light = new DirectionalLight(0xffffff, 2);
    light.position.set(1, -2, 4);
    this.scene.add(light);
    this.#build();
    this.fit();
    this.#colours();
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.#colours());
    for (const type of ['beforeprint', 'afterprint']) window.addEventListener(type, () => this.#colours());
  }

  // ---- what is where ----

  #frameOf() {
    const {data} = this;
    this.low = [Infinity, Infinity, Infinity];
    this.high = [-Infinity, -Infinity, -Infinity];
    for (const point of data.points)
      for (let i = 0; i < data.shown; i += Math.max(1, data.shown >> 7))
        at(data, point, i).forEach((x, axis) => {
          this.low[axis] = Math.min(this.low[axis], x);
          this.high[axis] = Math.max(this.high[axis], x);
        });
    this.middle = this.low.map((x, axis) => (x + this.high[axis]) / 2);
  }

  // Returns the size of joints and links: smaller where bodies are small in a large mechanism.
  #unit() {
    const {data} = this;
    const long = ([p, q]) => Math.hypot(...at(data, data.points[p], 0).map(
        (x, axis) => x - at(data, data.points[q], 0)[axis])) / data.size;
    const lengths = data.bodies.filter(body => body.edges.length > 0)
        .map(body => Math.max(...body.edges.map(long))).sort((x, y) => x - y);
    return Math.min(1, Math.max(0.3, 5 * (lengths[lengths.length >> 1] ?? 1)));
  }

  #world(p, i, to) {
    const x = at(this.data, this.data.points[p], i), {middle, data: {size}} = this;
    return to.set((x[0] - middle[0]) / size, (x[1] - middle[1]) / size, (x[2] - middle[2]) / size);
  }
  direction(v, i, to) { return to.fromArray(at(this.data, this.data.vectors[v], i)); }

  screen(p) {
    const x = this.placed[p].clone().project(this.eye.camera);
    return [(x.x + 1) / 2 * this.stage.clientWidth, (1 - x.y) / 2 * this.stage.clientHeight];
  }
  // Returns the position of a point as the picture has it.
  position(p) {
    this.dots.mesh.getMatrixAt(p, matrix);
    a.setFromMatrixPosition(matrix);
    return a.toArray().map((x, axis) => this.middle[axis] + x * this.data.size);
  }

  // ---- what there is ----

  #build() {
    const {data, scene} = this;
    const link = thin * this.unit, ball = round * this.unit;
    const cylinder = new CylinderGeometry(1, 1, 1, 14);
    this.placed = data.points.map(() => new Vector3());
    const edges = data.bodies.flatMap(body => body.edges.map(ends => ({body, ends})));
    const rails = data.joints.filter(j => j.rail);
    this.links = new Instances(scene, cylinder, edges.length + 2 * rails.length + data.measures.length);
    this.links.group = [];
    edges.forEach(({body, ends: [p, q]}, k) => {
      this.links.group[k] = body.group;
      this.moving.push(() => this.links.between(k, this.placed[p], this.placed[q], body.plate.length > 0 ? 0.7 * link : link));
    });
    rails.forEach((joint, k) => addRail(this, joint, edges.length + 2 * k));
    data.measures.forEach(([p, q], k) => {
      const place = edges.length + 2 * rails.length + k;
      this.links.group[place] = -1;
      this.moving.push(() => this.links.between(place, this.placed[p], this.placed[q], 0.25 * link));
    });
    this.dots = new Instances(scene, new SphereGeometry(1, 14, 10), data.points.length);
    data.points.forEach((point, p) => {
      const spherical = point.joints.some(j => j.type === 'spherical');
      const radius = spherical ? ball : point.joints.length > 0 ? 0.8 * ball : 0.75 * link;
      matrix.makeScale(radius, radius, radius);
      this.moving.push(() => {
        matrix.makeScale(radius, radius, radius).setPosition(this.placed[p]);
        this.dots.mesh.setMatrixAt(p, matrix);
      });
    });
    addAxes(this, cylinder.clone());  // a shape of two meshes would be bound anew in every frame
    addPlates(this);
    addGround(this);
    addDrivers(this);
  }

  // ---- what is chosen ----

  trace(p, colour) {
    this.traced.get(p)?.removeFromParent();
    this.traced.delete(p);
    if (!colour) return;
    const group = new Group();
    let run = [];
    const finish = () => {
      if (run.length > 1) {
        const geometry = new BufferGeometry().setFromPoints(run);
        group.add(new Line(geometry, new LineBasicMaterial({color: this.#css(colour)})));
      }
      run = [];
    };
    for (let i = 0; i < this.data.shown; ++i) {
      if (this.data.holes.has(i)) finish();
      run.push(this.#world(p, i, new Vector3()));
    }
    finish();
    this.traced.set(p, group);
    this.scene.add(group);
    this.render();
  }

  showArrows(kind, shown) {
    for (const part of this.arrows[kind] ?? []) part.mesh.removeFromParent();
    delete this.arrows[kind];
    const colour = this.#css(kind === 'velocity' ? 'var(--speed)' : 'var(--pull)');
    if (shown) {
      const {length} = this.data.points;
      this.arrows[kind] = [new CylinderGeometry(1, 1, 1, 8), new ConeGeometry(1, 1, 10)].map(
          geometry => new Instances(this.scene, geometry, length, new MeshBasicMaterial({color: colour})));
    }
    this.show(this.instant);
  }

  #drawArrows(i) {
    const {data} = this;
    const end = new Vector3(), d = new Vector3();
    for (const [kind, [shafts, heads]] of Object.entries(this.arrows)) {
      data.points.forEach((point, p) => {
        d.fromArray(at(data, point, i, kind)).multiplyScalar(0.2 * this.unit / data.longest(kind));
        if (d.length() < 2e-3) return shafts.hide(p), heads.hide(p);
        end.addVectors(this.placed[p], d);
        shafts.between(p, this.placed[p], end, 0.35 * thin * this.unit);
        heads.along(p, end, d, Math.min(0.025 * this.unit, d.length()), thin * this.unit);
      });
      shafts.done(), heads.done();
    }
  }

  mark(points, stuck) {
    this.opened?.mesh.removeFromParent();
    this.opened = null;
    this.stage.classList.toggle('stuck', stuck);
    if (points.length === 0) return this.render();
    this.opened = new Instances(this.scene, new SphereGeometry(2.2 * round * this.unit, 16, 12), points.length,
                                new MeshBasicMaterial({color: this.#css('var(--alarm)'), transparent: true, opacity: 0.5}));
    points.forEach((p, k) => this.opened.mesh.setMatrixAt(k, matrix.makeTranslation(this.placed[p])));
    this.render();
  }

  #css(colour) {
    const name = colour.match(/var\((.*)\)/)?.[1];
    return new Color(name ? getComputedStyle(document.documentElement).getPropertyValue(name).trim() : colour);
  }

  #colours() {
    const {data} = this;
    const of = g => this.#css(g < 0 ? 'var(--soft)' : data.colour(g));
    const ink = this.#css('var(--ink)'), driver = this.#css('var(--driver)');
    this.links.group.forEach((g, k) => this.links.colour(k, of(g)));
    data.points.forEach((_, p) => this.dots.colour(p, ink));
    for (let k = 0; k < this.axes.mesh.count; ++k) this.axes.colour(k, ink);
    for (let k = 0; k < this.drivers.mesh.count; ++k) this.drivers.colour(k, driver);
    this.plates?.triangles.forEach(({body}, k) => {
      for (let j = 0; j < 3; ++j) of(body.group).toArray(this.plates.colours, 9 * k + 3 * j);
    });
    if (this.plates) this.plates.geometry.attributes.color.needsUpdate = true;
    for (const {mesh} of [this.links, this.dots, this.axes, this.drivers])
      if (mesh.instanceColor) mesh.instanceColor.needsUpdate = true;
    this.render();
  }

  // ---- how it is seen ----

  fit() { this.eye.fit(); }
  zoom(by) { this.eye.zoom(by); }

  // Renders before the next frame is shown, once.
  render() {
    this.due ??= requestAnimationFrame(() => this.#renderNow());
  }

  #renderNow() {
    cancelAnimationFrame(this.due);
    this.due = undefined;
    this.renderer.render(this.scene, this.eye.camera);
  }

  show(i) {
    this.instant = i;
    this.placed.forEach((x, p) => this.#world(p, i, x));
    for (const move of this.moving) move(i);
    for (const part of [this.links, this.dots, this.axes, this.pads, this.drivers]) part.done();
    this.#drawArrows(i);
    this.#renderNow();
  }
}

start((stage, data) => new SpatialPicture(stage, data), 'the camera turns, with the arrow keys too once the picture has the focus');

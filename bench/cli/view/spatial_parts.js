// Rails, axes, plates, ground and drivers of a spatial picture. Each adds its meshes, and functions
// that place them at an instant to `moving`.
import {
  BufferAttribute, BufferGeometry, ConeGeometry, DoubleSide, GridHelper, Matrix4, Mesh, MeshBasicMaterial,
  PlaneGeometry, Vector3,
} from 'three';
import {marked} from './geometry.js';
import {hatching, Instances, round, thin} from './instances.js';

const matrix = new Matrix4(), way = new Vector3();

// A rod along the axis of a sliding joint, and a sleeve about it.
export function addRail(picture, joint, k) {
  const {origin, axis, slider, reach} = joint.rail, {data, unit} = picture;
  const link = thin * unit;
  const grounded = joint.bodies.includes(0);
  const [first, last] = joint.bodies;
  picture.links.group[k] = data.bodies[grounded ? 0 : last].group;
  picture.links.group[k + 1] = data.bodies[first === 0 ? last : first].group;
  const d = new Vector3(), from = new Vector3(), to = new Vector3();
  picture.moving.push(i => {
    picture.direction(axis, i, d);
    const o = picture.placed[origin], s = picture.placed[slider];
    if (grounded) {
      const still = first === 0 ? o : s, moves = first === 0 ? s : o, sign = first === 0 ? 1 : -1;
      from.copy(still).addScaledVector(d, sign * reach[0] / data.size);
      to.copy(still).addScaledVector(d, sign * reach[1] / data.size);
      picture.links.between(k, from, to, 0.6 * link);
      from.copy(moves).addScaledVector(d, -0.03 * unit);
      to.copy(moves).addScaledVector(d, 0.03 * unit);
      picture.links.between(k + 1, from, to, 2 * link);
      return;
    }
    picture.links.between(k, o, s, 0.6 * link);
    const most = Math.max(Math.abs(reach[0]), Math.abs(reach[1])) / data.size - 0.06;
    from.subVectors(s, o).normalize().multiplyScalar(0.55 * most).add(o);
    picture.links.between(k + 1, o, from, 1.5 * link);
  });
}

// The axes of joints that turn: short cylinders across.
export function addAxes(picture, cylinder) {
  const {data, unit} = picture;
  const sizes = {universal: [0.045, 0.5], revolute: [0.06, 1.1]};
  const list = data.joints.filter(j => sizes[j.type] && !j.rail).flatMap(j => j.vectors.map(
      v => ({p: j.points[0], v, long: sizes[j.type][0] * unit, radius: sizes[j.type][1] * thin * unit})));
  picture.axes = new Instances(picture.scene, cylinder, list.length);
  const d = new Vector3();
  list.forEach(({p, v, long, radius}, k) => {
    picture.moving.push(i => picture.axes.along(k, picture.placed[p], picture.direction(v, i, d), long, radius));
  });
}

// Plates of bodies, all in one mesh.
export function addPlates(picture) {
  const {data} = picture;
  const triangles = data.bodies.flatMap(body => body.plate.slice(2).map(
      (_, k) => ({body, corners: [body.plate[0], body.plate[k + 1], body.plate[k + 2]]})));
  if (triangles.length === 0) return;
  const places = new Float32Array(9 * triangles.length);
  picture.plates = {triangles, colours: new Float32Array(9 * triangles.length)};
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(places, 3));
  geometry.setAttribute('color', new BufferAttribute(picture.plates.colours, 3));
  const mesh = new Mesh(geometry, new MeshBasicMaterial(
      {vertexColors: true, transparent: true, opacity: 0.22, side: DoubleSide, depthWrite: false}));
  mesh.frustumCulled = false;
  picture.plates.geometry = geometry;
  picture.scene.add(mesh);
  picture.moving.push(() => {
    triangles.forEach(({corners}, k) =>
        corners.forEach((p, j) => picture.placed[p].toArray(places, 9 * k + 3 * j)));
    geometry.attributes.position.needsUpdate = true;
  });
}

// Hatched pads below what is joined to the ground, and a grid at the lowest point.
export function addGround(picture) {
  const {data, unit} = picture;
  const grounded = new Set(data.joints.filter(j => j.bodies.includes(0)).map(
      j => j.points[j.rail && j.bodies[1] === 0 ? 1 : 0]));
  const material = new MeshBasicMaterial({map: hatching(), transparent: true, side: DoubleSide});
  picture.pads = new Instances(picture.scene, new PlaneGeometry(0.07 * unit, 0.07 * unit), grounded.size, material);
  [...grounded].forEach((p, k) => picture.moving.push(() => {
    matrix.makeTranslation(picture.placed[p].x, picture.placed[p].y, picture.placed[p].z - 1.1 * round * unit);
    picture.pads.mesh.setMatrixAt(k, matrix);
  }));
  const grid = new GridHelper(1.6, 16, 0x888888, 0x888888);
  grid.rotation.x = Math.PI / 2;
  grid.position.z = (picture.low[2] - picture.middle[2]) / data.size - 0.04;
  grid.material.transparent = true;
  grid.material.opacity = 0.25;
  picture.scene.add(grid);
}

// Arrows: along what is measured, or about the vertex of an angle.
export function addDrivers(picture) {
  const {data, unit} = picture;
  picture.drivers = new Instances(picture.scene, new ConeGeometry(1, 1, 12), 2 * data.drivers.length);
  const d = new Vector3(), tip = new Vector3();
  data.drivers.forEach((driver, k) => {
    const [p, other] = marked(data, driver);
    const place = (which, at_point, direction, sign) => {
      tip.copy(at_point).addScaledVector(direction, sign * 0.045 * unit);
      picture.drivers.along(2 * k + which, tip, way.copy(direction).multiplyScalar(sign), 0.035 * unit, 0.013 * unit);
    };
    picture.moving.push(i => {
      if (p === undefined) return picture.drivers.hide(2 * k), picture.drivers.hide(2 * k + 1);
      d.set(driver.axis === 0 ? 1 : 0, driver.axis === 1 ? 1 : 0, driver.axis === 2 ? 1 : 0);
      const turning = data.points[p].joints.find(j => j.type === 'revolute' || j.type === 'cylindrical');
      if (driver.type === 'angle' && turning?.vectors.length) picture.direction(turning.vectors[0], i, d);
      else if (other !== undefined) d.subVectors(picture.placed[other], picture.placed[p]).normalize();
      place(0, picture.placed[p], d, 1);
      place(1, other !== undefined && driver.type !== 'angle' ? picture.placed[other] : picture.placed[p], d, -1);
    });
  });
}

// What bodies look like: links between their points, and plates where points span a plane.
import {at} from './data.js';

const minus = (a, b) => a.map((x, i) => x - b[i]);
const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0],
];
const length = a => Math.hypot(...a);
const in_space = a => [a[0], a[1], a[2] ?? 0];

// Returns two directions that span the plane of the points; nothing where there is no plane.
function plane(points, size) {
  const ways = points.slice(1).map(p => minus(p, points[0]));
  const u = ways.reduce((a, b) => length(b) > length(a) ? b : a);
  if (length(u) < 1e-9 * size) return null;
  const beside = ways.map(w => minus(w, u.map(x => x * dot(w, u) / dot(u, u))));
  const v = beside.reduce((a, b) => length(b) > length(a) ? b : a);
  if (length(v) < 1e-3 * length(u)) return null;
  const normal = cross(u, v), scale = length(normal);
  if (ways.some(w => Math.abs(dot(w, normal)) / scale > 1e-2 * length(u))) return null;
  return {u: u.map(x => x / length(u)), v: v.map(x => x / length(v))};
}

// Returns the convex hull of points of a plane, as positions in the list, by Andrew's chains.
function hull(flat) {
  const order = flat.map((_, i) => i).sort((i, k) => flat[i][0] - flat[k][0] || flat[i][1] - flat[k][1]);
  const turn = (o, a, b) => (flat[a][0] - flat[o][0]) * (flat[b][1] - flat[o][1]) -
      (flat[a][1] - flat[o][1]) * (flat[b][0] - flat[o][0]);
  const chain = list => {
    const result = [];
    for (const i of list) {
      while (result.length > 1 && turn(result.at(-2), result.at(-1), i) <= 0) result.pop();
      result.push(i);
    }
    return result.slice(0, -1);
  };
  return [...chain(order), ...chain(order.toReversed())];
}

// Returns edges of the shortest tree that holds all points together.
function tree(points, from) {
  const edges = [], joined = new Set(from);
  while (joined.size < points.length) {
    let best = null;
    points.forEach((p, k) => {
      if (joined.has(k)) return;
      for (const i of joined) {
        const way = length(minus(p, points[i]));
        if (!best || way < best.way) best = {way, i, k};
      }
    });
    edges.push([best.i, best.k]);
    joined.add(best.k);
  }
  return edges;
}

// Returns edges and plate of a body, as points of the mechanism.
function shape(data, body) {
  const named = list => list.map(i => body.points[i]);
  const points = body.points.map(p => in_space(at(data, data.points[p], 0)));
  if (points.length < 2) return {edges: [], plate: []};
  const axes = points.length > 2 ? plane(points, data.size) : null;
  if (!axes) {
    const all = points.flatMap((_, i) => points.slice(0, i).map((_, k) => [k, i]));
    const few = points.length === 4 && data.dimension === 3;
    return {edges: (few ? all : tree(points, [0])).map(named), plate: []};
  }
  const outline = hull(points.map(p => [dot(p, axes.u), dot(p, axes.v)]));
  const round = outline.map((i, k) => [i, outline[(k + 1) % outline.length]]);
  return {edges: [...round, ...tree(points, outline)].map(named), plate: named(outline)};
}

// Returns how far points slide along an axis through another one, over the whole motion.
function reach(data, origin, axis, point) {
  let low = 0, high = 0;
  for (let i = 0; i < data.shown; i += Math.max(1, data.shown >> 8)) {
    const way = dot(minus(at(data, data.points[point], i), at(data, data.points[origin], i)),
                    at(data, data.vectors[axis], i));
    low = Math.min(low, way);
    high = Math.max(high, way);
  }
  const margin = 0.06 * data.size;
  return [low - margin, high + margin];
}

// Adds to each body its edges and plate, to each point what joins there and who carries it, and to
// sliding joints their rails. Of measured distances those remain that no link shows.
export function shapes(data) {
  for (const point of data.points) Object.assign(point, {joints: [], bodies: []});
  data.bodies.forEach((body, b) => {
    Object.assign(body, b === 0 ? {edges: [], plate: []} : shape(data, body));
    for (const p of body.points) data.points[p].bodies.push(body);
  });
  data.measures = data.measures.filter(
      ends => !data.bodies.some((body, b) => b > 0 && ends.every(p => body.points.includes(p))));
  for (const joint of data.joints) {
    for (const p of joint.points) data.points[p].joints.push(joint);
    const [first, last] = joint.points;
    if (joint.vectors.length > 0 && joint.points.length === 2 && joint.type !== 'universal')
      joint.rail = {origin: first, axis: joint.vectors[0], slider: last,
                    reach: reach(data, first, joint.vectors[0], last),
                    grounded: joint.bodies[0] === 0 || joint.bodies[1] === 0};
  }
}

// Returns what stands at a point, for people.
export function describe(data, p) {
  const point = data.points[p];
  const lines = [`point ${point.name}`, point.bodies.map(b => b.name).join(', ')];
  for (const {type, name} of point.joints) lines.push(name.startsWith(type) ? name : `${type} ${name}`);
  return lines.join('\n');
}

// Returns where an angle is measured: vertex, radius and the ends [rad]; plane only.
export function arc(data, driver, i) {
  const toward = d => d === null ? [1, 0] : d.vector !== undefined ? at(data, data.vectors[d.vector], i)
      : minus(at(data, data.points[d.to], i), at(data, data.points[d.from], i));
  const of = toward(driver.of), from = toward(driver.from);
  const sign = driver.opposite ? -1 : 1;
  const begin = Math.atan2(sign * from[1], sign * from[0]), end = Math.atan2(of[1], of[0]);
  const turn = 2 * Math.PI;
  const sweep = ((end - begin) % turn + turn) % turn;
  return {begin, sweep: sweep > Math.PI ? sweep - turn : sweep};
}

// Returns the point at which a driver is marked, and the other end of what it measures.
export function marked(data, {point, of}) {
  if (point !== undefined) return [point];
  if (of.from !== undefined) return [of.from, of.to];
  const joint = data.joints.find(j => j.vectors.includes(of.vector));
  return joint ? [joint.points[0]] : [];
}

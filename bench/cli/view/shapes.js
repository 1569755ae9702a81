// The shapes of bodies: links between their points, and plates where all points lie in a plane.
import {at, dot, length, minus} from './data.js';

const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0],
];

// Returns two unit vectors that span the plane of the points. Let the extent be the longest
// distance from the first point. Returns null where all points are within 1e-3 extents of a line,
// or where one is more than 1e-2 extents off the plane.
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

// Returns the convex hull of points of a plane, as indices of the list, by Andrew's monotone
// chains.
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

// Returns the edges by which the shortest tree joins all other points to those of `from`.
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

// Returns the edges and the plate of a body, as indices of the mechanism's points.
export function shape(data, body) {
  const named = list => list.map(i => body.points[i]);
  const points = body.points.map(p => at(data, data.points[p], 0));
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

// The mechanism of the page, from its file (cases/files.md): names become indices in lists.
import {at, dot, minus} from './data.js';

const places = list => new Map(list.map(({name}, k) => [name, k]));

// Returns the names of points or vectors that a body lists: in an array or, where the body has a
// frame of its own, as the keys of their places in it.
const listed = names => Array.isArray(names) ? names : Object.keys(names);

// Returns the structural group of each body, −1 for the ground and what is fixed to it.
function groups_of(data, names) {
  const group = new Map(data.groups.flatMap(({bodies}, g) => bodies.map(body => [body, g])));
  group.set('ground', -1);
  return names.map(name => group.get(name) ?? -1);
}

// Replaces the file in the data by bodies, joints, drivers and measured distances.
export function interpret(data) {
  const file = data.mechanism;
  const point = places(data.points), vector = places(data.vectors);
  const direction = of => Array.isArray(of) ? {from: point.get(of[0]), to: point.get(of[1])}
      : of ? {vector: vector.get(of.replace(/^-/, ''))} : null;
  const bodies = [['ground', file.ground], ...Object.entries(file.bodies)];
  const groups = groups_of(data, bodies.map(([name]) => name));
  data.bodies = bodies.map(([name, {points = [], vectors = []}], b) => ({
    name, group: groups[b],
    points: listed(points).map(p => point.get(p)), vectors: listed(vectors).map(v => vector.get(v)),
  }));
  const body = places(data.bodies);
  data.points.forEach((one, p) => {
    one.bodies = data.bodies.flatMap(({points}, b) => points.includes(p) ? [b] : []);
  });
  data.joints = file.joints.map(({name, type, bodies, points = [], vectors = []}) => ({
    name: name ?? bodies.join('–'), type, bodies: bodies.map(b => body.get(b)),
    points: points.map(p => point.get(p)), vectors: vectors.map(v => vector.get(v)),
  }));
  data.points.forEach((one, p) => { one.joints = data.joints.filter(joint => joint.points.includes(p)); });
  data.drivers = file.drivers.map((name, k) => {
    const c = file.coordinates[name];
    return {
      name, type: 'angle' in c ? 'angle' : 'distance' in c ? 'distance' : 'component',
      of: direction(c.angle ?? c.distance), from: direction(c.from),
      opposite: typeof c.from === 'string' && c.from.startsWith('-'),
      point: point.get(c.component), axis: 'xyz'.indexOf(c.axis), column: data.driven[k],
    };
  });
  data.measures = Object.values(file.coordinates).filter(c => c.distance)
      .map(c => c.distance.map(p => point.get(p)))
      .filter(ends => !data.bodies.some(({points}, b) => b > 0 && ends.every(p => points.includes(p))));
  data.dimension = file.dimension;
  data.mechanism = file.name;
}

// Returns the bodies that carry both ends of a segment whose angle is driven, the ground excepted.
function driven_bodies(data) {
  const ends = data.drivers.filter(d => d.type === 'angle' && d.of.from !== undefined).map(d => [d.of.from, d.of.to]);
  return new Set(data.bodies.map((_, b) => b).filter(
      b => b > 0 && ends.some(pair => pair.every(p => data.bodies[b].points.includes(p)))));
}

// Returns loops of four bodies and four revolute joints in the plane, one of the bodies the ground:
// an input, which is driven or solved before the others, turns a follower through a coupler.
function four_bar_loops(data) {
  if (data.dimension !== 2) return [];
  const hinges = data.bodies.map(() => []);
  for (const {type, bodies: [a, b], points: [p]} of data.joints) {
    if (type !== 'revolute') continue;
    hinges[a].push({body: b, p});
    hinges[b].push({body: a, p});
  }
  const driven = driven_bodies(data);
  const group = b => data.bodies[b].group;
  const is_input = (input, coupler, follower) => driven.has(input) ||
      !driven.has(follower) && group(input) < Math.min(group(coupler), group(follower));
  const loops = [];
  for (const {body: input} of hinges[0])
    for (const {body: coupler, p: b} of hinges[input])
      for (const {body: follower, p: c} of hinges[coupler])
        for (const {body: last, p: d} of hinges[follower])
          if (last === 0 && new Set([0, input, coupler, follower]).size === 4 && is_input(input, coupler, follower))
            loops.push({bodies: [input, coupler, follower], b, c, d});
  return loops;
}

// Adds a column for the transmission angle of each of four_bar_loops(), and of no other loop. It is
// the angle between coupler and follower, from 0 to half a turn; a quarter of a turn transmits
// best.
export function add_transmission(data) {
  const {name: unit, radian} = data.angle_unit;
  data.transmission = four_bar_loops(data).map(({bodies, b, c, d}) => {
    const values = Float64Array.from(data.times, (_, i) => {
      const [from, pin, to] = [b, c, d].map(p => at(data, data.points[p], i));
      const u = minus(from, pin), v = minus(to, pin);
      return Math.atan2(Math.abs(u[0] * v[1] - u[1] * v[0]), dot(u, v)) * radian;
    });
    const name = bodies.map(body => data.bodies[body].name).join(' → ');
    return data.columns.push({name, unit, level: 0, values}) - 1;
  });
}

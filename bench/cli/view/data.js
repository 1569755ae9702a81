// The data of the page: the JSON that page_data.cpp wrote, and columns of numbers as floats in
// base64.
import {add_transmission, interpret} from './mechanism.js';

// Returns what there is to show: the JSON with `values` of each column, the `times` [s] of the
// instants on the page, and `holes`: the instants on the page before which others are missing.
export function read() {
  const data = JSON.parse(document.getElementById('data').textContent);
  const bytes = Uint8Array.from(atob(data.numbers), c => c.charCodeAt(0));
  const numbers = new DataView(bytes.buffer);
  data.columns.forEach((column, c) => {
    column.values = Float64Array.from(
        {length: data.shown}, (_, i) => column.origin + numbers.getFloat32(4 * (c * data.shown + i), true));
  });
  data.times = data.index.map(i => data.time.start + i * data.time.interval);
  data.begin = data.times[0];
  data.seconds = seconds(data.time);
  const gap = 1.5 * data.time.stride;
  data.holes = new Set(data.index.flatMap((i, k) => k > 0 && i - data.index[k - 1] > gap ? [k] : []));
  data.estimate = data.time.solved === 0;
  data.failed = data.flags.filter(f => f.kind === 'failed');
  interpret(data);
  measure(data);
  add_transmission(data);
  for (const column of data.columns) column.heading = `${column.name} [${column.unit}]`;
  const moving = data.groups.filter(group => !group.constant);
  data.groups.forEach(group => {
    group.colour = group.constant ? 'var(--soft)' : `var(--g${moving.indexOf(group) % 8})`;
  });
  data.colour = {
    group: b => data.groups[data.bodies[b].group]?.colour ?? 'var(--soft)',
    body: b => b === 0 ? 'var(--soft)' : `var(--g${(b - 1) % 8})`,
  };
  return data;
}

// Returns a function that writes a time [s]: with seven digits or, where instants of the grid need
// more to be told apart, with as many. Works for a grid of one instant, too.
function seconds({start, interval, instants}) {
  const latest = Math.max(Math.abs(start), Math.abs(start + (instants - 1) * interval));
  const digits = Math.min(17, Math.max(7, Math.ceil(Math.log10(latest / interval)) + 2 || 7));
  return time => `${Number(time.toPrecision(digits))} s`;
}

// Finds the box of all positions, which is the origin where there are none; its diagonal, the size
// of the mechanism; and the greatest speed and acceleration of a point. Zeros of these three count
// as 1.
function measure(data) {
  data.low = [Infinity, Infinity, Infinity];
  data.high = [-Infinity, -Infinity, -Infinity];
  data.longest = {velocity: 0, acceleration: 0};
  for (const point of data.points)
    for (let i = 0; i < data.shown; ++i) {
      at(data, point, i).forEach((x, axis) => {
        data.low[axis] = Math.min(data.low[axis], x);
        data.high[axis] = Math.max(data.high[axis], x);
      });
      for (const kind in data.longest) data.longest[kind] = Math.max(data.longest[kind], length(at(data, point, i, kind)));
    }
  if (data.points.length === 0) data.low = data.high = [0, 0, 0];
  data.size = length(minus(data.high, data.low)) || 1;
  for (const kind in data.longest) data.longest[kind] ||= 1;
}

// Returns the position, velocity or acceleration of a point, or a vector, at an instant: three
// components, of which z is 0 in the plane.
export function at(data, point, i, level = 'position') {
  const fixed = level === 'position' ? point.fixed : point.fixed && [0, 0, 0];
  return [0, 1, 2].map(axis => axis >= data.dimension ? 0
      : fixed ? fixed[axis] : data.columns[point[level] + axis].values[i]);
}

export const plus = (a, factor, b) => a.map((x, axis) => x + factor * b[axis]);
export const minus = (a, b) => plus(a, -1, b);
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const length = a => Math.hypot(...a);
export const scaled = (a, factor) => a.map(x => factor * x);
export const unit = a => scaled(a, 1 / (length(a) || 1));

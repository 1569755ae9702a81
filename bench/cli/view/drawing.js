// The drawing of a mechanism: marks at its points, the same at all instants. Each has a layer, the
// body whose colour it has, the points that it stands at, and its SVG in a view (View in
// picture.js).
import {at, dot, length, minus, plus, scaled, unit} from './data.js';
import {shape} from './shapes.js';

export const layers = {plates: 0, rails: 1, links: 2, drivers: 3, joints: 4, points: 5};
const pieces = 12;  // straight pieces of which an arc is drawn

const line = (view, a, b) => `M${view.px(a)}L${view.px(b)}`;
const glyph = (view, p, svg) => `<g transform="translate(${view.px(view.point(p))}) scale(${view.unit})">${svg}</g>`;
const outlined = 'fill="var(--stage)" stroke="var(--ink)" stroke-width="2"';
const round = radius => `<circle r="${radius}" ${outlined}/>`;
const pivot = '<g stroke="var(--soft)" stroke-width="1.5"><path d="M0 0L-11 17H11Z" fill="var(--stage)"/>' +
    '<path d="M-17 17H17M-13 17l-5 7M-6 17l-5 7M1 17l-5 7M8 17l-5 7M15 17l-5 7"/></g>';
const symbols = {fixed: `<path d="M-5 -5H5V5H-5Z" ${outlined}/>`, spherical: '<circle r="7" fill="var(--ink)"/>'};

// Returns a line from one point to another, of a width [px] in the colour of a body. In space it
// has a margin, which shows what is in front of what.
function link(body, p, q, width) {
  return {layer: layers.links, body, at: [p, q], svg: view => {
    const path = `<path d="${line(view, view.point(p), view.point(q))}"`;
    const margin = view.camera.spatial ? `${path} stroke="var(--stage)" stroke-width="${view.wide(width + 3)}"/>` : '';
    return `${margin}${path} stroke="${view.colour(body)}" stroke-width="${view.wide(width)}"/>`;
  }};
}

// Returns a bar whose middle is a point, along a direction. half: half its length [px]; width [px].
function bar(view, p, along, half, width, colour) {
  const ends = [-half, half].map(px => plus(view.point(p), px * view.length, along));
  return `<path d="${line(view, ...ends)}" stroke="${colour}" stroke-width="${view.wide(width)}" stroke-linecap="butt"/>`;
}

function body_marks(data) {
  return data.bodies.flatMap(({edges, plate}, body) => {
    const marks = edges.map(([p, q]) => link(body, p, q, plate.length > 0 ? 4 : 6));
    if (plate.length > 0)
      marks.push({layer: layers.plates, body, at: plate, svg: view =>
        `<path d="M${plate.map(p => view.px(view.point(p))).join('L')}Z" fill="${view.colour(body)}" fill-opacity=".16"/>`});
    return marks;
  });
}

function joint_marks(data, joint) {
  const grounded = joint.bodies.includes(0), {in_plane} = data.joint_forms[joint.type];
  if (joint.vectors.length > 0 && joint.points.length === 2 && !in_plane) return slider_marks(data, joint, grounded);
  const p = joint.points[in_plane ? 1 : 0];  // the point that moves in the plane, or the first
  if (p === undefined) return [];
  const marks = [];
  if (grounded && !in_plane) marks.push({layer: layers.rails, body: 0, at: [p], svg: view => glyph(view, p, pivot)});
  const half = {revolute: 11, universal: 8}[joint.type];
  const turns = data.dimension === 3 && half;
  marks.push({layer: layers.joints, body: 0, at: [p], svg: view =>
    (turns ? joint.vectors.map(v => bar(view, p, view.vector(v), half, 6, 'var(--ink)')).join('') : '') +
        glyph(view, p, symbols[joint.type] ?? round(turns ? 4 : 6))});
  return marks;
}

// Returns the least and the greatest distance of a point from another one along an axis, over all
// instants; 0 counts among the distances.
function reach(data, origin, axis, slider) {
  const ways = data.times.map((_, i) => dot(
      minus(at(data, data.points[slider], i), at(data, data.points[origin], i)), at(data, data.vectors[axis], i)));
  return ways.reduce(([low, high], way) => [Math.min(low, way), Math.max(high, way)], [0, 0]);
}

// Returns a rail along the axis and a block that slides on it. Where the axis belongs to the first
// body alone, that body has the rail; else the ground has it. A rail of the ground has sleepers.
// Where both bodies move and share the axis, returns a rod in a sleeve instead, which shows bodies
// that have no other point.
function slider_marks(data, joint, grounded) {
  const [origin, last] = joint.points, [axis] = joint.vectors, [first_body, last_body] = joint.bodies;
  const [low, high] = reach(data, origin, axis, last);
  const of_first = data.joint_forms[joint.type].own_vectors === 1;
  if (!grounded && !of_first) {
    const far = 0.55 * (high > -low ? high : low);
    return [link(last_body, origin, last, 4), {layer: layers.links, body: first_body, at: [origin, last], svg: view => {
      const from = view.point(origin), path = line(view, from, plus(from, far, view.vector(axis)));
      return `<path d="${path}" stroke="${view.colour(first_body)}" stroke-width="${view.wide(12)}" stroke-opacity=".55"/>`;
    }}];
  }
  const rail = of_first ? first_body : 0, [still, slider] = rail === first_body ? [origin, last] : [last, origin];
  const margin = 0.06 * data.size;
  const ends = [low - margin, high + margin].map(far => rail === first_body ? far : -far);
  return [{layer: layers.rails, body: rail, at: [still], svg: view => {
    const path = line(view, ...ends.map(far => plus(view.point(still), far, view.vector(axis))));
    const stroke = `<path d="${path}" stroke="${view.colour(rail)}"`;
    return rail === 0 ? `${stroke} stroke-width="1.5"/>${stroke} stroke-width="${view.wide(10)}" stroke-dasharray="1.5 7" stroke-linecap="butt"/>`
        : `${stroke} stroke-width="${view.wide(3)}"/>`;
  }}, {layer: layers.joints, body: 0, at: [slider], svg: view => {
    const along = view.vector(axis);
    return bar(view, slider, along, 13, 16, 'var(--ink)') + bar(view, slider, along, 11, 12, 'var(--stage)') +
        (joint.type === 'revolute_on_slider' ? glyph(view, slider, round(4)) : '');
  }}];
}

// ---- drivers ----

// Returns a unit vector turned towards another by a fraction of the angle between them.
function turned(from, to, fraction) {
  const along = dot(from, to), across = plus(to, -along, from), sine = length(across);
  const side = sine > 1e-9 ? scaled(across, 1 / sine) : [-from[1], from[0], 0];
  const angle = fraction * Math.atan2(sine, along);
  return plus(scaled(from, Math.cos(angle)), Math.sin(angle), side);
}

// Returns the point at which the angle of a direction is drawn; undefined where no joint or body
// that has the direction has a point.
function vertex(data, {from, vector}) {
  if (from !== undefined) return from;
  const has = ({vectors, points}) => vectors.includes(vector) && points.length > 0;
  return (data.joints.find(has) ?? data.bodies.find(has))?.points[0];
}

// Returns an arc from where a driven angle is 0, or an arrow along a driven length; null for an
// angle without a vertex.
function driver_mark(data, {type, of, from, opposite, point, axis}) {
  const mark = (points, path, where) => ({layer: layers.drivers, body: 0, at: points, svg: view =>
    `<path d="${path(view)}" stroke="var(--driver)" stroke-width="${view.wide(2.5)}" marker-${where}="url(#driver)"/>`});
  if (type === 'component') {
    const along = [0, 1, 2].map(k => k === axis ? -1 : 0);
    return mark([point], view => line(view, plus(view.point(point), 34 * view.length, along), view.point(point)), 'end');
  }
  if (type === 'distance' && of.from !== undefined)
    return mark([of.from, of.to], view => {
      const a = view.point(of.from), b = view.point(of.to);
      return `${line(view, a, plus(a, 0.75, minus(b, a)))}L${view.px(b)}`;
    }, 'mid');
  const p = vertex(data, of);
  if (p === undefined) return null;
  const toward = (view, d) => d === null ? [1, 0, 0] : d.vector !== undefined ? view.vector(d.vector)
      : unit(minus(view.point(d.to), view.point(d.from)));
  return mark([p], view => {
    const zero = scaled(toward(view, from), opposite ? -1 : 1), now = toward(view, of);
    const arc = Array.from({length: pieces + 1}, (_, k) => view.px(
        plus(view.point(p), 22 * view.length, turned(zero, now, k / pieces))));
    return `M${view.px(view.point(p))}L${arc.join('L')}`;
  }, 'end');
}

// Returns all marks, layer by layer.
export function draw(data) {
  data.bodies.forEach((body, b) => Object.assign(body, b === 0 ? {edges: [], plate: []} : shape(data, body)));
  return [
    ...body_marks(data),
    ...data.measures.map(([p, q]) => ({layer: layers.rails, body: 0, at: [p, q], svg: view =>
      `<path d="${line(view, view.point(p), view.point(q))}" stroke="var(--soft)" stroke-dasharray="6 4"/>`})),
    ...data.joints.flatMap(joint => joint_marks(data, joint)),
    ...data.drivers.map(driver => driver_mark(data, driver)).filter(Boolean),
    ...data.points.map(({name}, p) => ({layer: layers.points, body: 0, at: [p], svg: view =>
      glyph(view, p, '<circle r="2" fill="var(--ink)"/>').replace('<g', `<g data-point="${p}"`)})),
  ].sort((a, b) => a.layer - b.layer);
}

// Returns the median of the bodies' longest edges at the first instant (Camera.usual_length); the
// size of the mechanism where no body has edges.
export function usual_length(data) {
  const lengths = data.bodies.filter(({edges}) => edges.length > 0).map(({edges}) => Math.max(...edges.map(
      ([p, q]) => length(minus(at(data, data.points[p], 0), at(data, data.points[q], 0)))))).sort((a, b) => a - b);
  return lengths[lengths.length >> 1] ?? data.size;
}

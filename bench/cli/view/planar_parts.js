// Joints, sliders and drivers of a planar picture. Each adds its shapes, and a function that places
// them at an instant to `moving`.
import {at} from './data.js';
import {arc, marked} from './geometry.js';

const names = 'http://www.w3.org/2000/svg';
const joint_size = 6;  // px

export function add(parent, tag, attributes) {
  const element = document.createElementNS(names, tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  parent.append(element);
  return element;
}

// Places a glyph; unit: its size.
export function place(element, [x, y], unit, angle = 0) {
  element.setAttribute('transform', `translate(${x} ${y}) rotate(${angle}) scale(${unit})`);
}

// Returns the style of a line that is as wide at the usual size of joints.
export const width = px => `stroke-width: calc(${px}px * var(--unit))`;

export function addJoint(picture, joint) {
  const grounded = joint.bodies.includes(0);
  if (joint.rail) return addSlider(picture, joint, grounded);
  const [p] = joint.points;
  if (p === undefined) return;
  if (grounded) {
    const pivot = add(picture.layers.rails, 'g', {class: 'ground'});
    add(pivot, 'path', {class: 'pivot', d: 'M0 0L-11 17H11Z'});
    add(pivot, 'path', {class: 'hatch', d: 'M-17 17H17M-13 17l-5 7M-6 17l-5 7M1 17l-5 7M8 17l-5 7M15 17l-5 7'});
    picture.moving.push(i => place(pivot, picture.px(picture.world(p, i)), picture.unit));
  }
  const mark = joint.type === 'fixed'
      ? add(picture.layers.joints, 'rect', {class: 'joint', x: -5, y: -5, width: 10, height: 10})
      : add(picture.layers.joints, 'circle', {class: 'joint', r: joint_size});
  picture.moving.push(i => place(mark, picture.px(picture.world(p, i)), picture.unit));
}

// A rail along the axis and a block that slides on it: hatched on the ground, in the colour of a
// body that carries it; or, where neither body has another point, a rod in a sleeve.
function addSlider(picture, joint, grounded) {
  const {origin, axis, slider, reach} = joint.rail;
  if (!grounded && joint.type === 'prismatic') return addSleeve(picture, joint);
  const sliding = joint.bodies[1] === 0 ? origin : slider, still = sliding === slider ? origin : slider;
  const sign = still === origin ? 1 : -1;
  const carrier = picture.data.bodies[joint.bodies[0]];
  const rail = add(picture.layers.rails, 'path', grounded ? {class: 'rail'}
      : {class: 'link', stroke: picture.data.colour(carrier.group), style: width(3)});
  const block = add(picture.layers.joints, 'rect',
                    {class: 'joint', x: -13, y: -8, width: 26, height: 16, rx: 2});
  const hinge = joint.type === 'revolute_on_slider'
      ? add(picture.layers.joints, 'circle', {class: 'joint', r: 4}) : null;
  picture.moving.push(i => {
    const d = at(picture.data, picture.data.vectors[axis], i), o = picture.px(picture.world(still, i));
    const along = [sign * d[0], -sign * d[1]];
    const ends = reach.map(x => x * picture.scale);
    const shift = grounded ? 9 * picture.unit : 0;  // the rail runs below the block
    const below = along[0] < 0 ? [along[1], -along[0]] : [-along[1], along[0]];
    const point = (x, off) => `${o[0] + x * along[0] + off * below[0]} ${o[1] + x * along[1] + off * below[1]}`;
    let path = `M${point(ends[0], shift)}L${point(ends[1], shift)}`;
    if (grounded)
      for (let x = ends[0]; x < ends[1]; x += Math.max(9, (ends[1] - ends[0]) / 60))
        path += `M${point(x + 5, shift)}L${point(x, shift + 7)}`;
    rail.setAttribute('d', path);
    const angle = Math.atan2(along[1], along[0]) * 180 / Math.PI;
    const here = picture.px(picture.world(sliding, i));
    place(block, here, picture.unit, angle);
    if (hinge) place(hinge, here, picture.unit);
  });
}

function addSleeve(picture, joint) {
  const {origin, slider, reach} = joint.rail;
  const [outer, inner] = joint.bodies.map(b => picture.data.colour(picture.data.bodies[b].group));
  const rod = add(picture.layers.bodies, 'line', {class: 'link', stroke: inner, style: width(4)});
  const sleeve = add(picture.layers.bodies, 'line', {class: 'sleeve', stroke: outer});
  const most = Math.max(...reach.map(Math.abs)) - 0.06 * picture.data.size;
  picture.moving.push(i => {
    const o = picture.world(origin, i), s = picture.world(slider, i);
    const long = Math.hypot(s[0] - o[0], s[1] - o[1]) || 1;
    picture.line(rod, o, s);
    picture.line(sleeve, o, o.map((x, k) => x + (s[k] - x) * 0.55 * most / long));
  });
}

// An arc or an arrow, from where the driver's coordinate is zero.
export function addDriver(picture, driver) {
  const [p, other] = marked(picture.data, driver);
  if (p === undefined) return;
  const line = add(picture.layers.drivers, 'path', {class: 'driver'});
  const head = add(picture.layers.drivers, 'path', {class: 'driver head', d: 'M2 0L-9 5V-5Z'});
  const degrees = 180 / Math.PI;
  picture.moving.push(i => {
    const [x, y] = picture.px(picture.world(p, i));
    if (driver.type === 'angle') {
      const {begin, sweep} = arc(picture.data, driver, i), r = 22 * picture.unit;
      const on = a => `${x + r * Math.cos(a)} ${y - r * Math.sin(a)}`;
      line.setAttribute('d', `M${x} ${y}L${on(begin)}A${r} ${r} 0 0 ${sweep > 0 ? 0 : 1} ${on(begin + sweep)}`);
      const end = begin + sweep;
      place(head, [x + r * Math.cos(end), y - r * Math.sin(end)], picture.unit, -end * degrees - Math.sign(sweep) * 90);
      return;
    }
    let from = [x, y], to = [x, y];
    if (other !== undefined) to = picture.px(picture.world(other, i));
    else from = driver.axis === 0 ? [x - 34 * picture.unit, y] : [x, y + 34 * picture.unit];
    line.setAttribute('d', `M${from.join(' ')}L${to.join(' ')}`);
    const on = axis => from[axis] + (other === undefined ? 1 : 0.75) * (to[axis] - from[axis]);
    place(head, [on(0), on(1)], picture.unit, Math.atan2(to[1] - from[1], to[0] - from[0]) * degrees);
  });
}

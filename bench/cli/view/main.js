// The page: data, picture, player and plots, and what is chosen in them.
//
// For tests and the curious, window.desmo reads what is shown:
//   desmo.instants     number of instants on the page; k counts them from 0
//   desmo.time(k)      time of an instant [s]
//   desmo.index(k)     index of an instant in the scene's grid
//   desmo.size         diagonal of the box of all positions
//   desmo.show(k)      shows an instant
//   desmo.positions()  position of each point by name, as the picture shows it now
//   desmo.places()     place of each point by name, in pixels of the picture
//   desmo.values(k)    value of each plotted line by name at an instant
import {at, length, minus, read} from './data.js';
import {Picture} from './picture.js';
import {Player} from './player.js';
import {choice, Plots} from './plots.js';
import {connectSaving} from './save.js';

const get = id => document.getElementById(id);
const near = 16;  // distance of the pointer from a point [px] below which it points at it
const few = 20;  // number of points (≤) whose names are shown to begin with
const most_traced = 8;  // number of points whose paths are shown to begin with (≤)

// ---- hints ----

function hint(text, event) {
  const box = get('hint');
  box.hidden = !text;
  if (!text) return;
  box.textContent = text;
  const room = document.documentElement.clientWidth - box.offsetWidth - 8;
  box.style.left = `${window.scrollX + Math.max(8, Math.min(event.clientX + 14, room))}px`;
  box.style.top = `${window.scrollY + event.clientY + 14}px`;
}

// Returns a point's name, bodies and joints, for people.
function describe(data, p) {
  const {name, bodies, joints} = data.points[p];
  return [
    `point ${name}`, bodies.map(b => data.bodies[b].name).join(', '),
    ...joints.map(({type, name}) => name.startsWith(type) ? name : `${type} ${name}`),
  ].join('\n');
}

// Returns a description of what is under the pointer: the nearest point, else a body; '' for none.
function under(data, picture, event) {
  const box = get('stage').getBoundingClientRect();
  let best = {way: near};
  data.points.forEach((_, p) => {
    const [x, y] = picture.screen(p);
    const way = Math.hypot(x - event.clientX + box.left, y - event.clientY + box.top);
    if (way < best.way) best = {way, p};
  });
  if (best.p !== undefined) return describe(data, best.p);
  const body = data.bodies[document.elementFromPoint(event.clientX, event.clientY)?.closest('[data-body]')?.dataset.body];
  if (!body) return '';
  const group = data.groups[body.group];
  return `body ${body.name}${group ? `\ngroup ${group.name}` : ''}`;
}

function connectHints(data, picture) {
  const stage = get('stage');
  stage.addEventListener('pointermove', event => hint(event.buttons ? '' : under(data, picture, event), event));
  stage.addEventListener('pointerleave', () => hint(''));
  stage.addEventListener('click', event => hint(under(data, picture, event), event));
}

// ---- choices ----

function connectTraces(data, picture) {
  const moving = data.points.map((_, p) => p).filter(p => !data.points[p].fixed);
  const asked = new Set(data.requested
      ? data.plotted.map(c => data.columns[c].name.replace(/\.[xyz]$/, '')) : []);
  let traced = moving.filter(p => asked.has(data.points[p].name)).slice(0, most_traced);
  if (traced.length === 0) traced = [farthest(data, moving)];
  for (const p of moving) {
    const owner = data.points[p].bodies.find(b => data.bodies[b].group >= 0) ?? 0;
    const show = shown => picture.trace(p, owner, shown);
    get('traces').append(choice(data.points[p].name, traced.includes(p), show));
    if (traced.includes(p)) show(true);
  }
}

// Returns the moving point with the longest path, among those of the last group where it has some;
// undefined where nothing moves.
function farthest(data, moving) {
  const step = Math.max(1, data.shown >> 6);
  const way = p => {
    let sum = 0;
    for (let i = step; i < data.shown; i += step)
      sum += length(minus(at(data, data.points[p], i), at(data, data.points[p], i - step)));
    return sum;
  };
  const last = data.groups.length - 1;
  const late = moving.filter(p => data.points[p].bodies.some(b => data.bodies[b].group === last));
  const ways = (late.length > 0 ? late : moving).map(p => [way(p), p]);
  return ways.sort((a, b) => b[0] - a[0])[0]?.[1];
}

function connectOptions(data, picture) {
  get('names').checked = data.points.length <= few;
  for (const [id, what] of [['names', 'names'], ['velocities', 'velocity'], ['accelerations', 'acceleration']]) {
    const choose = () => picture.choose(what, get(id).checked);
    get(id).addEventListener('change', choose);
    choose();
  }
  get('colours').addEventListener('change', () => {
    picture.colourBy(get('colours').value);
    writeLegend(data);
  });
  get('closer').addEventListener('click', () => picture.camera.zoom(1.25));
  get('farther').addEventListener('click', () => picture.camera.zoom(0.8));
  get('fit').addEventListener('click', () => picture.camera.fit());
}

// ---- words ----

function writeLegend(data) {
  const item = (colour, name, words = '') => {
    const item = document.createElement('li'), mark = document.createElement('span'), small = document.createElement('small');
    mark.className = 'mark';
    mark.style.background = colour;
    small.textContent = words;
    item.append(mark, name, small);
    return item;
  };
  const {value} = get('colours');
  get('legend_title').textContent = value === 'body' ? 'Bodies' : 'Structural groups, in the order of solution';
  get('legend').replaceChildren(...value === 'body'
      ? data.bodies.slice(1).map(({name}, b) => item(data.colour.body(b + 1), name))
      : data.groups.filter(group => !group.constant).map(({name, bodies, colour}) => {
        const some = bodies.slice(0, 6).join(', ');
        return item(colour, name, ` ${some}${bodies.length > 6 ? `, … (${bodies.length} bodies)` : ''}`);
      }));
}

function when(data, flag) {
  const [from, to] = [flag.from, flag.to].map(data.seconds);
  return from === to ? `t = ${from}` : `t = ${from} … ${to}`;
}

// Lists what is flagged, and when. The notice at that time says why (watch()).
function writeFlags(data, player) {
  get('flagged').hidden = data.flags.length === 0;
  for (const flag of data.flags) {
    const item = document.createElement('li'), button = document.createElement('button');
    button.type = 'button';
    button.textContent = `${flag.kind}, ${when(data, flag)}`;
    button.addEventListener('click', () => {
      player.toggle(false);
      player.go(flag.kind === 'failed' ? flag.from : (flag.from + flag.to) / 2);
    });
    item.append(button);
    get('flags').append(item);
  }
}

function writeWords(data) {
  const {time} = data;
  document.title = `${data.mechanism} in motion`;
  get('title').textContent = data.title ? `${data.mechanism}: ${data.title}` : data.mechanism;
  const drivers = data.drivers.map(({name}) => name);
  get('subtitle').textContent = [
    data.scene, `${data.coordinates} coordinates`,
    drivers.length === 0 ? '' : drivers.length === 1 ? `driver ${drivers[0]}`
        : `drivers ${drivers.slice(0, 6).join(', ')}${drivers.length > 6 ? ', …' : ''}`,
    `${time.solved} of ${time.instants} instants solved`,
    ...(data.shown < time.solved ? [`1 in ${time.stride} of them is on this page`] : []),
  ].filter(Boolean).join(' · ');
  get('about').textContent = `Solved by ${data.formulation}; ${data.accuracy}. The picture shows solved positions only; all ` +
      'numbers have seven digits. Radii are proven, all rounding included.';
  get('turning').textContent = data.dimension === 2 ? 'the picture moves and zooms'
      : 'the picture turns and zooms, and moves with shift; the arrow keys turn it once it has the focus';
}

// Says what is flagged at the time of the slider, and marks in the picture what does not close.
function watch(data, picture, player) {
  const notice = get('notice'), half = data.time.interval * data.time.stride / 2;
  let shown;
  player.onShow((instant, time) => {
    const is_at = f => time >= f.from - half && time <= f.to + half;
    const stuck = data.failed.find(f => time >= f.from && time <= f.to && data.times[instant] <= f.from + data.time.interval / 2);
    const flags = stuck ? [stuck] : data.flags.filter(f => f.kind !== 'failed' && is_at(f));
    picture.mark(stuck ? [...new Set(stuck.open.flatMap(name => points_of(data, name)))] : [], !!stuck);
    const said = flags.map(f => data.flags.indexOf(f)).join();
    if (said === shown) return;
    shown = said;
    notice.hidden = said === '';
    const before = !stuck ? '' : data.estimate ? 'Nothing could be assembled; the picture shows the initial estimate. '
        : `The picture shows the last position reached, at t = ${data.seconds(data.times[instant])}. `;
    notice.textContent = before + [...new Set(flags.map(f => f.text))].join('; ');
  });
}

// Returns the point of a name, or the points of a joint that has the vector of that name; none for
// any other name.
function points_of(data, name) {
  const p = data.points.findIndex(point => point.name === name);
  if (p >= 0) return [p];
  const joint = data.joints.find(j => j.vectors.some(v => data.vectors[v].name === name));
  return joint ? joint.points : [];
}

async function start() {
  const data = read();
  const picture = new Picture(get('stage'), data), player = new Player(data);
  data.end = player.end;
  watch(data, picture, player);
  player.onShow(instant => picture.show(instant));
  writeWords(data);
  writeLegend(data);
  writeFlags(data, player);
  connectHints(data, picture);
  connectTraces(data, picture);
  connectOptions(data, picture);
  connectSaving(data, picture);
  const plots = new Plots(data, player, hint);
  if (data.failed.length > 0) player.go(data.failed[0].from);
  else player.draw();
  await plots.draw();
  window.desmo = {
    instants: data.shown,
    size: data.size,
    time: k => data.times[k],
    index: k => data.index[k],
    show: k => player.show(k),
    positions: () => picture.positions(),
    places: () => Object.fromEntries(data.points.map(({name}, p) => [name, picture.screen(p)])),
    values: k => plots.values(k),
  };
  document.documentElement.dataset.state = 'ready';
}

start();

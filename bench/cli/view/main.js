// The page: data, picture, player and plots, and what is chosen in them.
//
// For tests and the curious, window.desmo reads what is shown:
//   desmo.ready        a promise of the page, once it is drawn
//   desmo.instants     how many there are; desmo.time(k) and desmo.index(k) of each
//   desmo.show(k)      goes to one
//   desmo.positions()  of each point, as the picture has it now
//   desmo.places()     of each point, in pixels of the picture
//   desmo.values(k)    of each line, as the plots have it
//   desmo.script()     of the last frames drawn: their number, and ms of script, median and longest
import {at, read} from './data.js';
import {describe} from './geometry.js';
import {Player} from './player.js';
import {Plots} from './plots.js';

const get = id => document.getElementById(id);
const near = 16;  // px

function colours(data) {
  const moving = data.groups.map((_, g) => g).filter(g => !data.groups[g].constant);
  data.colour = g => moving.includes(g) ? `var(--g${moving.indexOf(g) % 8})` : 'var(--soft)';
}

function prepare(data) {
  colours(data);
  data.begin = data.times[0];
  const gap = 1.5 * data.time.stride;
  data.holes = new Set();
  data.index.forEach((i, k) => k > 0 && i - data.index[k - 1] > gap && data.holes.add(k));
  data.longest = kind => data.largest[kind];
  data.estimate = data.time.solved === 0;
  data.failed = data.flags.filter(f => f.kind === 'failed');
  data.point_named = name => data.points.findIndex(p => p.name === name);
}

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

function toSegment([x, y], [ax, ay], [bx, by]) {
  const dx = bx - ax, dy = by - ay;
  const along = Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1)));
  return Math.hypot(x - ax - along * dx, y - ay - along * dy);
}

// Returns what is under the pointer: the nearest point, or else a body.
function under(data, picture, pointer) {
  let best = {way: near};
  data.points.forEach((_, p) => {
    const [x, y] = picture.screen(p);
    const way = Math.hypot(x - pointer[0], y - pointer[1]);
    if (way < best.way) best = {way, p};
  });
  if (best.p !== undefined) return {point: best.p, text: describe(data, best.p)};
  for (const body of data.bodies)
    for (const [a, b] of body.edges) {
      const way = toSegment(pointer, picture.screen(a), picture.screen(b));
      if (way < best.way) best = {way, body};
    }
  if (!best.body) return null;
  const group = data.groups[best.body.group];
  return {text: `body ${best.body.name}${group ? `\ngroup ${group.name}` : ''}`};
}

function connectHints(data, picture) {
  const stage = get('stage');
  const find = event => {
    const box = stage.getBoundingClientRect();
    return under(data, picture, [event.clientX - box.left, event.clientY - box.top]);
  };
  stage.addEventListener('pointermove', event => hint(event.buttons ? '' : find(event)?.text, event));
  stage.addEventListener('pointerleave', () => hint(''));
  stage.addEventListener('click', event => hint(find(event)?.text, event));
}

// ---- choices ----

function connectTraces(data, picture) {
  const moving = data.points.map((_, p) => p).filter(p => !data.points[p].fixed);
  const asked = new Set(data.requested
      ? data.plotted.map(c => data.columns[c].name.replace(/\.[xyz]$/, '')) : []);
  let traced = moving.filter(p => asked.has(data.points[p].name)).slice(0, 8);
  if (traced.length === 0) traced = [farthest(data, moving)].filter(p => p !== undefined);
  for (const p of moving) {
    const label = document.createElement('label'), box = document.createElement('input');
    const owner = data.points[p].bodies.find(b => b.group >= 0);
    const show = () => picture.trace(p, box.checked ? data.colour(owner?.group ?? -1) : null);
    Object.assign(box, {type: 'checkbox', checked: traced.includes(p)});
    box.addEventListener('change', show);
    label.append(box, ` ${data.points[p].name}`);
    get('traces').append(label);
    if (box.checked) show();
  }
}

// The moving point that only bodies without the ground carry and that goes farthest in a step.
function farthest(data, moving) {
  const step = Math.max(1, data.shown >> 6);
  const way = p => {
    let sum = 0;
    for (let i = step; i < data.shown; i += step) {
      const a = at(data, data.points[p], i), b = at(data, data.points[p], i - step);
      sum += Math.hypot(...a.map((x, k) => x - b[k]));
    }
    return sum;
  };
  const last = data.groups.length - 1;
  const late = moving.filter(p => data.points[p].bodies.some(b => b.group === last));
  const ways = (late.length > 0 ? late : moving).map(p => [way(p), p]);
  return ways.sort((a, b) => b[0] - a[0])[0]?.[1];
}

function connectOptions(picture) {
  get('velocities').addEventListener('change', e => picture.showArrows('velocity', e.target.checked));
  get('accelerations').addEventListener('change', e => picture.showArrows('acceleration', e.target.checked));
  get('closer').addEventListener('click', () => picture.zoom(1.25));
  get('farther').addEventListener('click', () => picture.zoom(0.8));
  get('fit').addEventListener('click', () => picture.fit());
}

// ---- words ----

function writeLegend(data) {
  data.groups.forEach((group, g) => {
    if (group.constant) return;
    const item = document.createElement('li'), mark = document.createElement('span');
    mark.className = 'mark';
    mark.style.background = data.colour(g);
    const bodies = document.createElement('small');
    const some = group.bodies.slice(0, 6).join(', ');
    bodies.textContent = ` ${some}${group.bodies.length > 6 ? `, … (${group.bodies.length} bodies)` : ''}`;
    item.append(mark, group.name, bodies);
    get('legend').append(item);
  });
}

const number = x => Number(x.toPrecision(7));

function writeFlags(data, player) {
  get('flagged').hidden = data.flags.length === 0;
  for (const flag of data.flags) {
    const item = document.createElement('li'), button = document.createElement('button');
    button.type = 'button';
    const when = number(flag.from) === number(flag.to) ? `t = ${number(flag.from)} s`
        : `t = ${number(flag.from)} … ${number(flag.to)} s`;
    button.textContent = `${flag.kind}, ${when}: ${flag.text}`;
    button.addEventListener('click', () => {
      player.toggle(false);
      player.go(flag.kind === 'failed' ? flag.from : (flag.from + flag.to) / 2);
    });
    item.append(button);
    get('flags').append(item);
  }
}

function writeWords(data, turning) {
  const {time} = data;
  document.title = `${data.mechanism} in motion`;
  get('title').textContent = data.title ? `${data.mechanism}: ${data.title}` : data.mechanism;
  get('subtitle').textContent = [
    data.scene, `${data.coordinates} coordinates`, data.drivers.length === 1 ? `driver ${data.drivers[0].name}`
        : `drivers ${data.drivers.slice(0, 6).map(d => d.name).join(', ')}${data.drivers.length > 6 ? ', …' : ''}`,
    `${time.solved} of ${time.instants} instants solved`,
    ...(data.shown < time.solved ? [`1 in ${time.stride} of them is on this page`] : []),
  ].filter(Boolean).join(' · ');
  get('turning').textContent = turning;
}

function writeAbout(data, player) {
  const {frames, median, longest} = player.script;
  const script = frames > 30
      ? ` Script a frame: ${median.toFixed(1)} ms in the median of the last ${frames}, at most ${longest.toFixed(1)} ms.` : '';
  get('about').textContent = `Solved by ${data.formulation}; ${data.accuracy}. The picture shows solved positions only, ` +
      `to 1e-5 of the mechanism's size; plots have seven digits. Condition and bounds are estimates; between assessed ` +
      `instants they are expectations with a margin.${script}`;
}

// Says what is wrong at a time, and marks in the picture what does not close.
function watch(data, picture, player) {
  const notice = get('notice');
  let shown;
  player.onShow((instant, time) => {
    const stuck = data.failed.find(f => time >= f.from && time <= f.to && data.times[instant] <= f.from + data.time.interval / 2);
    const points = stuck ? [...new Set(stuck.open.flatMap(name => points_of(data, name)))] : [];
    if (stuck || shown) picture.mark(points, !!stuck);
    if (stuck === shown) return;
    shown = stuck;
    notice.hidden = !stuck;
    notice.textContent = stuck ? data.estimate
        ? `Nothing could be assembled; the picture shows the initial estimate. ${stuck.text}`
        : `The picture shows the last position reached, at t = ${number(data.times[instant])} s. Does not close: ${stuck.text}` : '';
  });
}

// The points that a point, a vector or a coordinate of that name concerns.
function points_of(data, name) {
  const p = data.point_named(name);
  if (p >= 0) return [p];
  const joint = data.joints.find(j => j.vectors.some(v => data.vectors[v].name === name));
  return joint ? joint.points : [];
}

// Makes the page. make: of the picture in its place, from the data.
export function start(make, turning) {
  const ready = read().then(async data => {
    prepare(data);
    const picture = make(get('stage'), data);
    const player = new Player(data);
    data.end = player.end;
    player.onShow(instant => picture.show(instant));
    watch(data, picture, player);
    writeWords(data, turning);
    writeLegend(data);
    writeFlags(data, player);
    connectHints(data, picture);
    connectTraces(data, picture);
    connectOptions(picture);
    const plots = new Plots(data, player, hint);
    picture.onRedraw = () => player.draw();
    if (data.failed.length > 0) player.go(data.failed[0].from);
    else player.draw();
    await plots.draw();
    writeAbout(data, player);
    setInterval(() => player.playing && writeAbout(data, player), 1000);
    Object.assign(window.desmo, {
      instants: data.shown,
      time: k => data.times[k],
      index: k => data.index[k],
      show: k => player.show(k),
      positions: () => Object.fromEntries(data.points.map((point, p) => [point.name, picture.position(p)])),
      places: () => Object.fromEntries(data.points.map((point, p) => [point.name, picture.screen(p)])),
      values: k => plots.values(k),
      script: () => player.script,
    });
    document.documentElement.dataset.state = 'ready';
  });
  window.desmo = {ready};
}

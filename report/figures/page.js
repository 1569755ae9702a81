// In the reader's browser: the figures that stand on the page as drawings begin to answer. Hovering
// shows the values as the tables print them; the legend, and the boxes below it for those who do
// not point, choose what is shown. Where this does not run, the drawings stay.
'use strict';

const narrow = 560;  // px; below, panels stand under each other
const letter = 6.5;  // px; of labels

// What the hover shows: the titles and texts of a tooltip of the specification.
const hint = document.createElement('div');
hint.className = 'hint';
hint.setAttribute('role', 'status');
hint.hidden = true;

function showHint(handler, event, item, value) {
  hint.hidden = value == null;
  if (hint.hidden) return;
  const list = document.createElement('dl');
  for (const [title, text] of Object.entries(value)) {
    list.append(document.createElement('dt'), document.createElement('dd'));
    list.children[list.children.length - 2].textContent = title;
    list.lastElementChild.textContent = text;
  }
  hint.replaceChildren(list);
  const point = event.changedTouches?.[0] ?? event;
  const room = document.documentElement.clientWidth - hint.offsetWidth - 8;
  hint.style.left = `${window.scrollX + Math.max(8, Math.min(point.clientX + 14, room))}px`;
  hint.style.top = `${window.scrollY + point.clientY + 14}px`;
}

// What is fitted to the reader's window; the specification is the static drawing's.
function fitted(spec, width) {
  const names = spec.signals.find(signal => signal.name === 'shown').value;
  const line = letter * Math.max(...names.map(name => name.length)) + 40;  // px, of the legend
  for (const legend of spec.legends ?? []) {
    legend.encode ??= {};
    for (const part of ['symbols', 'labels']) {
      const encode = legend.encode[part] ??= {};
      encode.interactive = true;
      (encode.update ??= {}).cursor = {value: 'pointer'};
    }
    if (width < narrow || line > width / 4)
      Object.assign(legend, {orient: 'bottom', columns: Math.max(1, Math.floor(width / line))});
  }
  if (width >= narrow) return spec;
  if (spec.layout?.columns > 1) spec.layout.columns = 1;
  for (const axis of [spec, ...spec.marks].flatMap(part => part.axes ?? []))
    if (axis.orient === 'left' && axis.labelLimit) axis.labelLimit = 0.4 * width;
  return spec;
}

// Makes the plots as wide as the column leaves them: what stands around them keeps its size.
async function widen(view, spec, container, width) {
  const name = spec.signals.some(signal => signal.name === 'child_width') ? 'child_width' : 'width';
  for (let pass = 0; pass < 3; ++pass) {
    const left = width - container.querySelector('svg').width.baseVal.value;
    const columns = spec.layout?.columns ?? 1;
    if (Math.abs(left) < columns) return;
    view.signal(name, Math.max(60, view.signal(name) + Math.floor(left / columns)));
    await view.resize().runAsync();
  }
}

function box(name, changed) {
  const label = document.createElement('label');
  const input = document.createElement('input');
  input.type = 'checkbox';
  input.checked = true;
  input.addEventListener('change', changed);
  label.append(input, name);
  return label;
}

// One box for each line of the legend, and clicks on the legend: both set the parameter `shown`.
function addToggles(figure, drawing, view) {
  const names = view.signal('shown');
  const toggles = document.createElement('fieldset');
  toggles.className = 'toggles';
  toggles.append(document.createElement('legend'));
  toggles.firstChild.textContent = 'Show';
  const boxes = names.map(name => box(name, () => {
    view.signal('shown', names.filter((_, i) => boxes[i].firstChild.checked)).runAsync();
  }));
  toggles.append(...boxes);
  drawing.after(toggles);
  view.addEventListener('click', (event, item) => {
    if (!item?.mark?.role?.startsWith('legend')) return;
    boxes[names.indexOf(item.datum?.value)]?.firstChild.click();
  });
}

async function bring(figure) {
  const drawing = figure.querySelector('.drawing');
  const data = figure.querySelector('script[type="application/json"]');
  if (!drawing || !data) return;
  const width = drawing.clientWidth;
  const container = document.createElement('div');
  const spec = fitted(JSON.parse(data.textContent), width);
  const view = new vega.View(vega.parse(spec), {
    renderer: 'svg', container, hover: true, tooltip: showHint, logLevel: vega.Error,
  });
  await view.runAsync();
  await widen(view, spec, container, width);
  drawing.replaceChildren(container);
  addToggles(figure, drawing, view);
  figure.dataset.state = 'live';
}

// A figure in a closed section has no width: it begins to answer when the section is opened.
function bringWhenSeen(figure) {
  const closed = figure.parentElement.closest('details:not([open])');
  if (closed) closed.addEventListener('toggle', () => bringWhenSeen(figure), {once: true});
  else bring(figure);
}

// On paper everything is open.
let closedBefore = [];
window.addEventListener('beforeprint', () => {
  closedBefore = [...document.querySelectorAll('details:not([open])')];
  for (const details of closedBefore) details.open = true;
});
window.addEventListener('afterprint', () => {
  for (const details of closedBefore) details.open = false;
});

document.body.append(hint);
document.querySelectorAll('figure').forEach(bringWhenSeen);

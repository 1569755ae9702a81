// Runs in the browser and replaces the drawings on the page by interactive figures. Hovering shows
// the values as the tables print them. Clicks on the legend, and check boxes below the figure,
// choose what is shown. Where this program does not run, the drawings stay.
'use strict';

const narrow = 560;  // width of a figure below which panels stand under each other [px]
const letter = 6.5;  // mean width of a character of a label [px]

// Element that shows the titles and texts of a tooltip while a mark is hovered.
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

// Returns the specification of the drawing, changed to fit a figure of that width [px].
function fitted(spec, width) {
  const names = spec.signals.find(signal => signal.name === 'shown').value;
  // Width of a line of the legend [px].
  const line = letter * Math.max(...names.map(name => name.length)) + 40;
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

// Widens or narrows the plots, in up to three passes, so that the drawing has that width [px]. Axes
// and legends keep theirs.
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

// Adds a check box for each line of the legend, and listens to clicks on the legend. Both set the
// signal `shown`.
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

// Makes a figure interactive. In a closed section it has no width, and waits until that is opened.
function bringWhenSeen(figure) {
  const closed = figure.parentElement.closest('details:not([open])');
  if (closed) closed.addEventListener('toggle', () => bringWhenSeen(figure), {once: true});
  else bring(figure);
}

// Opens all sections for printing; afterwards closes those that were closed.
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

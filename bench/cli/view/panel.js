// A plot over time, by Vega: lines, flagged intervals shaded, and a mark at the instant shown.
import * as encode from 'vega-encode';
import {transforms} from 'vega-dataflow';
import {parse} from 'vega-parser';
import * as axes from 'vega-view-transforms';
import * as basic from 'vega-transforms';
import {Error as errors_only} from 'vega-util';
import {View} from 'vega-view';

Object.assign(transforms, basic, axes, encode);

const palette = Array.from({length: 8}, (_, j) => `var(--g${j})`);
const shades = {
  unproven: ['#e0a800', 0.28], misfit: ['#b5651d', 0.28], failed: ['#c0392b', 0.22], crossing: ['#7b52ab', 0.4], branch: ['#0a7f8c', 0.4],
};
const height = 120;
const soft = 'rgba(128,128,128,0.25)';

// Returns the rows of a table: for each instant, x and the finite values of all columns. Before an
// instant of data.holes it has a row of x alone, at which lines are interrupted.
function rows(data, columns, x) {
  const result = [];
  for (let k = 0; k < data.shown; ++k) {
    if (data.holes.has(k)) result.push({x: x[k]});
    const row = {x: x[k], k};
    columns.forEach((c, j) => {
      const value = data.columns[c].values[k];
      if (Number.isFinite(value)) row[`y${j}`] = value;
    });
    result.push(row);
  }
  return result;
}

function axis(orient, scale, title, log) {
  return {
    orient, scale, title, grid: true, gridColor: soft, domainColor: 'currentColor', tickColor: soft,
    labelColor: 'currentColor', titleColor: 'currentColor', titleFontWeight: 'normal', labelFontSize: 11,
    titleFontSize: 12, tickCount: orient === 'bottom' ? 6 : 4, labelOverlap: true,
    ...(log ? {format: '~g'} : {}), ...(orient === 'left' ? {minExtent: 44, titlePadding: 4} : {}),
  };
}

// Returns Vega's specification of lines over x; flagged intervals are shaded where x is the time.
function specification(data, columns, {x, x_title, y_title, log, over_time, width, zero}) {
  const table = rows(data, columns, x);
  const values = columns.map((_, j) => ({data: 'table', field: `y${j}`}));
  const lowest = log && Math.min(...columns.map(c => data.columns[c].values.reduce(
      (a, b) => b > 0 && b < a ? b : a, Infinity)));
  const line = j => ({
    type: 'line', from: {data: 'table'}, interactive: false,
    encode: {update: {
      x: {scale: 'x', field: 'x'}, y: {scale: 'y', field: `y${j}`},
      defined: {signal: log ? `datum.y${j} > 0` : `isValid(datum.y${j})`},
      stroke: {value: palette[j % palette.length]}, strokeWidth: {value: 1.6},
      strokeDash: {value: j < palette.length ? [] : [5, 3]},
    }},
  });
  const shade = {
    type: 'rect', from: {data: 'flags'},
    encode: {update: {
      x: {signal: 'scale("x", datum.from) - (datum.narrow ? 2 : 0)'},
      x2: {signal: 'max(scale("x", datum.to), scale("x", datum.from) + 2)'},
      y: {value: 0}, y2: {signal: 'height'},
      fill: {field: 'fill'}, fillOpacity: {field: 'opacity'}, tooltip: {field: 'text'},
    }},
  };
  const x_scale = over_time
      ? {name: 'x', type: 'linear', domain: [data.begin, data.end], range: 'width', nice: false, zero: false}
      : {name: 'x', type: 'linear', domain: {data: 'table', field: 'x'}, range: 'width', nice: false, zero: false};
  const narrow = (data.end - data.begin) * 4 / width;
  return {
    width, height, padding: {left: 2, right: 8, top: 4, bottom: 2}, autosize: {type: 'fit', contains: 'padding'},
    background: 'transparent',
    data: [
      {name: 'table', values: table},
      {name: 'flags', values: data.flags.map(f => ({
        ...f, text: f.kind, fill: shades[f.kind][0], opacity: shades[f.kind][1],
        narrow: f.to - f.from < narrow,
      }))},
    ],
    scales: [x_scale, {
      name: 'y', type: log ? 'log' : 'linear', range: 'height', nice: true, zero: !!zero,
      ...(lowest === Infinity ? {domain: [1e-16, 1]}  // no value can be drawn
          : {domain: {fields: values}, ...(log ? {domainMin: lowest} : {})}),
    }],
    axes: [axis('bottom', 'x', x_title), axis('left', 'y', y_title, log)],
    marks: [...(over_time ? [shade] : []), {type: 'group', clip: true, encode: {update: {
      width: {signal: 'width'}, height: {signal: 'height'}}}, marks: columns.map((_, j) => line(j)), interactive: false}],
  };
}

// A plot: a figure with its lines' names, and a mark at the instant of the picture.
export class Panel {
  constructor(data, columns, options, player, hint) {
    Object.assign(this, {data, columns, options, player});
    this.figure = document.createElement('figure');
    const caption = document.createElement('figcaption');
    caption.append(options.title, ...(options.controls ?? []));
    columns.forEach((c, j) => {
      const key = document.createElement('span'), mark = document.createElement('i');
      key.className = 'key';
      mark.style.borderColor = palette[j % palette.length];
      key.append(mark, data.columns[c].name);
      caption.append(key);
    });
    this.drawing = document.createElement('div');
    this.drawing.className = 'drawing';
    this.drawing.setAttribute('role', 'img');
    this.drawing.setAttribute('aria-label', `${options.title}: ${columns.map(c => data.columns[c].name).join(', ')}`);
    this.cursor = document.createElement('div');
    this.cursor.className = options.over_time ? 'cursor' : 'spot';
    this.figure.append(caption, this.drawing);
    this.hint = hint;
  }

  async draw() {
    const width = Math.max(160, this.drawing.clientWidth);
    const holder = document.createElement('div');
    this.view?.finalize();
    this.view = new View(parse(specification(this.data, this.columns, {...this.options, width})), {
      renderer: 'svg', container: holder, hover: false, logLevel: errors_only,
      tooltip: (handler, event, item, text) => this.hint(text, event),
    });
    await this.view.runAsync();
    this.drawing.replaceChildren(holder, this.cursor);
    this.offset = this.view.origin();
    this.scale = this.view.scale('x');
    this.vertical = this.view.scale('y');
    if (this.options.over_time) {
      this.cursor.style.height = `${this.view.height()}px`;
      this.cursor.style.top = `${this.offset[1] + 4}px`;
      this.#steer();
    }
    this.show(this.player.instant, this.player.time);
  }

  // Lets the reader go to the time under a pressed mouse button or finger.
  #steer() {
    if (this.steered) return;
    this.steered = true;
    const go = event => {
      if (event.buttons !== 1) return;
      const x = event.clientX - this.drawing.getBoundingClientRect().left - this.offset[0] - 2;
      this.player.toggle(false);
      this.player.go(this.scale.invert(x));
    };
    this.drawing.addEventListener('pointerdown', go);
    this.drawing.addEventListener('pointermove', go);
  }

  show(instant, time) {
    if (!this.view) return;
    if (this.options.over_time) {
      this.cursor.style.transform = `translateX(${this.offset[0] + 2 + this.scale(time)}px)`;
      return;
    }
    const x = this.scale(this.options.x[instant]), y = this.vertical(this.data.columns[this.columns[0]].values[instant]);
    this.cursor.style.transform = `translate(${this.offset[0] + 2 + x}px, ${this.offset[1] + 4 + y}px)`;
  }

  // Returns the values at an instant by the names of columns, as the plot has them.
  values(instant) {
    const row = this.view.data('table').find(r => r.k === instant);
    return Object.fromEntries(this.columns.map((c, j) => [this.data.columns[c].name, row[`y${j}`]]));
  }
}

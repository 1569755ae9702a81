// Plots over time, and what is chosen in them.
import {Panel} from './panel.js';

// Returns a check box with a text; changed: called with whether the box is checked.
export function choice(text, checked, changed) {
  const label = document.createElement('label'), box = document.createElement('input');
  box.type = 'checkbox';
  box.checked = checked;
  box.addEventListener('change', () => changed(box.checked));
  label.append(box, ` ${text}`);
  return label;
}

function selection(label, columns, data, chosen, changed) {
  const select = document.createElement('select');
  select.setAttribute('aria-label', label);
  for (const c of columns) select.add(new Option(data.columns[c].name, c, c === chosen, c === chosen));
  select.addEventListener('change', () => changed(Number(select.value)));
  return select;
}

// Largest numbers of quantities plotted to begin with, without and with a request of the scene.
const most_chosen = 4, most_requested = 8;

export class Plots {
  constructor(data, player, hint) {
    Object.assign(this, {data, player, hint, panels: []});
    this.places = ['panels', 'accuracy'].map(id => document.getElementById(id));
    this.#chooseFirst();
    this.#addChoices();
    player.onShow((instant, time) => {
      for (const panel of this.panels) panel.show(instant, time);
    });
    for (const place of this.places) {  // a folded place has width 0
      let width = place.clientWidth;
      new ResizeObserver(() => {
        if (place.clientWidth === 0 || Math.abs(place.clientWidth - width) < 2) return;
        width = place.clientWidth;
        for (const panel of this.panels) if (place.contains(panel.figure)) panel.draw();
      }).observe(place);
    }
  }

  // Chooses what is plotted to begin with: columns of positions (`plain`), the levels of which
  // rates are shown, and the axes of the plot of an output against a driver.
  #chooseFirst() {
    const {data} = this;
    this.plain = data.plotted.filter(c => data.columns[c].level === 0);
    this.driven = data.driven;
    const free = this.plain.filter(c => !this.driven.includes(c));
    const unit = c => data.columns[c].unit;
    const relative = free.filter(c => !/\.[xyz]$/.test(data.columns[c].name));
    const first = [relative, free, this.plain].find(list => list.length > 0) ?? [];
    this.chosen = new Set(data.requested ? this.plain.slice(0, most_requested)
        : first.filter(c => unit(c) === unit(first[0])).slice(0, most_chosen));
    this.levels = new Set(data.requested ? data.plotted.map(c => data.columns[c].level) : [0]);
    const moves = c => new Set(data.columns[c].values).size > 1;
    this.axes = {x: this.driven.find(moves) ?? this.driven[0], y: first[0]};
  }

  #addChoices() {
    const {data} = this;
    const columns = document.getElementById('columns'), levels = document.getElementById('levels');
    for (const c of this.plain)
      columns.append(choice(data.columns[c].name, this.chosen.has(c), on => {
        this.chosen[on ? 'add' : 'delete'](c);
        this.draw();
      }));
    data.levels.forEach((name, level) => {
      if (data.plotted.some(c => data.columns[c].level === level))
        levels.append(choice(name, this.levels.has(level), on => {
          this.levels[on ? 'add' : 'delete'](level);
          this.draw();
        }));
    });
    if (data.wanted > data.plotted.length) {
      const note = document.createElement('p');
      note.textContent = `${data.plotted.length} of ${data.wanted} columns are on the page; ` +
          'a request in the scene chooses others, desmo solve writes all.';
      document.getElementById('choice').append(note);
    }
  }

  // Returns the plotted column of the same quantity at a level; undefined where there is none.
  #atLevel(c, level) {
    const {columns, plotted} = this.data;
    const {name, quantity} = columns[c], prefix = ['', 'd/dt ', 'd2/dt2 '][level];
    return plotted.find(o => columns[o].name === prefix + name && columns[o].quantity === quantity);
  }

  #described() {
    const {data} = this;
    if (data.estimate) return [];  // nothing was solved
    const x = data.times, over_time = true, x_title = 't [s]';
    const list = [];
    const by_unit = new Map();
    for (const level of [...this.levels].sort())
      for (const c of this.chosen) {
        const column = this.#atLevel(c, level);
        if (column === undefined) continue;
        const {unit} = data.columns[column];
        if (!by_unit.has(unit)) by_unit.set(unit, []);
        by_unit.get(unit).push(column);
      }
    for (const [unit, columns] of by_unit)
      list.push([columns, {x, x_title, over_time, title: '', y_title: `[${unit}]`}]);
    if (this.axes.x !== undefined && this.axes.y !== undefined) {
      const change = name => c => {
        this.axes[name] = c;
        this.draw();
      };
      const name = c => data.columns[c].heading;
      list.push([[this.axes.y], {
        x: data.columns[this.axes.x].values, title: 'output against driver', x_title: name(this.axes.x),
        y_title: `[${data.columns[this.axes.y].unit}]`, over_time: false,
        controls: [selection('output', this.plain, data, this.axes.y, change('y')),
                   selection('driver', this.driven, data, this.axes.x, change('x'))],
      }]);
    }
    if (data.transmission.length > 0)
      list.push([data.transmission.slice(0, 8), {
        x, x_title, over_time, zero: true, y_title: `[${data.columns[data.transmission[0]].unit}]`,
        title: `transmission angle, coupler to follower${data.transmission.length > 8 ? ` (8 of ${data.transmission.length} loops)` : ''}`,
      }]);
    const accuracy = true;
    list.push([[data.condition], {x, x_title, over_time, accuracy, log: true, title: '', y_title: 'condition'}]);
    list.push([data.radii, {x, x_title, over_time, accuracy, log: true, title: '', y_title: 'relative'}]);
    return list;
  }

  async draw() {
    for (const panel of this.panels) panel.view?.finalize();
    this.panels = this.#described().map(
        ([columns, options]) => new Panel(this.data, columns, options, this.player, this.hint));
    this.places.forEach((place, accuracy) => {
      const shown = this.panels.filter(panel => !!panel.options.accuracy === !!accuracy);
      place.classList.toggle('many', shown.length > 6);
      place.replaceChildren(...shown.map(panel => panel.figure));
    });
    for (const panel of this.panels) await panel.draw();
  }

  values(instant) {
    return Object.assign({}, ...this.panels.map(panel => panel.values(instant)));
  }
}

// The time shown, and its controls: play, pause, slider, speed and keys. Functions given to
// onShow() are told the instant.

const speeds = [0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 1000];
const usual = 6;  // time in which the first speed shows a whole motion, about [s]
const get = id => document.getElementById(id);

export class Player {
  #data;
  #shown = [];
  #playing = false;
  #last = 0;

  constructor(data) {
    this.#data = data;
    const {times} = data;
    this.first = times[0];
    const whole = data.time.start + (data.time.instants - 1) * data.time.interval;
    this.end = Math.max(times.at(-1), data.flags.some(f => f.kind === 'failed') ? whole : -Infinity);
    this.time = this.first;
    this.instant = 0;
    this.speed = speeds.reduce((a, b) => {
      const off = s => Math.abs(Math.log((this.end - this.first || 1) / usual / s));
      return off(b) < off(a) ? b : a;
    });
    this.#connect();
  }

  // Lets a function be called with (instant, time) whenever the picture is to be drawn anew.
  onShow(show) { this.#shown.push(show); }

  // Returns the last instant on the page that is at most half an interval after a time. An interval
  // is the time between two instants on the page. In a gap, returns the last instant before it.
  at(time) {
    const {times} = this.#data;
    const half = this.#data.time.interval * this.#data.time.stride / 2;
    let low = 0, high = times.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (times[middle] <= time + half) low = middle;
      else high = middle - 1;
    }
    // The instant found may be the one after a gap.
    return low > 0 && times[low] > time && times[low] - times[low - 1] > 2.5 * half ? low - 1 : low;
  }

  go(time) {
    this.time = Math.min(this.end, Math.max(this.first, time));
    this.instant = this.at(this.time);
    this.draw();
  }

  show(instant) {
    const k = Math.min(this.#data.times.length - 1, Math.max(0, instant));
    this.time = this.#data.times[k];
    this.instant = k;
    this.draw();
  }

  draw() {
    get('slider').value = this.time;
    get('now').textContent = `t = ${this.#data.seconds(this.time)}`;
    for (const show of this.#shown) show(this.instant, this.time);
  }

  toggle(play = !this.#playing) {
    this.#playing = play;
    const button = get('play');
    button.textContent = play ? '❚❚' : '▶';
    button.setAttribute('aria-label', play ? 'Pause' : 'Play');
    if (!play) return;
    if (this.time >= this.end) this.time = this.first;
    this.#last = performance.now();
    requestAnimationFrame(now => this.#frame(now));
  }

  #frame(now) {
    if (!this.#playing) return;
    const passed = Math.min(0.2, Math.max(0, (now - this.#last) / 1000));
    this.#last = now;
    const next = this.time + passed * this.speed;
    this.go(next > this.end ? this.first : next);
    requestAnimationFrame(later => this.#frame(later));
  }

  // Goes on by a number of instants on the page. Where the time is after the instant shown, as in a
  // gap, the first step back leads to that instant.
  #step(by) {
    this.toggle(false);
    const {times} = this.#data;
    let k = this.instant + by;
    if (by < 0 && this.time > times[this.instant]) ++k;
    this.show(k);
  }

  #connect() {
    const slider = get('slider'), select = get('speed');
    Object.assign(slider, {min: this.first, max: this.end, step: 'any', value: this.first});
    slider.addEventListener('input', () => {
      this.toggle(false);
      this.go(Number(slider.value));
    });
    get('play').addEventListener('click', () => this.toggle());
    for (const s of speeds) select.add(new Option(`× ${s}`, s, s === this.speed, s === this.speed));
    select.addEventListener('change', () => { this.speed = Number(select.value); });
    document.addEventListener('keydown', event => this.#key(event));
  }

  #key(event) {
    const on = event.target;
    if (event.ctrlKey || event.altKey || event.metaKey || on.closest?.('select, fieldset, summary')) return;
    const faster = by => {
      const select = get('speed');
      select.selectedIndex = Math.min(speeds.length - 1, Math.max(0, select.selectedIndex + by));
      this.speed = Number(select.value);
    };
    const far = event.shiftKey ? 10 : 1;
    const actions = {
      ' ': () => this.toggle(),
      ArrowLeft: () => this.#step(-far),
      ArrowRight: () => this.#step(far),
      Home: () => this.#step(-Infinity),
      End: () => this.#step(Infinity),
      '+': () => faster(1),
      '-': () => faster(-1),
    };
    if (event.key === ' ' && on.closest?.('button, input[type=checkbox]')) return;
    if (event.key.startsWith('Arrow') && on.id === 'stage' && on.dataset.turns && !event.shiftKey) return;
    if (!actions[event.key]) return;
    event.preventDefault();
    actions[event.key]();
  }
}

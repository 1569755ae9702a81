// The data of the page: what C++ wrote as JSON, and columns of numbers as packing.h packs them.
import {add_transmission, interpret} from './mechanism.js';

async function bytesOf(text) {
  const packed = Uint8Array.from(atob(text.trim()), letter => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Returns a function that reads the next whole number: second differences modulo 2³², the sign in
// the lowest bit, seven bits to a byte.
function reader(bytes) {
  let at = 0;
  return () => {
    let rest = 0;
    for (let shift = 0;; shift += 7) {
      const byte = bytes[at++];
      rest |= (byte & 127) << shift;
      if (byte < 128) return (rest >>> 1) ^ -(rest & 1);
    }
  };
}

const bits = new DataView(new ArrayBuffer(4));

// Returns the float whose bits, in the order of floats, are a whole number.
function float(ordered) {
  bits.setInt32(0, ordered < 0 ? -ordered | 0x80000000 : ordered);
  return bits.getFloat32(0);
}

function column(next, length, {step, origin}) {
  const values = new Float64Array(length);
  let value = 0, difference = 0;
  for (let i = 0; i < length; ++i) {
    difference = (difference + next()) | 0;
    value = (value + difference) | 0;
    values[i] = step ? origin + step * value : float(value);
  }
  return values;
}

// Returns what there is to show: the JSON, with `values` of each column, `index` and `times` of the
// instants, and the mechanism.
export async function read() {
  const data = JSON.parse(document.getElementById('data').textContent);
  const next = reader(await bytesOf(document.getElementById('numbers').textContent));
  for (const one of data.columns) one.values = column(next, data.shown, one);
  data.index = data.columns[0].values;
  data.times = data.index.map(i => data.time.start + i * data.time.interval);
  interpret(data);
  add_transmission(data, at);
  return data;
}

// Returns the components of a point or vector at an instant; level: position, velocity or
// acceleration.
export function at(data, entity, i, level = 'position') {
  if (entity.fixed) return level === 'position' ? entity.fixed : entity.fixed.map(() => 0);
  const first = entity[level];
  const result = [];
  for (let axis = 0; axis < data.dimension; ++axis) result.push(data.columns[first + axis].values[i]);
  return result;
}

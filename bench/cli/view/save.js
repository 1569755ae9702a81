// Files that the reader can save: the picture as SVG, and the numbers as CSV.

function save(name, type, text) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([text], {type}));
  link.download = name;
  link.click();
  URL.revokeObjectURL(link.href);
}

const cell = text => /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;

// Returns the CSV of all instants of the page: the time with 15 digits, and every column with 8.
function csv(data) {
  const digits = (x, count) => Number.isFinite(x) ? String(Number(x.toPrecision(count))) : '';
  const rows = data.times.map((t, i) => [digits(t, 15), ...data.columns.map(c => digits(c.values[i], 8))].join());
  return [['t [s]', ...data.columns.map(c => c.heading)].map(cell).join(), ...rows].join('\n') + '\n';
}

export function connectSaving(data, picture) {
  const connect = (id, ending, type, text) => document.getElementById(id).addEventListener(
      'click', () => save(`${data.mechanism}.${ending}`, type, text()));
  connect('save_picture', 'svg', 'image/svg+xml', () => picture.file());
  connect('save_data', 'csv', 'text/csv', () => csv(data));
}

// The parts of the page that are text: heading, provenance, numbers. Texts of the file only ever
// become textContent, so that none of them is taken for HTML.
const numbers = [
  'increment', 'density', 'length', 'force', 'bend', 'twist', 'snaps', 'contacts', 'overlap',
  'residual'
];

function put(parent, name, text, attributes = {}) {
  const child = document.createElement(name);
  child.textContent = text;
  for (const [key, value] of Object.entries(attributes)) child.setAttribute(key, value);
  parent.append(child);
  return child;
}

function cavity_text() {
  const lengths = run.semi_axes.map((e) => shown(e / wire_radius));
  const is_sphere = run.semi_axes.every((e) => e === cavity_reach);
  return is_sphere ? `R = ${lengths[0]} a` : `semi-axes ${lengths.join(', ')} a`;
}

function write_heading() {
  document.title = run.name + ' – wirepack';
  element('name').textContent = run.name;
  element('about').textContent =
      `${run.setup}, ${run.method}, ${cavity_text()}, ` +
      `φ to ${shown(past.density.values.at(-1))}`;
}

function write_provenance() {
  for (const [label, text] of run.provenance) {
    put(element('provenance'), 'dt', label);
    put(element('provenance'), 'dd', text);
  }
  const saved = run.saved_frames === frame_count ? `all ${frame_count}` :
                                                   `${frame_count} of ${run.saved_frames}`;
  put(element('provenance'), 'dt', 'frames in this page');
  put(element('provenance'), 'dd', saved);
  element('config').textContent = run.config;
}

// What is released in snaps since the frame before belongs to a frame.
function released_before(frame) {
  let sum = 0;
  for (let row = frame === 0 ? 0 : frame_rows[frame - 1] + 1; row <= frame_rows[frame]; ++row)
    sum += past.snap.values[row];
  return sum;
}

function number_of(name, frame) {
  return name === 'snaps' ? released_before(frame) : past[name].values[frame_rows[frame]];
}

function heading_of(name) {
  const {label, unit} = name === 'snaps' ?
      {label: 'released in snaps since the frame before', unit: past.snap.unit} :
      past[name];
  return label + (unit ? ` [${unit}]` : '');
}

function write_numbers() {
  const head = element('numbers').querySelector('thead tr'),
        body = element('numbers').querySelector('tbody');
  for (const name of numbers) put(head, 'th', heading_of(name), {scope: 'col'});
  for (let frame = 0; frame < frame_count; ++frame) {
    const line = put(body, 'tr', '', {'data-frame': frame});
    for (const name of numbers) {
      if (name !== 'increment') {
        put(line, 'td', shown(number_of(name, frame), 4));
        continue;
      }
      const cell = put(line, 'th', '', {scope: 'row'});
      put(cell, 'button', String(number_of(name, frame)), {
        type: 'button',
        title: 'show this moment'
      }).addEventListener('click', () => set_frame(frame));
    }
  }
}

function save_file(blob, name) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

const stem = () => run.name.replace(/\.[^.]*$/, '').replace(/[^\w.-]+/g, '_') || 'packing';

function save_numbers() {
  const lines = [numbers.map((name) => `"${heading_of(name)}"`)];
  for (let frame = 0; frame < frame_count; ++frame)
    lines.push(numbers.map((name) => number_of(name, frame)));
  save_file(
      new Blob([lines.map((line) => line.join(',')).join('\n') + '\n'], {type: 'text/csv'}),
      stem() + '.csv');
}

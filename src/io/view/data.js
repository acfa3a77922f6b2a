// The run as the page holds it, and the numbers in it unpacked.
const run = JSON.parse(document.getElementById('data').textContent);
const frame_count = run.frames.length;

async function inflated(text) {
  const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Numbers of `size` bytes whose first bytes stand first, then their second ones, ...
function joined_planes(bytes, size) {
  const count = bytes.length / size, result = new Uint8Array(bytes.length);
  for (let i = 0; i < count; ++i) {
    for (let k = 0; k < size; ++k) result[i * size + k] = bytes[k * count + i];
  }
  return result.buffer;
}

// Undoes the differences to the number before; typed arrays wrap around by themselves.
function sum_up(numbers) {
  for (let i = 1; i < numbers.length; ++i) numbers[i] += numbers[i - 1];
}

// Positions of a frame: x, y, z of all nodes, one axis after the other.
async function positions(frame) {
  const zigzag = new Uint16Array(joined_planes(await inflated(frame.position), 2));
  const numbers = new Int16Array(zigzag.length);
  for (let i = 0; i < zigzag.length; ++i)
    numbers[i] = zigzag[i] & 1 ? -((zigzag[i] + 1) >> 1) : zigzag[i] >> 1;
  for (let k = 0; k < run.position_differences; ++k) sum_up(numbers);
  return Float32Array.from(numbers, (n) => n * frame.quantum);
}

async function codes(field, frame) {
  const bytes = await inflated(run.fields[field].codes[frame]);
  sum_up(bytes);
  return bytes;
}

// Each is unpacked when it is first asked for.
function remembered(make) {
  const known = new Map();
  return (...key) => {
    const name = key.join();
    if (!known.has(name)) known.set(name, make(...key));
    return known.get(name);
  };
}
const positions_of = remembered((frame) => positions(run.frames[frame]));
const codes_of = remembered(codes);

// Columns of the history by name: {label, unit, values}.
async function unpack_history() {
  const history = {};
  for (const column of run.history) {
    const values = new Float32Array(joined_planes(await inflated(column.values), 4));
    history[column.name] = {label: column.label, unit: column.unit, values};
  }
  return history;
}

// The row of the history that belongs to each frame.
function rows_of_frames(history) {
  const rows = [];
  let row = 0;
  for (const frame of run.frames) {
    while (row + 1 < run.rows && history.increment.values[row] < frame.increment) ++row;
    rows.push(row);
  }
  return rows;
}

function shown(value, digits = 3) {
  if (!Number.isFinite(value)) return '–';
  const size = Math.abs(value);
  const rounded = Number(value.toPrecision(digits));
  if (size !== 0 && (size < 1e-3 || size >= 1e5)) return rounded.toExponential().replace('e+', 'e');
  return String(rounded);
}
const with_unit = (value, unit) => shown(value) + (unit && unit !== '1' ? ' ' + unit : '');

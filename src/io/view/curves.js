// Force and energies against the packing density; a click goes to the frame nearest to it.
const svg_names = 'http://www.w3.org/2000/svg';
const plot = {width: 340, height: 118, left: 44, right: 8, top: 8, bottom: 20};

function svg(parent, name, attributes, text) {
  const element = document.createElementNS(svg_names, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  if (text !== undefined) element.textContent = text;
  parent.append(element);
  return element;
}

const round_off = 1e-9;  // energies and forces over their units that are nothing else

// The least and the largest of what is left of `values`; a logarithmic axis has positive ones only.
function extent(values, log) {
  let low = Infinity, high = -Infinity;
  for (const v of values) {
    if (!Number.isFinite(v) || (log && v <= 0)) continue;
    low = Math.min(low, v);
    high = Math.max(high, v);
  }
  if (low > high) return log ? [0.1, 1] : [0, 1];
  if (log) return [Math.max(low, high * 1e-4), high * 1.2];
  if (Math.max(Math.abs(low), Math.abs(high)) < round_off) return [0, 1];
  const least = Math.min(0, low);
  return [least, high > least ? high + 0.05 * (high - least) : least + 1];
}

// A path through all points, of which each column of pixels keeps the lowest and the highest.
function path_of(xs, ys, to_x, to_y) {
  let text = '', pen = 'M', column = null, low = 0, high = 0, last = 0;
  const flush = () => {
    if (column === null) return;
    for (const y of new Set([low, high, last])) {
      text += `${pen}${column / 2} ${y.toFixed(1)}`;
      pen = 'L';
    }
  };
  for (let i = 0; i < xs.length; ++i) {
    const y = to_y(ys[i]);
    if (!Number.isFinite(y)) continue;
    const here = Math.round(2 * to_x(xs[i]));
    if (here !== column) {
      flush();
      column = here;
      low = high = y;
    }
    low = Math.min(low, y);
    high = Math.max(high, y);
    last = y;
  }
  flush();
  return text;
}

// Snaps that a mark is drawn for: the largest ones.
function marked_snaps(history) {
  const rows = [];
  history.snap.values.forEach((energy, row) => {
    if (energy > 0) rows.push(row);
  });
  return rows.sort((p, q) => history.snap.values[q] - history.snap.values[p]).slice(0, 60);
}

function create_curve(figure, history, name, log, go_to) {
  const picture = figure.querySelector('svg'), readout = figure.querySelector('output');
  const column = history[name], xs = history.density.values, ys = column.values;
  picture.setAttribute('viewBox', `0 0 ${plot.width} ${plot.height}`);
  const far = xs[xs.length - 1] || 1;
  const inner = {
    width: plot.width - plot.left - plot.right,
    height: plot.height - plot.top - plot.bottom
  };
  const to_x = (phi) => plot.left + inner.width * phi / far;
  let to_y = null, dot = null, line = null;

  function draw_axes(low, high, log) {
    for (const t of ticks(low, high, log, 3)) {
      const y = to_y(t);
      svg(picture, 'line',
          {x1: plot.left, x2: plot.width - plot.right, y1: y, y2: y, class: 'grid'});
      svg(picture, 'text', {x: plot.left - 5, y: y + 3.5, class: 'tick end'}, shown(t));
    }
    for (const t of ticks(0, far, false, 5)) {
      svg(picture, 'text', {x: to_x(t), y: plot.height - 6, class: 'tick middle'}, shown(t));
    }
  }

  function draw_snaps() {
    const bottom = plot.height - plot.bottom;
    for (const row of marked_snaps(history)) {
      const x = to_x(xs[row]);
      const mark = svg(picture, 'path', {
        d: `M${x - 3.5} ${bottom + 4}L${x} ${bottom - 4}L${x + 3.5} ${bottom + 4}Z`,
        class: 'snap'
      });
      svg(mark, 'title', {},
          `snap at φ = ${shown(xs[row])}, which released ${
              with_unit(history.snap.values[row], history.snap.unit)}`);
    }
  }

  function draw(log) {
    picture.replaceChildren();
    const [low, high] = extent(ys, log);
    to_y = (v) =>
        plot.top + inner.height * (1 - place(Math.max(v, log ? low : v), [low, high], log));
    draw_axes(low, high, log);
    svg(picture, 'path', {d: path_of(xs, ys, to_x, to_y), class: 'curve'});
    draw_snaps();
    line = svg(picture, 'line', {y1: plot.top, y2: plot.height - plot.bottom, class: 'marker'});
    dot = svg(picture, 'circle', {r: 4, class: 'dot'});
  }

  picture.addEventListener('click', (event) => {
    const box = picture.getBoundingClientRect();
    const x = (event.clientX - box.left) * plot.width / box.width;
    go_to(Math.min(far, Math.max(0, (x - plot.left) / inner.width * far)));
  });
  draw(log);
  return {
    draw,
    mark(row) {
      const x = to_x(xs[row]);
      line.setAttribute('x1', x);
      line.setAttribute('x2', x);
      dot.setAttribute('cx', x);
      dot.setAttribute('cy', to_y(ys[row]));
      readout.textContent = shown(ys[row]);
      const [low, high] = extent(ys, false);
      picture.setAttribute(
          'aria-label',
          `${column.label} against packing density from 0 to ${shown(far)}: between ` +
              `${shown(low)} and ${with_unit(high / 1.05, column.unit)}; ${
                  with_unit(ys[row], column.unit)} at ${shown(xs[row])}`);
    },
  };
}

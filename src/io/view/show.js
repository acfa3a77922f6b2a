// Brings the state to the controls.
function show_frame() {
  const row = frame_rows[state.frame];
  const [phi, length] = [past.density.values[row], past.length.values[row]];
  element('time').value = state.frame;
  element('time').setAttribute(
      'aria-valuetext',
      `frame ${state.frame + 1} of ${frame_count}, packing density ${shown(phi)}`);
  element('moment').textContent =
      `φ = ${shown(phi)} · L = ${shown(length, 4)} a · frame ${state.frame + 1} of ${frame_count}`;
  curves.forEach((curve) => curve.mark(row));
  for (const line of element('numbers').querySelectorAll('tbody tr')) {
    if (Number(line.dataset.frame) === state.frame) line.setAttribute('aria-current', 'true');
    else line.removeAttribute('aria-current');
  }
  show_nodes();
  describe();
}

function show_colours() {
  const field = fields[state.field];
  element('field').value = state.field;
  element('log').checked = state.log;
  element('log').disabled = !(field.low > 0);
  element('low').value = shown(state.range[0]);
  element('high').value = shown(state.range[1]);
  element('map').value = state.map;
  show_bar(field);
  if (scene) scene.set_map(stops(state.map));
  show_nodes();
  describe();
}

function show_bar(field) {
  element('bar_title').textContent =
      field.label + (field.unit === '1' ? '' : ' [' + field.unit + ']');
  element('bar').style.background = css_gradient(state.map, 'to right');
  element('bar_ticks').replaceChildren(...bar_ticks().map(({share, text}) => {
    const tick = document.createElement('span');
    tick.textContent = text;
    tick.style.left = 100 * share + '%';
    return tick;
  }));
  element('bar_none').hidden = !field.logarithmic;
}

const bar_ticks = () =>
    ticks(...state.range, state.log, 4)
        .map((t) => ({share: place(t, state.range, state.log), text: shown(t)}));

function cut_text() {
  const names = {x: 'x', y: 'y', z: 'z', view: 'depth'};
  return `${names[state.cut_axis]} = ${shown(state.cut_at / wire_radius)} a`;
}

function show_cut(moving = false) {
  element('cut').checked = state.cut;
  element('cut_axis').value = state.cut_axis;
  element('cut_at').value = state.cut_at / cavity_reach;
  element('cut_at').setAttribute('aria-valuetext', cut_text());
  element('cut_text').textContent = state.cut ? cut_text() : 'off';
  element('section').checked = state.section;
  element('outline').checked = state.outline;
  redraw(moving);
  describe();
}

// What the picture shows, in words, for those who do not see it.
function describe() {
  const row = frame_rows[state.frame], field = fields[state.field];
  const turn = matrix(state.turn), from = turn[2];
  const main =
      [0, 1, 2].reduce((best, k) => (Math.abs(from[k]) > Math.abs(from[best]) ? k : best), 0);
  const text = `Wire in a sphere, packing density ${shown(past.density.values[row])}, ` +
    `force ${with_unit(past.force.values[row], past.force.unit)}, coloured by ${field.label}, ` +
    `seen mainly along the ${'xyz'[main]} axis` + (state.cut ? `, cut at ${cut_text()}.` : '.');
  element('stage').setAttribute('aria-label', text);
  clearTimeout(describe.later);
  describe.later = setTimeout(() => { element('status').textContent = text; }, 600);
}

function show_everything() {
  show_frame();
  show_colours();
  show_cut();
}

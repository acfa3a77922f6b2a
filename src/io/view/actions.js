// Everything that changes the state. Buttons, keys and curves call these.
const element = (id) => document.getElementById(id);
let past = null, frame_rows = null, curves = [];  // the history, and what shows it

function set_frame(frame) {
  state.frame = Math.min(frame_count - 1, Math.max(0, frame));
  redraw(true);
  show_frame();
}

function go_to_density(phi) {
  const off = (frame) => Math.abs(past.density.values[frame_rows[frame]] - phi);
  let best = 0;
  for (let frame = 1; frame < frame_count; ++frame) if (off(frame) < off(best)) best = frame;
  set_frame(best);
}

let playing = false;
async function play(on = !playing) {
  if (on === playing) return;
  playing = on;
  element('play').setAttribute('aria-pressed', playing);
  element('play').textContent = playing ? '❚❚ Pause' : '▶ Play';
  if (playing && state.frame === frame_count - 1) set_frame(0);
  while (playing) {
    await new Promise((done) => setTimeout(done, 160));
    if (!playing) break;
    if (state.frame + 1 >= frame_count) play(false);
    else set_frame(state.frame + 1);
  }
}

function set_field(index) {
  const field = fields[index];
  if (!field) return;
  state.field = index;
  state.log = field.logarithmic;
  state.range = field.shown.slice();
  show_colours();
}

function set_log(on) {
  const field = fields[state.field];
  if (on && !(field.low > 0)) return;
  state.log = on;
  if (on && !(state.range[0] > 0)) state.range[0] = field.low;
  show_colours();
}

function set_range(end, value) {
  const range = state.range.slice();
  range[end] = value;
  if (Number.isFinite(value) && range[0] < range[1] && (!state.log || range[0] > 0))
    state.range = range;
  show_colours();
}

// Cuts along an axis, the open side towards the viewer.
function set_cut_axis(name) {
  const turn = matrix(state.turn);
  state.cut_axis = name;
  state.cut_normal = name === 'view' ? turn[2].slice() : axes[name];
  state.cut_side = turned(turn, state.cut_normal)[2] >= 0 ? 1 : -1;
  show_cut();
}

function set_cut(on) {
  state.cut = on;
  if (on) set_cut_axis(state.cut_axis);
  else show_cut();
}

function move_cut(to, moving = true) {
  state.cut = true;
  state.cut_at = Math.min(cavity_reach, Math.max(-cavity_reach, to));
  show_cut(moving);
}

function flip_cut() {
  state.cut_side = -state.cut_side;
  show_cut();
}

function turn_view(axis, angle) {
  state.turn = unit(product(turn_about(axis, angle), state.turn));
  redraw(true);
  describe();
}

function zoom_view(factor, at = [0, 0]) {
  const before = length_per_pixel();
  state.zoom = Math.min(200, Math.max(0.3, state.zoom * factor));
  const change = before - length_per_pixel();  // what is under `at` stays there
  state.pan = [state.pan[0] + at[0] * change, state.pan[1] + at[1] * change];
  redraw(true);
}

function pan_view(dx, dy) {
  const size = length_per_pixel();
  state.pan = [state.pan[0] - dx * size, state.pan[1] + dy * size];
  redraw(true);
}

function look(name) {
  state.turn = unit(standard_views[name]);
  state.zoom = 1;
  state.pan = [0, 0];
  redraw();
  describe();
}

// From the open side of the cut, at a right angle.
function look_at_cut() {
  const n = state.cut_normal.map((c) => c * state.cut_side);
  const now = turned(matrix(state.turn), n), angle = Math.acos(Math.min(1, Math.max(-1, now[2])));
  const axis = Math.hypot(now[0], now[1]) > 1e-9 ? [now[1], -now[0], 0] : [1, 0, 0];
  const size = Math.hypot(...axis);
  state.turn = unit(product(turn_about(axis.map((c) => c / size), angle), state.turn));
  redraw();
  describe();
}

function set_theme(name) {
  document.documentElement.dataset.theme = name;
  element('theme').setAttribute('aria-pressed', name === 'light');
  redraw();
}

const toggle_theme = () =>
    set_theme(document.documentElement.dataset.theme === 'light' ? 'dark' : 'light');

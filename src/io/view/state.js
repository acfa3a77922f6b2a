// What is shown. All of it, so that a link brings the same view back.
const axes = {x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1]};

function first_state() {
  return {
    frame: frame_count - 1,
    field: 0,
    log: fields[0].logarithmic,
    range: fields[0].shown.slice(),
    map: 'viridis',
    cut: false,
    cut_normal: axes.y,  // a unit vector
    cut_axis: 'y',       // its name; 'view' for one of the viewer's choice
    cut_at: 0,           // distance of the plane from the middle of the cavity, along the normal
    cut_side: 1,         // 1: what lies beyond is cut away; -1: what lies before
    section: false,      // nothing but the cut face
    outline: true,
    turn: unit(standard_views.home),
    zoom: 1,
    pan: [0, 0],
  };
}
const state = first_state();

function read_link() {
  let saved;
  try {
    saved = JSON.parse(decodeURIComponent(location.hash.slice(1)));
  } catch {
    return;
  }
  const start = first_state();
  for (const key of Object.keys(start)) {
    if (!(key in saved) || !same_kind(start[key], saved[key])) continue;
    state[key] = saved[key];
  }
  mend(start);
}

// Puts what a link cannot mean back to how it starts.
function mend(start) {
  const back = (...keys) => keys.forEach((key) => { state[key] = start[key]; });
  state.frame = Math.min(frame_count - 1, Math.max(0, Math.round(state.frame)));
  state.zoom = Math.min(200, Math.max(0.3, state.zoom));
  if (!fields[state.field]) back('field');
  if (!Object.hasOwn(maps, state.map)) back('map');
  if (Math.hypot(...state.turn) < 1e-3) back('turn');
  if (Math.hypot(...state.cut_normal) < 1e-3 ||
      !(Object.hasOwn(axes, state.cut_axis) || state.cut_axis === 'view')) {
    back('cut_normal', 'cut_axis');
  }
  state.turn = unit(state.turn);
  state.cut_normal = unit(state.cut_normal);
  state.cut_side = state.cut_side < 0 ? -1 : 1;
  if (!(state.range[0] < state.range[1]) || (state.log && state.range[0] <= 0)) {
    state.log = fields[state.field].logarithmic;
    state.range = fields[state.field].shown.slice();
  }
}

function same_kind(a, b) {
  if (Array.isArray(a))
    return Array.isArray(b) && a.length === b.length && b.every(Number.isFinite);
  return typeof a === typeof b && (typeof a !== 'number' || Number.isFinite(b));
}

function write_link() {
  const rounded = (key, value) =>
      (typeof value === 'number' ? Number(value.toPrecision(7)) : value);
  history.replaceState(null, '', '#' + encodeURIComponent(JSON.stringify(state, rounded)));
}

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
  state.frame = Math.min(frame_count - 1, Math.max(0, Math.round(state.frame)));
  if (!fields[state.field]) state.field = 0;
  if (!maps[state.map]) state.map = start.map;
  state.turn = unit(state.turn);
}

function same_kind(a, b) {
  if (Array.isArray(a)) return Array.isArray(b) && a.length === b.length && b.every(Number.isFinite);
  return typeof a === typeof b && (typeof a !== 'number' || Number.isFinite(b));
}

function write_link() {
  const rounded = (key, value) => (typeof value === 'number' ? Number(value.toPrecision(7)) : value);
  history.replaceState(null, '', '#' + encodeURIComponent(JSON.stringify(state, rounded)));
}

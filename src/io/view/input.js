// Mouse, touch and keys.
const pointers = new Map();

function middle(points) {
  const list = [...points];
  return [
    list.reduce((s, p) => s + p.x, 0) / list.length, list.reduce((s, p) => s + p.y, 0) / list.length
  ];
}

function spread_of(points) {
  const [a, b] = [...points];
  return {distance: Math.hypot(a.x - b.x, a.y - b.y), angle: Math.atan2(a.y - b.y, a.x - b.x)};
}

// From the middle of the picture, y up, in pixels.
function from_middle(x, y) {
  const box = stage.getBoundingClientRect();
  return [x - box.left - box.width / 2, box.top + box.height / 2 - y];
}

function drag_one(dx, dy, event) {
  if (event.shiftKey || event.buttons & 6) {
    pan_view(dx, dy);
    return;
  }
  const size = Math.hypot(dx, dy);
  if (size > 0)
    turn_view(
        [dy / size, dx / size, 0], 3.5 * size / Math.min(stage.clientWidth, stage.clientHeight));
}

// Two fingers move, spread and turn the picture.
function drag_two(before, after) {
  const [old_middle, new_middle] = [middle(before), middle(after)];
  const [old_spread, new_spread] = [spread_of(before), spread_of(after)];
  pan_view(new_middle[0] - old_middle[0], new_middle[1] - old_middle[1]);
  if (old_spread.distance > 0)
    zoom_view(new_spread.distance / old_spread.distance, from_middle(...new_middle));
  let angle = old_spread.angle - new_spread.angle;
  angle -= 2 * Math.PI * Math.round(angle / (2 * Math.PI));
  turn_view([0, 0, 1], angle);
}

function listen_to_pointers() {
  stage.addEventListener('pointerdown', (event) => {
    if (event.target.closest('button')) return;
    stage.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, {x: event.clientX, y: event.clientY});
  });
  stage.addEventListener('pointermove', (event) => {
    const old = pointers.get(event.pointerId);
    if (!old) return;
    const before = [...pointers.values()];
    pointers.set(event.pointerId, {x: event.clientX, y: event.clientY});
    if (pointers.size === 1) drag_one(event.clientX - old.x, event.clientY - old.y, event);
    if (pointers.size === 2) drag_two(before, [...pointers.values()]);
  });
  for (const end of ['pointerup', 'pointercancel'])
    stage.addEventListener(end, (event) => pointers.delete(event.pointerId));
  stage.addEventListener('contextmenu', (event) => event.preventDefault());
  stage.addEventListener('wheel', (event) => {
    event.preventDefault();
    zoom_view(
        Math.exp(-event.deltaY * (event.deltaMode === 1 ? 0.05 : 0.0015)),
        from_middle(event.clientX, event.clientY));
  }, {passive: false});
}

const quarter = Math.PI / 24;
// [keys, what they do in words, the action]; the help lists them in this order.
const keys = [
  [['ArrowLeft'], 'turn to the left', () => turn_view([0, 1, 0], -quarter)],
  [['ArrowRight'], 'turn to the right', () => turn_view([0, 1, 0], quarter)],
  [['ArrowUp'], 'turn up', () => turn_view([1, 0, 0], -quarter)],
  [['ArrowDown'], 'turn down', () => turn_view([1, 0, 0], quarter)],
  [['<', '>'], 'roll', (key) => turn_view([0, 0, 1], key === '<' ? quarter : -quarter)],
  [['+', '='], 'nearer', () => zoom_view(1.25)],
  [['-'], 'farther', () => zoom_view(0.8)],
  [['0'], 'first view again', () => look('home')],
  [['x', 'y', 'z'], 'look along an axis', (key) => look(key)],
  [
    [',', '.'], 'frame before, next frame', (key) => set_frame(state.frame + (key === ',' ? -1 : 1))
  ],
  [['Home', 'End'], 'first, last frame', (key) => set_frame(key === 'Home' ? 0 : frame_count - 1)],
  [[' '], 'play or pause', () => play()],
  [['c'], 'cut on or off', () => set_cut(!state.cut)],
  [
    ['[', ']'], 'move the cut',
    (key) => move_cut(state.cut_at + (key === '[' ? -1 : 1) * wire_radius / 2)
  ],
  [
    ['a'], 'next axis of the cut',
    () => {
      state.cut = true;
      set_cut_axis({x: 'y', y: 'z', z: 'x', view: 'x'}[state.cut_axis]);
    }
  ],
  [
    ['v'], 'cut at a right angle to the view',
    () => {
      state.cut = true;
      set_cut_axis('view');
    }
  ],
  [['f'], 'flip the cut', flip_cut],
  [['n'], 'look at the cut at a right angle', look_at_cut],
  [
    ['e'], 'nothing but the cut face',
    () => {
      state.section = !state.section;
      show_cut();
    }
  ],
  [
    ['o'], 'outline of the cavity',
    () => {
      state.outline = !state.outline;
      show_cut();
    }
  ],
  [['1', '2', '3', '4', '5', '6'], 'what colours the wire', (key) => set_field(Number(key) - 1)],
  [['l'], 'logarithmic colours', () => set_log(!state.log)],
  [['d'], 'dark or light', () => toggle_theme()],
  [['s'], 'save the picture', () => save_picture()],
  [['?'], 'this list', () => toggle_help()],
];

function toggle_help() {
  const help = element('help');
  if (help.open) help.close();
  else help.showModal();
}

// Keys that a control under the focus uses itself.
function is_taken(event) {
  const target = event.target;
  if (target.matches('select, input[type=number], textarea')) return true;
  if (target.matches('input[type=range]')) return /^Arrow|^Home$|^End$|^Page/.test(event.key);
  if (target.matches('button, summary, input, a'))
    return event.key === ' ' || event.key === 'Enter';
  // they scroll the page
  return !target.closest('#stage') && /^Arrow|^Home$|^End$/.test(event.key);
}

function listen_to_keys() {
  document.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || is_taken(event)) return;
    const help = element('help');
    if (help.open && event.key !== '?') return;
    const known = keys.find(([names]) => names.includes(event.key));
    if (!known) return;
    event.preventDefault();
    known[2](event.key);
  });
}

function write_help() {
  const names = {' ': 'Space', ArrowLeft: '←', ArrowRight: '→', ArrowUp: '↑', ArrowDown: '↓'};
  for (const [list, text] of keys) {
    const term = put(element('keys'), 'dt', '');
    list.forEach((key) => put(term, 'kbd', names[key] || key));
    put(element('keys'), 'dd', text);
  }
}

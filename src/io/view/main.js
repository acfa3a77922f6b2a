function fill_choices() {
  fields.forEach((field, k) => put(element('field'), 'option', field.label, {value: k}));
  Object.keys(maps).forEach((name) => put(element('map'), 'option', name, {value: name}));
  element('time').max = frame_count - 1;
  element('time').disabled = element('play').disabled = frame_count < 2;
}

const on = (id, event, action) => element(id).addEventListener(event, (e) => action(e.target));

function listen_to_controls() {
  on('time', 'input', (t) => set_frame(Number(t.value)));
  on('play', 'click', () => play());
  on('field', 'change', (t) => set_field(Number(t.value)));
  on('log', 'change', (t) => set_log(t.checked));
  on('low', 'change', (t) => set_range(0, Number(t.value)));
  on('high', 'change', (t) => set_range(1, Number(t.value)));
  on('map', 'change', (t) => { state.map = t.value; show_colours(); });
  on('cut', 'change', (t) => set_cut(t.checked));
  on('cut_axis', 'change', (t) => { state.cut = true; set_cut_axis(t.value); });
  on('cut_at', 'input', (t) => move_cut(Number(t.value) * cavity_reach));
  on('flip', 'click', flip_cut);
  on('face', 'click', look_at_cut);
  on('section', 'change', (t) => { state.section = t.checked; show_cut(); });
  on('outline', 'change', (t) => { state.outline = t.checked; show_cut(); });
  on('force_log', 'change', (t) => {
    curves[0].draw(t.checked);
    curves[0].mark(frame_rows[state.frame]);
  });
  on('save', 'click', save_picture);
  on('save_numbers', 'click', save_numbers);
  on('theme', 'click', toggle_theme);
  on('show_help', 'click', toggle_help);
  on('close_help', 'click', toggle_help);
  on('nearer', 'click', () => zoom_view(1.25));
  on('farther', 'click', () => zoom_view(0.8));
  for (const name of Object.keys(standard_views)) on('look_' + name, 'click', () => look(name));
}

function start_scene() {
  scene = create_scene(canvas);
  if (!scene)
    say('This browser gives no WebGL2, so the wire is not drawn; curves and numbers are all here.');
}

async function start() {
  past = await unpack_history();
  frame_rows = rows_of_frames(past);
  read_link();
  write_heading();
  write_provenance();
  write_numbers();
  write_help();
  fill_choices();
  listen_to_controls();
  listen_to_pointers();
  listen_to_keys();
  const force_log = element('force_log').checked;
  curves = [['force', force_log], ['bend', false], ['twist', false]].map(
    ([name, log]) => create_curve(element('curve_' + name), past, name, log, go_to_density));
  set_theme(matchMedia('(prefers-color-scheme: light)').matches ? 'light' : 'dark');
  start_scene();
  canvas.addEventListener('webglcontextlost', (event) => event.preventDefault());
  canvas.addEventListener('webglcontextrestored', () => { start_scene(); show_everything(); });
  new ResizeObserver(() => redraw()).observe(stage);
  painter.moving = true;  // the first picture soon, the fine one after it
  show_everything();
  redraw(true);
}

start().catch((error) => say('This page cannot be shown: ' + error.message));

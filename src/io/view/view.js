// When to draw what: few pixels while things move, then all of them, several samples each.
const canvas = document.getElementById('picture');
const stage = document.getElementById('stage');
let scene = null;

const painter = {
  sample: 0,
  moving: false,
  motion_scale: 0.6,
  last_time: 0,
  waiting: false,
  settle: 0,
  pictures: 0,
  nodes: 0,
};

// Units of length from the middle of the picture to its nearer side.
const half_side = () => 1.08 * cavity_reach / state.zoom;

function length_per_pixel() {
  return 2 * half_side() / Math.min(stage.clientWidth, stage.clientHeight);
}

function ink() {
  return getComputedStyle(document.documentElement)
      .getPropertyValue('--ink-rgb')
      .split(' ')
      .map((c) => c / 255);
}

function current_view(width, height) {
  const turn = matrix(state.turn);
  const pixel = 2 * half_side() / Math.min(width, height);
  const side = state.cut_side;
  return {
    turn, pan: state.pan, half_size: [width * pixel / 2, height * pixel / 2],
    depth: 1.1 * cavity_reach + 4 * wire_radius,
    wall: turned_quadric(turn, run.semi_axes.map((e) => 1 / e ** 2)),
    cut: state.cut, section: state.cut && state.section,
    plane: [...turned(turn, state.cut_normal).map((c) => side * c), side * state.cut_at],
    line: 1.4 * length_per_pixel(), outline: state.outline, ink: ink(),
  };
}

function fit_canvas() {
  const ratio = window.devicePixelRatio || 1;
  const width = Math.max(1, Math.round(stage.clientWidth * ratio)),
        height = Math.max(1, Math.round(stage.clientHeight * ratio));
  if (canvas.width === width && canvas.height === height) return;
  canvas.width = width;
  canvas.height = height;
}

// Asks for a new picture; `moving` says that more will follow soon.
function redraw(moving = false) {
  painter.sample = 0;
  delete document.documentElement.dataset.drawn;
  if (moving) {
    painter.moving = true;
    clearTimeout(painter.settle);
    painter.settle = setTimeout(() => {
      painter.moving = false;
      redraw();
    }, 200);
  }
  next_picture();
}

function next_picture() {
  if (painter.waiting || !scene) return;
  painter.waiting = true;
  requestAnimationFrame(paint);
}

// Keeps motion at some 20 pictures per second by the number of pixels.
function adapt_scale(now) {
  const gap = now - painter.last_time;
  if (gap > 60 && gap < 3000) painter.motion_scale = Math.max(0.25, painter.motion_scale * 0.85);
  if (gap < 30) painter.motion_scale = Math.min(1, painter.motion_scale * 1.1);
}

function paint(now) {
  painter.waiting = false;
  if (scene.gl.isContextLost()) return;
  if (painter.moving) adapt_scale(now);
  painter.last_time = now;
  fit_canvas();
  scene.draw(
      current_view(canvas.width, canvas.height), painter.sample,
      painter.moving ? painter.motion_scale : 1);
  if (painter.nodes > 0) document.documentElement.dataset.pictures = ++painter.pictures;
  if (painter.moving) return;
  if (++painter.sample < scene.samples) {
    next_picture();
  } else if (painter.nodes === wanted) {
    document.documentElement.dataset.drawn = painter.pictures;
    write_link();
  }
}

// Brings nodes and colours of the frame to the scene; the latest wish wins.
let wanted = 0;
async function show_nodes() {
  const wish = ++wanted;
  const [xyz, list] = await Promise.all([positions_of(state.frame), shades_of_nodes()]);
  if (wish !== wanted || !scene) return;
  scene.set_nodes(xyz, list);
  painter.nodes = wish;
  redraw();
}

async function shades_of_nodes() {
  const field = fields[state.field];
  if (field.codes) {
    const table = places(field, state.range, state.log);
    return Float32Array.from(await codes_of(state.field, state.frame), (code) => table[code]);
  }
  const length = field.of(await positions_of(state.frame));
  return length.map((s) => Math.min(1, Math.max(0, place(s, state.range, state.log))));
}

// Draws the wire with WebGL2: every edge is a capsule that the fragment shader meets exactly, so
// nothing is built when the time changes.
const shader = (name) => document.getElementById(name).textContent.trim() + '\n';

function compiled(gl, vertex, fragment) {
  const program = gl.createProgram();
  for (const [kind, name] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const part = gl.createShader(kind);
    gl.shaderSource(part, shader(name));
    gl.compileShader(part);
    gl.attachShader(program, part);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost()) {
    const logs = gl.getAttachedShaders(program).map((part) => gl.getShaderInfoLog(part));
    throw new Error([gl.getProgramInfoLog(program), ...logs].join('\n'));
  }
  return program;
}

// Sets uniforms by name: a number, a truth value, or a list of 2 to 4 numbers, or of 9.
function set_uniforms(gl, program, values) {
  gl.useProgram(program);
  for (const [name, value] of Object.entries(values)) {
    const where = gl.getUniformLocation(program, name);
    if (typeof value === 'boolean') gl.uniform1i(where, value ? 1 : 0);
    else if (typeof value === 'number') gl.uniform1f(where, value);
    else if (value.length === 9) gl.uniformMatrix3fv(where, true, value);
    else gl['uniform' + value.length + 'fv'](where, value);
  }
}

function bind_textures(gl, program, textures) {
  gl.useProgram(program);
  Object.entries(textures).forEach(([name, texture], unit) => {
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.uniform1i(gl.getUniformLocation(program, name), unit);
  });
}

function new_texture(gl, format, width, height, filter) {
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texStorage2D(gl.TEXTURE_2D, 1, format, width, height);
  for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER])
    gl.texParameteri(gl.TEXTURE_2D, name, filter);
  for (const name of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T])
    gl.texParameteri(gl.TEXTURE_2D, name, gl.CLAMP_TO_EDGE);
  return texture;
}

// Buffers of one size: what is seen in each pixel, and the mean of the samples so far.
function new_buffers(gl, width, height, mean_format) {
  const target = (textures) => {
    const frame = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
    textures.forEach(
        ([where, texture]) =>
            gl.framebufferTexture2D(gl.FRAMEBUFFER, where, gl.TEXTURE_2D, texture, 0));
    return frame;
  };
  const colours = new_texture(gl, gl.RGBA8, width, height, gl.NEAREST);
  const normals = new_texture(gl, gl.RGBA8, width, height, gl.NEAREST);
  const depths = new_texture(gl, gl.DEPTH_COMPONENT32F, width, height, gl.NEAREST);
  const mean = new_texture(gl, mean_format, width, height, gl.LINEAR);
  const seen = target([
    [gl.COLOR_ATTACHMENT0, colours], [gl.COLOR_ATTACHMENT1, normals], [gl.DEPTH_ATTACHMENT, depths]
  ]);
  gl.drawBuffers([gl.COLOR_ATTACHMENT0, gl.COLOR_ATTACHMENT1]);
  const sum = target([[gl.COLOR_ATTACHMENT0, mean]]);
  return {
    width, height, colours, normals, depths, mean, seen, sum,
    free() {
      [colours, normals, depths, mean].forEach((t) => gl.deleteTexture(t));
      [seen, sum].forEach((f) => gl.deleteFramebuffer(f));
    },
  };
}

// Places of samples within a pixel, -0.5 ... 0.5: eight that no row or column shares.
const jitters = [[0, 0], [3, -1], [-2, 2], [1, 3.5], [-3.5, -2], [-1, -3], [2, 1], [-3, 3]].map(
    (p) => p.map((c) => c / 8));

function create_scene(canvas) {
  const gl = canvas.getContext(
      'webgl2', {alpha: true, antialias: false, depth: false, powerPreference: 'high-performance'});
  if (!gl) return null;
  const mean_format =
      gl.getExtension('EXT_color_buffer_float') || gl.getExtension('EXT_color_buffer_half_float') ?
      gl.RGBA16F :
      gl.RGBA8;
  const wire = compiled(gl, 'wire.vert', 'wire.frag');
  const light = compiled(gl, 'screen.vert', 'light.frag');
  const blend = compiled(gl, 'screen.vert', 'blend.frag');
  const rows = Math.max(1, ...run.frames.map((frame) => Math.ceil(frame.nodes / 1024)));
  const nodes = new_texture(gl, gl.RGBA32F, 1024, rows, gl.NEAREST);
  const map = new_texture(gl, gl.RGB8, 33, 1, gl.LINEAR);
  gl.bindVertexArray(gl.createVertexArray());
  let buffers = null, node_count = 0;

  function buffers_of(width, height) {
    if (buffers && buffers.width === width && buffers.height === height) return buffers;
    if (buffers) buffers.free();
    buffers = new_buffers(gl, width, height, mean_format);
    return buffers;
  }

  function upload(texture, width, height, format, type, data) {
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, format, type, data);
  }

  function draw_seen(view, b, jitter) {
    gl.bindFramebuffer(gl.FRAMEBUFFER, b.seen);
    gl.viewport(0, 0, b.width, b.height);
    gl.disable(gl.BLEND);
    gl.enable(gl.DEPTH_TEST);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    bind_textures(gl, wire, {nodes, map});
    set_uniforms(gl, wire, {
      turn: view.turn.flat(),
      pan: view.pan,
      half_size: view.half_size,
      jitter,
      radius: wire_radius,
      depth: view.depth,
      plane: view.plane,
      cut: view.cut,
      only_section: view.section,
      none: none_colour,
    });
    if (node_count > 1) gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, node_count - 1);
  }

  function add_lit(view, b, jitter, sample) {
    gl.bindFramebuffer(gl.FRAMEBUFFER, b.sum);
    gl.disable(gl.DEPTH_TEST);
    gl.enable(gl.BLEND);
    gl.blendColor(0, 0, 0, 1 / (sample + 1));
    gl.blendFunc(gl.CONSTANT_ALPHA, gl.ONE_MINUS_CONSTANT_ALPHA);
    bind_textures(gl, light, {colours: b.colours, normals: b.normals, depths: b.depths});
    const pixel = 2 * view.half_size[1] / b.height;
    set_uniforms(gl, light, {
      pan: view.pan,
      half_size: view.half_size,
      jitter,
      depth: view.depth,
      radius: wire_radius,
      cavity: cavity_reach,
      wall: view.wall.flat(),
      pixel,
      line: view.line / pixel,
      sample_turn: 2.4 * sample,
      plane: view.plane,
      cut: view.cut,
      outline: view.outline,
      ink: view.ink,
    });
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  return {
    gl,
    largest:
        Math.min(gl.getParameter(gl.MAX_TEXTURE_SIZE), ...gl.getParameter(gl.MAX_VIEWPORT_DIMS)),
    samples: jitters.length,
    set_nodes(xyz, shades) {
      const n = shades.length, data = new Float32Array(4 * 1024 * Math.ceil(n / 1024));
      for (let i = 0; i < n; ++i) data.set([xyz[i], xyz[n + i], xyz[2 * n + i], shades[i]], 4 * i);
      upload(nodes, 1024, data.length / 4096, gl.RGBA, gl.FLOAT, data);
      node_count = n;
    },
    set_map(bytes) {
      upload(map, 33, 1, gl.RGB, gl.UNSIGNED_BYTE, new Uint8Array(bytes));
    },
    // One more sample of the picture, drawn with `scale` times the canvas' pixels, and the mean
    // shown.
    draw(view, sample, scale) {
      const b = buffers_of(
          Math.max(1, Math.round(canvas.width * scale)),
          Math.max(1, Math.round(canvas.height * scale)));
      const jitter = jitters[sample].map((c, k) => 2 * c / [b.width, b.height][k]);
      draw_seen(view, b, jitter);
      add_lit(view, b, jitter, sample);
      gl.bindFramebuffer(gl.FRAMEBUFFER, null);
      gl.viewport(0, 0, canvas.width, canvas.height);
      gl.disable(gl.BLEND);
      bind_textures(gl, blend, {picture: b.mean});
      gl.drawArrays(gl.TRIANGLES, 0, 3);
    },
  };
}

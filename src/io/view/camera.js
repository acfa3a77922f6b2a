// Rotations from the world to the view as quaternions [w, x, y, z].
function product(p, q) {
  return [
    p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
    p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
    p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1],
    p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0],
  ];
}

function unit(q) {
  const size = Math.hypot(...q);
  return q.map((c) => c / size);
}

function turn_about(axis, angle) {
  const s = Math.sin(angle / 2);
  return [Math.cos(angle / 2), axis[0] * s, axis[1] * s, axis[2] * s];
}

// The matrix of a rotation, row by row.
function matrix([w, x, y, z]) {
  return [
    [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
    [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
    [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
  ];
}

const turned = (rows, v) => rows.map((row) => row[0] * v[0] + row[1] * v[1] + row[2] * v[2]);

// T diag(d) T^t: the quadric d_x x^2 + d_y y^2 + d_z z^2 = 1 as the viewer sees it.
const turned_quadric = (rows, d) => rows.map((row) => turned(rows, row.map((t, k) => t * d[k])));

// The feed axis z points up; y away from the viewer, x to the right.
const along_y = turn_about([1, 0, 0], -Math.PI / 2);
const standard_views = {
  home: product(turn_about([1, 0, 0], 0.35), product(along_y, turn_about([0, 0, 1], 0.5))),
  x: product(along_y, turn_about([0, 0, 1], -Math.PI / 2)),
  y: along_y,
  z: [1, 0, 0, 0],
};

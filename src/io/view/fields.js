// What the wire can be coloured by: the fields of the file, and the arc length.
const wire_radius = run.wire_radius, cavity_reach = Math.max(...run.semi_axes);

// From the tip, which entered first, over the wire's radius.
function arc_lengths(xyz) {
  const n = xyz.length / 3, result = new Float32Array(n);
  for (let i = 1; i < n; ++i) {
    const step = [0, n, 2 * n].map((axis) => xyz[axis + i] - xyz[axis + i - 1]);
    result[i] = result[i - 1] + Math.hypot(...step) / wire_radius;
  }
  return result;
}

const fields = [...run.fields, {
  name: 'arc_length', label: 'arc length from the tip', unit: 'a', logarithmic: false,
  low: 0, high: run.longest, shown: [0, run.longest], of: arc_lengths,
}];

// Colour maps that stay in order of lightness, so that they read without colour vision and in grey:
// viridis and cividis (33 stops of each).
const maps = {
  viridis:
      '440154470d6048186a482374472d7b4537814240863e49893b528b375b8d33638d2f6b8e2c728e' +
      '297a8e26828e23898e21918c1f988b1fa08822a78528ae8032b67a3fbc734ec36b5ec96270cf57' +
      '84d44b98d83eaddc30c2df23d8e219ece51bfde725',
  cividis:
      '00205100265d012b6508316911366c1c3c6e26426e31476e3c4d6e47536d51586e5a5e6e62646f' +
      '6a6a707270717976737f7c758682768c8877938e789a9478a19b78a9a177b2a874bbaf71c5b66d' +
      'cebd68d8c462e2cb5cebd355f3da4ffae249fdea45',
};
const none_colour = [0.62, 0.63, 0.66];  // of nodes where the field is zero

function stops(name) {
  return maps[name].match(/../g).map((byte) => parseInt(byte, 16));
}

function css_gradient(name, direction) {
  const list = maps[name].match(/.{6}/g).map((stop) => '#' + stop);
  return `linear-gradient(${direction}, ${list.join(', ')})`;
}

// Value of a node that has this code; see ByteScale in the program.
function decoded(field, code) {
  const share = (code - 1) / 254;
  return field.logarithmic ? field.low * (field.high / field.low) ** share
    : field.low + (field.high - field.low) * share;
}

// Place in the map of a value, 0 ... 1.
function place(value, range, log) {
  return log ? Math.log(value / range[0]) / Math.log(range[1] / range[0])
    : (value - range[0]) / (range[1] - range[0]);
}

// Places of all codes; -1 for those where there is nothing.
function places(field, range, log) {
  const table = new Float32Array(256);
  for (let code = 1; code < 256; ++code) {
    table[code] = Math.min(1, Math.max(0, place(decoded(field, code), range, log)));
  }
  table[0] = field.logarithmic ? -1 : 0;
  return table;
}

// Round numbers within a range: at most about `most`.
function ticks(low, high, log, most = 5) {
  const result = [];
  if (log) {
    const decades = Math.log10(high / low);
    const digits = decades > 2.5 ? [1] : decades > 1 ? [1, 3] : [1, 2, 5];
    const every = Math.ceil(decades / (most + 1));
    for (let e = Math.floor(Math.log10(low)); e <= Math.log10(high); e += every) {
      for (const d of digits) result.push(d * 10 ** e);
    }
  } else {
    const rough = (high - low) / most, unit = 10 ** Math.floor(Math.log10(rough));
    const step = unit * [1, 2, 5, 10].find((m) => m * unit >= rough * 0.999);
    for (let k = Math.ceil(low / step); k * step <= high * (1 + 1e-9); ++k) result.push(k * step);
  }
  return result.filter((t) => t >= low * (1 - 1e-9) - 1e-12 && t <= high * (1 + 1e-9));
}

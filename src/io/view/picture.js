// The picture as a PNG, with colour bar and moment, of 1 to 4 times the pixels of the screen.
function draw_bar(ink, width, height, size) {
  const field = fields[state.field],
        bar = {x: 18 * size, y: height - 44 * size, width: 260 * size, height: 10 * size};
  const fill = ink.createLinearGradient(bar.x, 0, bar.x + bar.width, 0),
        list = maps[state.map].match(/.{6}/g);
  list.forEach((stop, k) => fill.addColorStop(k / (list.length - 1), '#' + stop));
  const text_colour = ink.fillStyle;
  ink.fillStyle = fill;
  ink.fillRect(bar.x, bar.y, bar.width, bar.height);
  ink.fillStyle = text_colour;
  ink.textAlign = 'left';
  ink.fillText(
      field.label + (field.unit === '1' ? '' : ` [${field.unit}]`), bar.x, bar.y - 8 * size);
  ink.textAlign = 'center';
  for (const {share, text} of bar_ticks()) {
    const x = bar.x + share * bar.width;
    ink.fillRect(x - size / 2, bar.y + bar.height, size, 4 * size);
    ink.fillText(text, x, bar.y + bar.height + 17 * size);
  }
  ink.textAlign = 'right';
  ink.fillText(
      `${run.name} · ${element('moment').textContent}`, width - 18 * size, height - 18 * size);
}

// Draws with all samples at once and gives the picture back as a canvas.
function picture_of(factor, transparent, with_bar) {
  fit_canvas();
  const [width, height] = [canvas.width * factor, canvas.height * factor];
  if (Math.max(width, height) > scene.largest) {
    throw new Error(`this graphics card draws pictures of at most ${
        scene.largest} pixels a side; choose a smaller factor`);
  }
  const shot = document.createElement('canvas');
  Object.assign(shot, {width, height});
  const ink = shot.getContext('2d'), style = getComputedStyle(document.documentElement);
  if (!transparent) {
    ink.fillStyle = style.getPropertyValue('--stage');
    ink.fillRect(0, 0, width, height);
  }
  Object.assign(canvas, {width, height});
  const view = current_view(width, height);
  for (let sample = 0; sample < scene.samples; ++sample) scene.draw(view, sample, 1);
  ink.drawImage(canvas, 0, 0);
  redraw();
  const size = factor * (window.devicePixelRatio || 1);
  ink.fillStyle = style.getPropertyValue('--text');
  ink.font = `${13 * size}px system-ui, sans-serif`;
  if (with_bar) draw_bar(ink, width, height, size);
  return shot;
}

function save_picture() {
  try {
    const shot = picture_of(Number(element('factor').value), element('transparent').checked, true);
    shot.toBlob(
        (blob) => save_file(blob, `${stem()}_${String(state.frame + 1).padStart(3, '0')}.png`),
        'image/png');
    element('status').textContent = `picture of ${shot.width} by ${shot.height} pixels saved`;
  } catch (error) {
    say(error.message);
  }
}

function say(text) {
  element('message').textContent = text;
  element('message').hidden = text === '';
}

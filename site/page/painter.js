// Paints the numbers of a picture: kind, colour, brightness, width, the number of points, and the points.

const [POLYGON, LINE] = [0, 1];
/** How many brightnesses each colour has. */
const SHADES = 12;

/** Fits the pixels of a canvas to its place in the page, and returns its context in CSS pixels. */
export function prepared(canvas, width, height) {
  const ratio = Math.min(window.devicePixelRatio || 1, 2);
  const [across, down] = [Math.round(width * ratio), Math.round(height * ratio)];
  if (canvas.width !== across || canvas.height !== down) {
    canvas.width = across;
    canvas.height = down;
  }
  const context = canvas.getContext("2d");
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  return context;
}

/** Paints a picture into a canvas. */
export function paint(canvas, numbers, colors) {
  const context = prepared(canvas, canvas.clientWidth, canvas.clientHeight);
  context.lineCap = "round";
  context.lineJoin = "round";
  let at = 0;
  while (at < numbers.length) {
    const [kind, tone, shade, width, count] = numbers.subarray(at, at + 5);
    at += 5;
    const color = colors[tone * SHADES + shade];
    context.beginPath();
    if (kind === POLYGON || kind === LINE) {
      context.moveTo(numbers[at], numbers[at + 1]);
      for (let i = 1; i < count; i += 1) {
        context.lineTo(numbers[at + 2 * i], numbers[at + 2 * i + 1]);
      }
    }
    if (kind === POLYGON) {
      context.closePath();
      context.fillStyle = color;
      context.fill();
      // Closes the gaps between neighbours.
      context.lineWidth = 0.7;
      context.strokeStyle = color;
      context.stroke();
    } else if (kind === LINE) {
      context.lineWidth = width;
      context.strokeStyle = color;
      context.stroke();
    } else {
      const [x, y] = [numbers[at], numbers[at + 1]];
      const light = context.createRadialGradient(x - 0.35 * width, y - 0.4 * width, 0.1 * width, x, y, width);
      light.addColorStop(0, colors[tone * SHADES + SHADES - 1]);
      light.addColorStop(1, colors[tone * SHADES + 4]);
      context.arc(x, y, width, 0, 2 * Math.PI);
      context.fillStyle = light;
      context.fill();
    }
    at += 2 * count;
  }
}

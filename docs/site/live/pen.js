// What the C++ draws with (common/app/page_canvas.hpp), on a <canvas>. Colours come as 0xRRGGBBAA, points as numbers in its memory.
import { say } from './words.js';

const sizes = [13, 16, 18, 64]; // px, of Canvas::TextSize
const sprites = new Map();
/** In Japanese a space only says where a line may end. */
const drawn = words => say(words).replace(/([\u3000-\u9fff]) (?=[\u3000-\u9fff])/g, '$1');
const parts = code => [code >>> 24, code >>> 16 & 255, code >>> 8 & 255];

/** In the dark light and dark change places, and every hue stays. */
function darkened([r, g, b]) {
  const high = Math.max(r, g, b), low = Math.min(r, g, b), wanted = 20 + (255 - (high + low) / 2) * 0.86;
  const half = Math.min(high - low, 255 - Math.abs(2 * wanted - 255)) / 2; // as colourful as before, where there is room
  if (high - low < 8) return [wanted - 4, wanted, wanted + 5].map(Math.round); // grey: as the page's
  return [r, g, b].map(c => Math.round(wanted + (high > low ? (2 * (c - low) / (high - low) - 1) * half : 0)));
}

function sprite(code) { // a lit ball, drawn once
  if (sprites.has(code)) return sprites.get(code);
  const picture = Object.assign(document.createElement('canvas'), { width: 128, height: 128 }), g = picture.getContext('2d');
  const light = g.createRadialGradient(42, 38, 4, 64, 64, 64), at = k => `rgb(${parts(code).map(c => c * k | 0)})`;
  for (const [where, share] of [[0, 1], [.7, .72], [.94, .55], [.96, .24], [1, .24]]) light.addColorStop(where, at(share));
  g.fillStyle = light; g.beginPath(); g.arc(64, 64, 63, 0, 7); g.fill();
  sprites.set(code, picture);
  return picture;
}

/** Makes a pen on `ctx` for a module whose memory is `heap()`. pen.dark chooses the colours; pen.grow makes text larger, where the picture is small. */
export const penFor = ctx => heap => {
  const colours = [new Map(), new Map()];
  const colour = code => {
    const known = colours[pen.dark ? 1 : 0];
    code >>>= 0;
    if (!known.has(code)) known.set(code, `rgba(${pen.dark ? darkened(parts(code)) : parts(code)},${(code & 255) / 255})`);
    return known.get(code);
  };
  const short = new Map(); // lines from point to point, of grids and dashes, a thousand: those that look alike are stroked together, before anything else is drawn
  const flush = () => {
    if (!short.size) return;
    for (const { code, width, ends } of short.values()) {
      ctx.beginPath();
      for (let i = 0; i < ends.length; i += 4) { ctx.moveTo(ends[i], ends[i + 1]); ctx.lineTo(ends[i + 2], ends[i + 3]); }
      stroke(code, width);
    }
    short.clear();
  };
  const trace = (at, count) => {
    const numbers = heap();
    flush();
    ctx.beginPath(); ctx.moveTo(numbers[at], numbers[at + 1]);
    for (let i = 1; i < count; ++i) ctx.lineTo(numbers[at + 2 * i], numbers[at + 2 * i + 1]);
  };
  /** A ball is lit in the dark, too: what is filled with its white and bluish grey stays as it is, and so does a shadow. */
  const filling = code => { const [r, g, b] = parts(code); return pen.dark && (!(r | g | b) || b >= r && b > 90 && Math.max(r, g, b) - Math.min(r, g, b) <= 20) ? `rgba(${r},${g},${b},${(code & 255) / 255})` : colour(code); };
  const stroke = (code, width) => { ctx.strokeStyle = colour(code); ctx.lineWidth = width; ctx.stroke(); };
  const fill = code => { ctx.fillStyle = filling(code); ctx.fill(); };
  const font = size => { ctx.font = `${sizes[size] * grow(size)}px system-ui, "DejaVu Sans", "Noto Sans CJK JP", sans-serif`; };
  const grow = size => size === 3 ? 1 : pen.grow;
  const pen = {
    dark: false, grow: 1, colour,
    flush,
    line(at, count, code, width) {
      if (count !== 2) { trace(at, count); stroke(code, width); return; }
      const n = heap(), look = code * 128 + width * 8;
      if (!short.has(look)) short.set(look, { code, width, ends: [] });
      short.get(look).ends.push(n[at], n[at + 1], n[at + 2], n[at + 3]);
    },
    fill(at, count, code) {
      const n = heap(), [x, y, width, height] = [n[at], n[at + 1], n[at + 2] - n[at], n[at + 5] - n[at + 1]];
      const is_rectangle = count === 4 && n[at + 3] === y && n[at + 4] === n[at + 2] && n[at + 6] === x && n[at + 7] === n[at + 5];
      if (!is_rectangle) { trace(at, count); fill(code); return; }
      flush(); ctx.fillStyle = filling(code); ctx.fillRect(x, y, width, height); // a diagram's dots are thousands: no path for each
    },
    circle(x, y, radius, code, width) { flush(); ctx.beginPath(); ctx.arc(x, y, Math.max(0, radius), 0, 2 * Math.PI); if (width) stroke(code, width); else fill(code); },
    ball(x, y, radius, code) { flush(); ctx.drawImage(sprite(code >>> 0), x - radius, y - radius, 2 * radius, 2 * radius); },
    text(x, y, words, code, align, size) {
      if (!pen.grow) return; // too small for words: the page says them
      flush(); font(size); ctx.textAlign = ['left', 'center', 'right'][align]; ctx.textBaseline = 'top'; ctx.fillStyle = colour(code);
      ctx.fillText(drawn(words), x, y + 1 - (grow(size) - 1) * sizes[size] / 2);
    },
    width(words, size) { font(size); return ctx.measureText(drawn(words)).width; },
    say,
    push(x, y, width, height) { flush(); ctx.save(); ctx.beginPath(); ctx.rect(x, y, width, height); ctx.clip(); },
    pop() { flush(); ctx.restore(); },
  };
  return pen;
};

// QR codes for links, by ISO/IEC 18004: bytes, error correction L, versions 1 to 6 (up to 134 bytes).

const DATA = [0, 19, 34, 55, 80, 108, 136], CHECK = [0, 7, 10, 15, 20, 26, 18], BLOCKS = [0, 1, 1, 1, 1, 1, 2];
const EXP = new Uint8Array(512), LOG = new Uint8Array(256);
for (let i = 0, x = 1; i < 255; i++, x = x << 1 ^ (x > 127 ? 0x11d : 0)) { EXP[i] = EXP[i + 255] = x; LOG[x] = i; }

/** Returns the remainder of a block by the generator polynomial: its check bytes. */
function check(data, count) {
  let generator = [1];
  for (let i = 0; i < count; i++) {
    const next = [...generator, 0];
    generator.forEach((g, k) => { if (g) next[k + 1] ^= EXP[LOG[g] + i]; });
    generator = next;
  }
  const rest = [...data, ...new Array(count).fill(0)];
  for (let i = 0; i < data.length; i++) {
    if (rest[i]) for (let k = 1; k <= count; k++) if (generator[k]) rest[i + k] ^= EXP[LOG[generator[k]] + LOG[rest[i]]];
  }
  return rest.slice(data.length);
}

function codewords(bytes, version) {
  const bits = [0, 1, 0, 0];
  const put = (value, n) => { for (let i = n - 1; i >= 0; i--) bits.push(value >> i & 1); };
  put(bytes.length, 8);
  bytes.forEach(b => put(b, 8));
  for (let i = 0; i < 4 && bits.length < 8 * DATA[version]; i++) bits.push(0);
  while (bits.length % 8) bits.push(0);
  const data = [];
  for (let i = 0; i < bits.length; i += 8) data.push(bits.slice(i, i + 8).reduce((a, b) => 2 * a + b, 0));
  for (let pad = 0xec; data.length < DATA[version]; pad ^= 0xec ^ 0x11) data.push(pad);
  const size = data.length / BLOCKS[version], blocks = [];
  for (let i = 0; i < BLOCKS[version]; i++) blocks.push(data.slice(i * size, (i + 1) * size));
  const checks = blocks.map(block => check(block, CHECK[version]));
  const weave = lists => lists[0].flatMap((_, i) => lists.map(list => list[i]));
  return [...weave(blocks), ...weave(checks)];
}

const MASKS = [(x, y) => (x + y) % 2, (x, y) => y % 2, x => x % 3, (x, y) => (x + y) % 3,
  (x, y) => ((y >> 1) + Math.floor(x / 3)) % 2, (x, y) => x * y % 2 + x * y % 3,
  (x, y) => (x * y % 2 + x * y % 3) % 2, (x, y) => ((x + y) % 2 + x * y % 3) % 2];

function draw(words, version, mask) {
  const size = 17 + 4 * version, dark = Array.from({length: size}, () => new Array(size).fill(null));
  const set = (x, y, on) => { if (x >= 0 && y >= 0 && x < size && y < size) dark[y][x] = on; };
  for (const [cx, cy] of [[3, 3], [size - 4, 3], [3, size - 4]]) {
    for (let y = -4; y <= 4; y++) for (let x = -4; x <= 4; x++) {
      const ring = Math.max(Math.abs(x), Math.abs(y));
      set(cx + x, cy + y, ring !== 2 && ring !== 4);
    }
  }
  if (version > 1) {
    const c = size - 7;
    for (let y = -2; y <= 2; y++) for (let x = -2; x <= 2; x++) set(c + x, c + y, Math.max(Math.abs(x), Math.abs(y)) !== 1);
  }
  for (let i = 8; i < size - 8; i++) { set(i, 6, i % 2 === 0); set(6, i, i % 2 === 0); }
  let format = 1 << 3 | mask, rest = format << 10; // error correction L is 01
  for (let i = 14; i >= 10; i--) if (rest >> i & 1) rest ^= 0x537 << i - 10;
  format = (format << 10 | rest) ^ 0x5412;
  for (let i = 0; i < 15; i++) {
    const on = (format >> i & 1) === 1;
    if (i < 6) set(8, i, on); else if (i < 8) set(8, i + 1, on); else if (i === 8) set(7, 8, on); else set(14 - i, 8, on);
    if (i < 8) set(size - 1 - i, 8, on); else set(8, size - 15 + i, on);
  }
  set(8, size - 8, true);
  let bit = 0;
  for (let right = size - 1, up = true; right > 0; right -= 2, up = !up) {
    if (right === 6) right--;
    for (let i = 0; i < size; i++) for (const x of [right, right - 1]) {
      const y = up ? size - 1 - i : i;
      if (dark[y][x] !== null) continue;
      const on = (words[bit >> 3] >> 7 - bit % 8 & 1) === 1;
      dark[y][x] = on !== (MASKS[mask](x, y) === 0);
      bit++;
    }
  }
  return dark;
}

/** Returns how hard a code is to read: long runs and blocks of one colour. */
function penalty(dark) {
  let sum = 0;
  const size = dark.length;
  for (let a = 0; a < size; a++) for (const at of [b => dark[a][b], b => dark[b][a]]) {
    for (let b = 1, run = 1; b <= size; b++) {
      if (b < size && at(b) === at(b - 1)) run++;
      else { sum += run >= 5 ? run - 2 : 0; run = 1; }
    }
  }
  for (let y = 1; y < size; y++) for (let x = 1; x < size; x++) {
    const c = dark[y][x];
    if (c === dark[y][x - 1] && c === dark[y - 1][x] && c === dark[y - 1][x - 1]) sum += 3;
  }
  return sum;
}

/** Returns the rows of a code, true where it is dark; null if the text is too long. */
export function qr(text) {
  const bytes = [...new TextEncoder().encode(text)];
  const version = DATA.findIndex((most, v) => v > 0 && bytes.length <= most - 2);
  if (version < 1) return null;
  const words = codewords(bytes, version);
  const all = MASKS.map((_, mask) => draw(words, version, mask));
  return all.reduce((best, each) => penalty(each) < penalty(best) ? each : best);
}

/** Draws a code with its quiet zone on a canvas. */
export function drawQr(canvas, text) {
  const rows = qr(text);
  canvas.hidden = !rows;
  if (!rows) return;
  const dot = 4, size = (rows.length + 8) * dot, g = canvas.getContext('2d');
  canvas.width = canvas.height = size;
  g.fillStyle = '#fff';
  g.fillRect(0, 0, size, size);
  g.fillStyle = '#000';
  rows.forEach((row, y) => row.forEach((on, x) => { if (on) g.fillRect((x + 4) * dot, (y + 4) * dot, dot, dot); }));
}

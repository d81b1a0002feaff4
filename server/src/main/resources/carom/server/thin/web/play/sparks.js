// Particles that fly for a moment, and the shake of the picture.

const MOST = 1500, NEAR = 12, SHADES = 8;

const between = ([least, most], share) => least + (most - least) * share;

export class Sparks {
  constructor() { this.clear(); }

  clear() {
    this.all = [];
    this.shake = {metres: 0, seconds: 1, age: 0};
  }

  /** Lets a burst fly: `way` is the middle of its cone, `share` its part of the whole, `rgb` the colour of its cause. */
  burst(of, x, y, way, share, rgb) {
    for (let n = Math.max(1, Math.round(of.count * share)); n > 0; n--) this.add(of, x, y, way, 0.5 + 0.5 * share, rgb);
  }

  /** Lets fly what a moving body leaves behind in a picture's time. */
  stream(of, x, y, vx, vy, seconds, rgb) {
    const way = Math.atan2(-vy, -vx);
    for (let n = Math.floor(of.count * Math.min(seconds, 0.1) + Math.random()); n > 0; n--) {
      const ago = seconds * Math.random();
      this.add(of, x - vx * ago, y - vy * ago, way, 1, rgb);
    }
  }

  add(of, x, y, way, hard, rgb) {
    const angle = way + of.spread * (2 * Math.random() - 1), speed = hard * between(of.speed, Math.random());
    if (this.all.length >= MOST) this.all.shift();
    this.all.push({of, x, y, vx: speed * Math.cos(angle), vy: speed * Math.sin(angle), age: 0, life: between(of.seconds, Math.random()), rgb});
  }

  /** Shakes the picture, less the farther its cause is from the middle of it. */
  tremble({metres, seconds}, dx, dy, share) {
    const strength = metres * share / (1 + (dx * dx + dy * dy) / (NEAR * NEAR));
    if (strength >= this.strength()) this.shake = {metres: strength, seconds, age: 0};
  }

  strength() {
    const left = Math.max(0, 1 - this.shake.age / this.shake.seconds);
    return this.shake.metres * left * left;
  }

  /** Returns how far the picture is moved, metres. */
  shift() {
    const s = this.strength(), t = 2 * Math.PI * this.shake.age;
    return [s * Math.sin(13 * t + 1), s * Math.sin(17 * t + 2)];
  }

  fly([gx, gy], seconds) {
    this.shake.age += seconds;
    for (const p of this.all) {
      const kept = 1 / (1 + p.of.drag * seconds);
      p.age += seconds;
      p.vx = (p.vx + p.of.gravity * gx * seconds) * kept;
      p.vy = (p.vy + p.of.gravity * gy * seconds) * kept;
      p.x += p.vx * seconds;
      p.y += p.vy * seconds;
    }
    this.all = this.all.filter(p => p.age < p.life);
  }

  /** Draws what flies, first what covers, then what glows; `picture(file, rgb)` returns the dot or picture in a colour. */
  draw(g, picture) {
    for (const glows of [false, true]) {
      g.globalCompositeOperation = glows ? 'lighter' : 'source-over';
      for (const p of this.all) {
        if (p.of.glows !== glows) continue;
        const over = p.age / p.life, size = Math.max(0, between(p.of.size, over));
        const image = picture(p.of.picture, mix(p.of.rgb < 0 ? p.rgb : p.of.rgb, p.of.rgbAtLast < 0 ? p.rgb : p.of.rgbAtLast, Math.round(over * SHADES) / SHADES));
        if (!image) continue;
        g.globalAlpha = p.of.alpha * (1 - over * over);
        g.drawImage(image, p.x - size, p.y - size, 2 * size, 2 * size);
      }
    }
    g.globalCompositeOperation = 'source-over';
    g.globalAlpha = 1;
  }
}

function mix(a, b, share) {
  let rgb = 0;
  for (const at of [16, 8, 0]) rgb |= Math.round((a >> at & 255) * (1 - share) + (b >> at & 255) * share) << at;
  return rgb;
}

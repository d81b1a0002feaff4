// The look that a game's view declares, from look/GAME/look.json: sprites, backgrounds, and what values they show.
// All of it is data; docs/protocol/THIN.md has the format.

import {hex} from './painter.js';

const CATCH_UP_S = 0.1, MOST_HELD = 2, SPRINGS = 1.5, FADE = 4, MOVES = 0.3, MOST_TINTS = 600, DOT = '';

export class Look {
  /** Returns the look of a game, or null if it has none. */
  static async load(game) {
    const from = `look/${encodeURIComponent(game)}/`;
    try {
      const answer = await fetch(`${from}look.json`);
      return answer.status === 200 ? new Look(from, await answer.json()) : null;
    } catch {
      return null;
    }
  }

  constructor(from, data) {
    Object.assign(this, data);
    this.from = from;
    this.pictures = new Map();
    this.tints = new Map();
    this.tracks = new WeakMap();
    this.sizes = new Map();
    this.patterns = new WeakMap();
    this.ready = new Map(); // kinds whose pictures have all arrived
    const effects = [...Object.values(this.events), ...Object.values(this.blows), Object.values(this.trails)].flat();
    const files = [...this.sprites, ...this.backgrounds].map(s => s.file);
    files.push(...effects.map(e => e.picture), ...this.hud.filter(h => h.kind === 'ICONS').map(h => h.label));
    for (const file of new Set(files.filter(f => f))) {
      const image = new Image();
      image.src = from + file;
      this.pictures.set(file, image);
    }
    this.ofKind = new Map();
    for (const sprite of this.sprites) this.ofKind.set(sprite.archetype, [...this.ofKind.get(sprite.archetype) || [], sprite]);
    this.soundFiles = [...new Set([...effects.flatMap(e => e.files || []), this.music].filter(f => f))];
  }

  /** Returns a picture that has arrived, or null. */
  picture(file) {
    const image = this.pictures.get(file);
    return image?.complete && image.naturalWidth ? image : null;
  }

  /** Returns a picture, or a soft dot for no file, multiplied by a colour, or all of it if `solid`; null if it hasn't arrived. */
  tinted(file, rgb, solid = false) {
    const source = file === DOT ? (this.dot ||= dot()) : this.picture(file);
    if (!source || rgb === 0xffffff && !solid) return source;
    const key = `${file} ${rgb} ${solid}`;
    let made = this.tints.get(key);
    if (!made) {
      if (this.tints.size > MOST_TINTS) this.tints.clear();
      made = document.createElement('canvas');
      made.width = source.naturalWidth || source.width;
      made.height = source.naturalHeight || source.height;
      const g = made.getContext('2d');
      g.drawImage(source, 0, 0);
      g.globalCompositeOperation = solid ? 'source-in' : 'multiply';
      g.fillStyle = hex(rgb);
      g.fillRect(0, 0, made.width, made.height);
      g.globalCompositeOperation = 'destination-in';
      g.drawImage(source, 0, 0);
      this.tints.set(key, made);
    }
    return made;
  }

  /** Returns the sprites of a kind whose pictures have arrived; null for none, so that its shapes show. */
  spritesOf(name) {
    if (this.ready.has(name)) return this.ready.get(name);
    const all = this.ofKind.get(name) || [], arrived = all.filter(s => this.picture(s.file)), shown = arrived.length ? arrived : null;
    if (all.every(s => this.pictures.get(s.file).complete)) this.ready.set(name, shown); // it is asked for each body in each picture
    return shown;
  }

  /** Returns what a look reads of the fields, as a number: 0 for what isn't known. */
  number(world, value, player, body) {
    const id = {match: 0, player, entity: body}[value.scope], told = world.field(value.scope, id, value.field);
    if (told === undefined) return 0;
    switch (value.type) {
      case 'CHOICE': return Math.max(0, value.choices.indexOf(told));
      case 'COUNTDOWN': return Math.max(0, told - world.tick);
      case 'REFERENCE': return told < 0 ? 0 : 1;
      default: return Number(told);
    }
  }

  /** Returns a choice's constant in lower case, or the name of the player that a field means. */
  word(world, value, player, body) {
    const id = {match: 0, player, entity: body}[value.scope], told = world.field(value.scope, id, value.field);
    if (value.type === 'REFERENCE') return world.players.get(told)?.name ?? '';
    return (told ?? value.choices[0]).toLowerCase().replaceAll('_', ' ');
  }

  /** Returns how full a bar of a value is, 0 to 1. */
  share(value, number) {
    return Math.max(0, Math.min(1, value.type === 'COUNT' ? (number - value.least) / (value.most - value.least) : number));
  }

  frame(sprite, number, seconds, metres) {
    if (!sprite.by) {
      const shown = Math.floor(sprite.perSecond * seconds + sprite.perMetre * metres);
      return ((shown % sprite.frames) + sprite.frames) % sprite.frames;
    }
    const type = sprite.by.type, chosen = type === 'COUNT' ? number - sprite.by.least : type === 'RATIO' ? number * sprite.frames : number;
    return Math.max(0, Math.min(sprite.frames - 1, Math.floor(chosen)));
  }

  /** Returns width and height of a sprite, metres; without a size of its own it is as wide as the shapes. */
  sizeOf(sprite, kind) {
    if (sprite.width) return [sprite.width, sprite.height];
    const key = `${sprite.file} ${kind.name}`;
    if (!this.sizes.has(key)) {
      let least = Infinity, most = -Infinity;
      for (const [radius, ...xy] of kind.flat) {
        for (let i = 0; i < xy.length; i += 2) { least = Math.min(least, xy[i] - radius); most = Math.max(most, xy[i] + radius); }
      }
      const image = this.picture(sprite.file);
      this.sizes.set(key, [most - least, (most - least) * image.naturalHeight * sprite.frames / image.naturalWidth]);
    }
    return this.sizes.get(key);
  }

  /** Follows a body: how far it has gone, and where it went last. Call it once a picture. */
  follow(body, [x, y, angle, vx, vy], seconds) {
    let track = this.tracks.get(body);
    if (!track) this.tracks.set(body, track = {x, y, vx, vy, fromX: vx, fromY: vy, metres: 0, way: angle, left: false, struck: false, quiet: 0});
    track.metres += Math.hypot(x - track.x, y - track.y);
    track.x = x;
    track.y = y;
    track.quiet -= seconds;
    if (track.reaction) track.reaction.age += seconds;
    if (Math.hypot(vx, vy) > MOVES) {
      track.way = Math.atan2(vy, vx);
      if (Math.abs(vx) > MOVES) track.left = vx < 0;
    }
    return track;
  }

  /**
   * Returns the blow that a body has got since the last picture, {x, y, size} m/s, or null: its velocity has changed faster
   * than by gravity or steering.
   */
  blow(track, steered, [, , , vx, vy]) {
    const sudden = Math.hypot(vx - track.vx, vy - track.vy) > (steered ? 4.3 : 1);
    if (sudden && !track.struck) Object.assign(track, {struck: true, fromX: track.vx, fromY: track.vy});
    let blow = null;
    if (!sudden && track.struck) {
      track.struck = false;
      const x = vx - track.fromX, y = vy - track.fromY, size = Math.hypot(x, y);
      const loss = Math.hypot(track.fromX, track.fromY) - Math.hypot(vx, vy);
      if (size >= 3.5 && (!steered || loss >= 5) && track.quiet <= 0) {
        track.quiet = 0.12;
        blow = {x: x / size, y: y / size, size};
      }
    }
    track.vx = vx;
    track.vy = vy;
    return blow;
  }

  /** Lets a body react to a blow along (nx, ny): squeezed, lit up, held for a moment. */
  react(effects, body, nx, ny, share) {
    const of = (effects || []).find(e => e.kind === 'REACTION'), track = body && this.tracks.get(body);
    if (of && track) track.reaction = {of, share, nx, ny, x: track.x, y: track.y, age: 0};
  }

  /** Returns how a body is drawn by its reaction: moved, squeezed along a normal, lit up. */
  reactionOf(track, x, y) {
    const r = track?.reaction, none = {dx: 0, dy: 0, squash: 0, flash: 0};
    if (!r) return none;
    const over = r.age / r.of.seconds, back = r.of.hold ? Math.max(0, Math.min(1, 1 - (r.age - r.of.hold) / CATCH_UP_S)) : 0;
    if (over >= 1 && !back) { track.reaction = null; return none; }
    const near = v => Math.max(-MOST_HELD, Math.min(MOST_HELD, v));
    return {
      dx: back * near(r.x - x), dy: back * near(r.y - y), nx: r.nx, ny: r.ny, rgb: r.of.flash,
      squash: over < 1 ? r.of.squash * r.share * Math.exp(-FADE * over) * Math.cos(2 * Math.PI * SPRINGS * over) : 0,
      flash: r.of.flash < 0 ? 0 : Math.max(0, 1 - over),
    };
  }

  /** Returns the way from a place near (x, y), in metres, to where a body there is drawn, for a canvas; null if it is drawn there. */
  bend(reaction, x, y) {
    const {dx, dy, nx, ny, squash} = reaction;
    if (!squash && !dx && !dy) return null;
    const wider = 1 / (1 - squash), less = 1 - squash - wider; // longer across the blow: it keeps its size
    const [a, b, d] = squash ? [wider + less * nx * nx, less * nx * ny, wider + less * ny * ny] : [1, 0, 1];
    return [a, b, b, d, x + dx - a * x - b * y, y + dy - b * x - d * y];
  }

  /**
   * Draws the sprites of a body or piece; `place(g, x, y, angle)` sets the canvas to metres there. `by(value)` reads a value,
   * `aim` is where it aims, `silhouette` draws its shadow.
   */
  paint(g, place, kind, sprites, {x, y, angle}, track, rgb, by, aim, seconds, silhouette) {
    const r = this.reactionOf(track, x, y), wider = 1 / (1 - r.squash), less = 1 - r.squash - wider;
    for (const s of sprites) {
      const [width, height] = this.sizeOf(s, kind);
      const turned = {BODY: angle, UPRIGHT: 0, MOVE: track?.way ?? angle, AIM: aim ?? track?.way ?? angle}[s.turn];
      const flipped = s.flips && (s.turn === 'UPRIGHT' ? !!track?.left : Math.cos(turned) < 0), mirrorX = flipped && s.turn === 'UPRIGHT', mirrorY = flipped && !mirrorX;
      const image = this.tinted(s.file, silhouette ? 0 : s.tint ? multiply(s.rgb, rgb) : s.rgb);
      place(g, x + r.dx, y + r.dy, turned);
      if (r.squash) {
        const nx = r.nx * Math.cos(turned) + r.ny * Math.sin(turned), ny = r.ny * Math.cos(turned) - r.nx * Math.sin(turned);
        g.transform(wider + less * nx * nx, less * nx * ny, less * nx * ny, wider + less * ny * ny, 0, 0);
      }
      if (s.tiled) { this.tile(g, kind, image, width, height); continue; }
      const frame = this.frame(s, s.by ? by(s.by) : 0, seconds, track?.metres ?? 0), w = image.width / s.frames;
      g.scale(mirrorX ? -1 : 1, mirrorY ? 1 : -1); // pictures have y downwards
      g.drawImage(image, frame * w, 0, w, image.height, s.x - width / 2, -s.y - height / 2, width, height);
      if (r.flash && !silhouette) {
        g.globalAlpha = r.flash;
        g.drawImage(this.tinted(s.file, r.rgb, true), frame * w, 0, w, image.height, s.x - width / 2, -s.y - height / 2, width, height);
        g.globalAlpha = 1;
      }
    }
  }

  /** Repeats a picture over the boxes of a kind, from their upper left corners on. */
  tile(g, kind, image, width, height) {
    let pattern = this.patterns.get(image);
    if (!pattern) this.patterns.set(image, pattern = g.createPattern(image, 'repeat'));
    for (const [, ...xy] of kind.flat) {
      const xs = xy.filter((_, i) => i % 2 === 0), ys = xy.filter((_, i) => i % 2), left = Math.min(...xs), top = Math.max(...ys);
      if (xs.length !== 4 || new Set(xs).size !== 2 || new Set(ys).size !== 2) continue;
      pattern.setTransform(new DOMMatrix([width / image.width, 0, 0, -height / image.height, left, top]));
      g.fillStyle = pattern;
      g.fillRect(left, Math.min(...ys), Math.max(...xs) - left, top - Math.min(...ys));
    }
  }

  /** Draws the backgrounds around the camera's middle on a canvas in pixels, in whole ones, so that no seam shows; returns false if none has arrived. */
  drawBackgrounds(g, [scale, , , , originX, originY], camera, viewWidth, seconds) {
    let drawn = false;
    for (const b of this.backgrounds) {
      const image = this.picture(b.file);
      if (!image) continue;
      drawn = true;
      const height = b.height, width = height * image.naturalWidth / image.naturalHeight;
      const lagX = camera.x * (1 - b.parallax) + b.driftX * seconds, lagY = camera.y * (1 - b.parallax) + b.driftY * seconds;
      const left = camera.x - viewWidth / 2, bottom = camera.y - camera.height / 2;
      const stands = b.bottom !== undefined, fromY = stands ? b.bottom + lagY : lagY + Math.floor((bottom - lagY) / height) * height;
      g.globalAlpha = b.alpha;
      for (let y = fromY; y < bottom + camera.height; y += height) {
        for (let x = lagX + Math.floor((left - lagX) / width) * width; x < left + viewWidth; x += width) {
          const px = Math.floor(originX + scale * x), py = Math.floor(originY - scale * (y + height));
          g.drawImage(image, px, py, Math.ceil(originX + scale * (x + width)) - px, Math.ceil(originY - scale * y) - py);
        }
        if (stands) break;
      }
    }
    g.globalAlpha = 1;
    return drawn;
  }
}

function multiply(a, b) {
  let rgb = 0;
  for (const at of [16, 8, 0]) rgb |= Math.round((a >> at & 255) * (b >> at & 255) / 255) << at;
  return rgb;
}

function dot() {
  const made = document.createElement('canvas'), g = (made.width = made.height = 32, made.getContext('2d'));
  const soft = g.createRadialGradient(16, 16, 0, 16, 16, 16);
  soft.addColorStop(0, '#ffff');
  soft.addColorStop(0.5, '#fffb');
  soft.addColorStop(1, '#fff0');
  g.fillStyle = soft;
  g.fillRect(0, 0, 32, 32);
  return made;
}

// The room on a canvas: pictures come in, the newest two are blended, and a camera looks at them.

import {hex, outline} from './painter.js';

const BODY = 4, JOINT = 7, CELL = 5, CONTACT = 5, POOL = 3, HEAD = 8, AWAKE = 0x80000000;
const PLAIN_GROUND = 0x3d5a80; // of statics whose level gives them no colour

/** Width of the dot in a player's colour before its name, in pixels. */
const MARK = 6;

/** Reads the numbers of a picture; see PictureBytes. */
function read(buffer) {
  const ints = new Int32Array(buffer), floats = new Float32Array(buffer);
  const [tick, bodies, joints, cells, contacts, priorities, players, pools] = ints;
  const picture = {tick, index: new Map(), pools: [], slot: [], awake: [], pose: new Float32Array(3 * bodies), bodyOf: new Map()};
  let at = HEAD;
  for (let i = 0; i < bodies; i++, at += BODY) {
    const slot = ints[at] & 0x7fffffff;
    picture.index.set(slot, i);
    picture.slot.push(slot);
    picture.awake.push((ints[at] & AWAKE) !== 0);
    picture.pose.set(floats.subarray(at + 1, at + BODY), 3 * i);
  }
  const take = (count, size) => floats.subarray(at, at += count * size);
  picture.joints = take(joints, JOINT);
  picture.cells = take(cells, CELL);
  picture.contacts = take(contacts, CONTACT);
  picture.priorities = take(priorities, 1);
  for (let i = 0; i < players; i++, at += 2) picture.bodyOf.set(ints[at], ints[at + 1]);
  for (let i = 0; i < pools; i++) {
    const [rgb, count] = [ints[at], ints[at + 2]], spacing = floats[at + 1];
    at += POOL;
    picture.pools.push({rgb, spacing, xy: take(count, 2)});
  }
  return picture;
}

const TEAM_HUES = [4, 214, 128, 45, 280, 180]; // red, blue, green, yellow, purple, cyan

/** Half the least size of a player's body on the screen, in pixels; a smaller one is a dot of this size. */
const DOT = 5;

/** Metres from a player's middle to its edge, about; only tells when a body is smaller than a dot. */
const PLAYER_RADIUS = 0.6;

export class Scene {
  constructor(canvas, onPick) {
    this.canvas = canvas;
    this.onPick = onPick;
    this.camera = {x: 0, y: 0, scale: 20};
    this.show = {names: true, joints: true, sleeping: false, contacts: false, cells: false, priority: false};
    this.names = new Map();
    this.teams = new Map();
    this.chosen = new Map(); // colours that players chose, by id
    this.follow = null;
    this.frames = 0;
    this.reset();
    this.listen();
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.colours = null);
    const frame = () => { this.draw(); requestAnimationFrame(frame); };
    requestAnimationFrame(frame);
  }

  /** Forgets the room. */
  reset() {
    this.looks = new Map();
    this.now = this.before = this.picked = this.bounds = null;
  }

  /** Begins with a match: `bounds` is [minX, minY, maxX, maxY]. */
  begin(bounds) {
    this.reset();
    this.bounds = bounds;
    this.fit();
  }

  /** Shows the whole level, also when the window's size changes, until the camera is moved. */
  fit() {
    this.fitted = true;
    if (!this.bounds) return;
    const [minX, minY, maxX, maxY] = this.bounds;
    this.camera.x = (minX + maxX) / 2;
    this.camera.y = (minY + maxY) / 2;
    this.camera.scale = 0.94 * Math.min(this.canvas.clientWidth / (maxX - minX), this.canvas.clientHeight / (maxY - minY));
  }

  /** Returns a player's colour: that of its team; without one what the player chose, or else one that others don't have. */
  playerColour(id) {
    const team = this.teams.get(id);
    if (!team && this.chosen.has(id)) return this.chosen.get(id);
    const hue = team ? TEAM_HUES[(team - 1) % TEAM_HUES.length] : (id * 137.5) % 360;
    return `hsl(${hue} 65% 52%)`;
  }

  learn(bodies) {
    for (const look of bodies) this.looks.set(look.slot, Object.assign(look, outline(look.parts)));
  }

  take(buffer) {
    this.before = this.now;
    this.beforeMs = this.nowMs;
    this.now = read(buffer);
    this.nowMs = performance.now();
  }

  /** Returns where a body is shown: between the newest two pictures, one picture late. */
  pose(slot) {
    const i = this.now.index.get(slot);
    if (i === undefined) return null;
    const to = this.now.pose.subarray(3 * i, 3 * i + 3);
    const k = this.before ? this.before.index.get(slot) : undefined;
    if (k === undefined) return to;
    const from = this.before.pose.subarray(3 * k, 3 * k + 3);
    const far = Math.hypot(to[0] - from[0], to[1] - from[1]) > 8; // a teleport
    const part = far ? 1 : Math.min(1, (performance.now() - this.nowMs) / Math.max(20, this.nowMs - this.beforeMs));
    const turn = Math.atan2(Math.sin(to[2] - from[2]), Math.cos(to[2] - from[2]));
    return [from[0] + part * (to[0] - from[0]), from[1] + part * (to[1] - from[1]), from[2] + part * turn];
  }

  toWorld(px, py) {
    return [this.camera.x + (px - this.canvas.clientWidth / 2) / this.camera.scale,
      this.camera.y - (py - this.canvas.clientHeight / 2) / this.camera.scale];
  }

  toScreen(x, y) {
    return [(x - this.camera.x) * this.camera.scale + this.canvas.clientWidth / 2,
      (this.camera.y - y) * this.camera.scale + this.canvas.clientHeight / 2];
  }

  zoom(factor, px, py) {
    this.fitted = false;
    const [x, y] = this.toWorld(px, py);
    this.camera.scale = Math.max(0.5, Math.min(400, this.camera.scale * factor));
    const [nx, ny] = this.toWorld(px, py);
    this.camera.x += x - nx;
    this.camera.y += y - ny;
  }

  listen() {
    const pointers = new Map();
    let moved = 0;
    const c = this.canvas;
    c.addEventListener('pointerdown', e => { c.setPointerCapture(e.pointerId); pointers.set(e.pointerId, e); moved = 0; });
    c.addEventListener('pointermove', e => {
      const last = pointers.get(e.pointerId);
      if (!last) return;
      const dx = e.offsetX - last.offsetX, dy = e.offsetY - last.offsetY;
      moved += Math.abs(dx) + Math.abs(dy);
      if (pointers.size === 2) {
        const other = [...pointers.values()].find(p => p.pointerId !== e.pointerId);
        const distance = p => Math.hypot(p.offsetX - other.offsetX, p.offsetY - other.offsetY);
        this.zoom(distance(e) / Math.max(1, distance(last)), other.offsetX, other.offsetY);
      } else if (moved > 4) {
        this.follow = null;
        this.fitted = false;
        this.camera.x -= dx / this.camera.scale;
        this.camera.y += dy / this.camera.scale;
        this.onPick(undefined);
      }
      pointers.set(e.pointerId, e);
    });
    c.addEventListener('pointerup', e => { if (pointers.delete(e.pointerId) && moved <= 4) this.pick(e.offsetX, e.offsetY); });
    c.addEventListener('pointercancel', e => pointers.delete(e.pointerId));
    c.addEventListener('wheel', e => { e.preventDefault(); this.zoom(Math.exp(-e.deltaY / 400), e.offsetX, e.offsetY); }, {passive: false});
    c.addEventListener('keydown', e => {
      const step = 40 / this.camera.scale;
      const moves = {ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, step], ArrowDown: [0, -step]};
      if (moves[e.key]) { this.fitted = false; this.camera.x += moves[e.key][0]; this.camera.y += moves[e.key][1]; e.preventDefault(); }
      if (e.key === '+' || e.key === '-') this.zoom(e.key === '+' ? 1.25 : 0.8, c.clientWidth / 2, c.clientHeight / 2);
    });
  }

  /** Tells which body is under a point of the canvas. */
  pick(px, py) {
    if (!this.now) return;
    const [x, y] = this.toWorld(px, py);
    const g = this.canvas.getContext('2d');
    this.picked = null;
    for (const slot of this.now.slot) {
      const look = this.looks.get(slot), pose = this.pose(slot);
      if (!look || look.sensor || look.thin) continue;
      const cos = Math.cos(pose[2]), sin = Math.sin(pose[2]), dx = x - pose[0], dy = y - pose[1];
      g.setTransform(1, 0, 0, 1, 0, 0);
      if (g.isPointInPath(look.path, cos * dx + sin * dy, cos * dy - sin * dx)) this.picked = slot;
    }
    this.onPick(this.picked === null ? null : this.looks.get(this.picked));
  }

  palette() {
    if (!this.colours) {
      const style = getComputedStyle(document.documentElement);
      this.colours = {};
      for (const name of ['ground', 'edge', 'text', 'panel', 'accent', 'quiet', 'line', 'c1', 'c2', 'c3', 'c4', 'c6']) {
        this.colours[name] = style.getPropertyValue('--' + name).trim();
      }
    }
    return this.colours;
  }

  draw() {
    const c = this.canvas, g = c.getContext('2d'), ratio = window.devicePixelRatio || 1;
    const width = Math.round(c.clientWidth * ratio), height = Math.round(c.clientHeight * ratio);
    if (c.width !== width || c.height !== height) {
      c.width = width;
      c.height = height;
      if (this.fitted) this.fit();
    }
    g.setTransform(1, 0, 0, 1, 0, 0);
    g.clearRect(0, 0, width, height);
    const colours = this.palette();
    if (!this.now) return;
    const followed = this.follow === null ? undefined : this.now.bodyOf.get(this.follow);
    const place = followed === undefined ? null : this.pose(followed);
    if (place) { this.fitted = false; this.camera.x = place[0]; this.camera.y = place[1]; }
    const s = this.camera.scale * ratio;
    this.view = [s, 0, 0, -s, width / 2 - s * this.camera.x, height / 2 + s * this.camera.y];
    g.setTransform(...this.view);
    g.lineWidth = 1.2 / this.camera.scale;
    if (this.bounds) {
      const [minX, minY, maxX, maxY] = this.bounds;
      g.strokeStyle = colours.line;
      g.strokeRect(minX, minY, maxX - minX, maxY - minY);
    }
    for (const pool of this.now.pools) this.particles(g, pool);
    const most = this.now.priorities.reduce((a, b) => Math.max(a, b), 0);
    for (const pass of [0, 1, 2]) {
      for (let i = 0; i < this.now.slot.length; i++) {
        const look = this.looks.get(this.now.slot[i]);
        if (look && pass === (look.sensor ? 0 : look.type === 'static' ? 1 : 2)) this.body(g, look, i, colours, most);
      }
    }
    g.setTransform(...this.view);
    if (this.show.cells) this.cells(g);
    if (this.show.joints) this.joints(g, colours);
    if (this.show.contacts) this.contacts(g, colours);
    g.setTransform(ratio, 0, 0, ratio, 0, 0);
    if (this.show.names) this.labels(g, colours);
    this.frames++;
  }

  body(g, look, i, colours, most) {
    const [x, y, angle] = this.pose(look.slot);
    const v = this.view, cos = Math.cos(angle) * v[0], sin = Math.sin(angle) * v[0];
    g.setTransform(cos, -sin, -sin, -cos, v[4] + v[0] * x, v[5] - v[0] * y);
    const asleep = this.show.sleeping && look.type !== 'static' && !this.now.awake[i];
    const owned = look.owner >= 0;
    g.fillStyle = look.type === 'static' ? colours.ground
      : owned ? this.playerColour(look.owner) : hex(look.rgb);
    if (this.show.priority && this.now.priorities.length && look.type !== 'static') {
      const part = most > 0 ? Math.sqrt(this.now.priorities[i] / most) : 0;
      g.fillStyle = `hsl(${220 - 220 * part} 80% ${70 - 20 * part}%)`;
    }
    g.globalAlpha = look.sensor ? 0.12 : asleep ? 0.3 : 1;
    if (owned && !look.sensor && PLAYER_RADIUS * this.camera.scale < DOT) {
      g.beginPath(); g.arc(0, 0, DOT / this.camera.scale, 0, 2 * Math.PI); g.fill();
    }
    if (!look.thin) g.fill(look.path);
    g.globalAlpha = look.sensor ? 0.4 : 1;
    const rim = owned && !look.sensor && this.teams.has(look.owner) && this.chosen.get(look.owner);
    const painted = look.thin && look.type === 'static' && look.rgb !== PLAIN_GROUND;
    g.strokeStyle = look.slot === this.picked ? colours.accent : painted ? hex(look.rgb)
      : rim ? rim : asleep ? colours.quiet : colours.edge;
    g.lineWidth = (look.slot === this.picked ? 3 : rim ? 2.5 : look.thin ? 2 : 1) / this.camera.scale;
    if (asleep) g.setLineDash([4 / this.camera.scale, 3 / this.camera.scale]);
    g.stroke(look.path);
    g.setLineDash([]);
    g.globalAlpha = 1;
  }

  particles(g, {rgb, spacing, xy}) {
    const size = 1.1 * spacing;
    g.fillStyle = hex(rgb);
    g.globalAlpha = 0.75;
    for (let i = 0; i < xy.length; i += 2) g.fillRect(xy[i] - size / 2, xy[i + 1] - size / 2, size, size);
    g.globalAlpha = 1;
  }

  cells(g) {
    for (let i = 0; i < this.now.cells.length; i += CELL) {
      const [minX, minY, maxX, maxY, depth] = this.now.cells.subarray(i, i + CELL);
      g.strokeStyle = `hsl(${(depth * 47) % 360} 80% 50% / 0.7)`;
      g.lineWidth = Math.max(0.6, 3 - depth * 0.35) / this.camera.scale;
      g.strokeRect(minX, minY, maxX - minX, maxY - minY);
    }
  }

  joints(g, colours) {
    g.lineWidth = Math.min(2 / this.camera.scale, 0.05);
    g.strokeStyle = g.fillStyle = colours.c4;
    const dot = Math.min(3 / this.camera.scale, 0.08);
    for (let i = 0; i < this.now.joints.length; i += JOINT) {
      const [, a, b, ax, ay, bx, by] = this.now.joints.subarray(i, i + JOINT);
      g.globalAlpha = 0.5;
      g.beginPath();
      const from = this.now.index.has(a) ? this.pose(a) : null, to = this.now.index.has(b) ? this.pose(b) : null;
      if (from) g.moveTo(from[0], from[1]); else g.moveTo(ax, ay);
      g.lineTo(ax, ay); g.lineTo(bx, by);
      if (to && this.looks.get(b)?.type !== 'static') g.lineTo(to[0], to[1]);
      g.stroke();
      g.globalAlpha = 1;
      g.beginPath(); g.arc(ax, ay, dot, 0, 7); g.arc(bx, by, dot, 0, 7); g.fill();
    }
  }

  contacts(g, colours) {
    g.fillStyle = g.strokeStyle = colours.c6;
    g.lineWidth = 1.5 / this.camera.scale;
    for (let i = 0; i < this.now.contacts.length; i += CONTACT) {
      const [x, y, nx, ny, impulse] = this.now.contacts.subarray(i, i + CONTACT);
      const length = 0.1 + 0.15 * Math.log1p(impulse);
      g.beginPath(); g.arc(x, y, Math.min(3 / this.camera.scale, 0.1), 0, 7); g.fill();
      g.beginPath(); g.moveTo(x, y); g.lineTo(x + nx * length, y + ny * length); g.stroke();
    }
  }

  /** Writes the players' names, the followed one's first; a name that another covers is left out. */
  labels(g, colours) {
    const taken = [];
    g.font = '600 12px system-ui, sans-serif';
    g.textAlign = 'center';
    g.textBaseline = 'bottom';
    g.lineWidth = 3;
    g.lineJoin = 'round';
    const order = [...this.now.bodyOf].sort(([a], [b]) => (b === this.follow) - (a === this.follow) || a - b);
    for (const [id, slot] of order) {
      const pose = this.pose(slot), name = this.names.get(id);
      if (!pose || !name) continue;
      const [x, y] = this.toScreen(pose[0], pose[1]);
      const above = Math.max(10, 0.8 * this.camera.scale);
      const half = g.measureText(name).width / 2 + MARK;
      if (taken.some(at => Math.abs(at.x - x) < at.half + half && Math.abs(at.y - y + above) < 13)) continue;
      taken.push({x, y: y - above, half});
      g.strokeStyle = colours.panel;
      g.fillStyle = id === this.follow ? colours.accent : colours.text;
      g.strokeText(name, x + MARK, y - above);
      g.fillText(name, x + MARK, y - above);
      g.beginPath();
      g.arc(x - half + MARK / 2, y - above - 7, MARK / 2 + 1, 0, 2 * Math.PI);
      g.stroke();
      g.fillStyle = this.playerColour(id);
      g.fill();
    }
  }
}

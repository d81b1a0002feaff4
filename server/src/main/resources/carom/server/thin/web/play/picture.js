// The picture of a match: a camera, the level, bodies where they are shown, names, and what flashes.

import {Sparks} from './sparks.js';
import {EDGE, details, extent, eyes, hex, outline, shade} from './painter.js';

const GRID = 2, SHADOW = [0.1, -0.14], RING_S = 0.45, LABEL_S = 1.1, RISE = 1.6, FOLLOW = 6, EMOTE_MS = 2500;
const WHOLE_HEIGHT = 30, FOLLOW_HEIGHT = 16, FOLLOW_WIDTH = 13, MARGIN = 0.6, LEAST_PIXELS = 14, AROUND_ALL = 4, ZOOM = 2.5, HARD_BLOW = 20, LEAST_SHARE = 0.2, TRAIL_FROM = 0.5, MINIMAP = 190, TURF = 0.35, SOIL = 1.4, BELOW = 60, STREAK_FROM = 10.5, STREAK_FULL = 20, STREAK_S = 0.11;

/** Returns the ground under the lines of a chain whose front is above, in strata: a path and its colour each. */
function strata({x, y, angle, kind}, bottom) {
  const cos = Math.cos(angle), sin = Math.sin(angle), at = (px, py) => [x + cos * px - sin * py, y + sin * px + cos * py];
  return [[0, TURF, 1.1], [TURF, SOIL, 0.8], [SOIL, Infinity, 0.62]].map(([from, to, light]) => {
    const path = new Path2D();
    for (const [, ...xy] of kind.flat) {
      const [x1, y1] = at(xy[0], xy[1]), [x0, y0] = at(xy[2], xy[3]); // a line runs with its front right
      if (x1 <= x0) continue;
      path.moveTo(x0, y0 - from);
      path.lineTo(x1, y1 - from);
      path.lineTo(x1, Math.max(bottom, y1 - to));
      path.lineTo(x0, Math.max(bottom, y0 - to));
      path.closePath();
    }
    return [path, shade(kind.rgb, light)];
  });
}

export class Picture {
  constructor(canvas, world) {
    this.canvas = canvas;
    this.world = world;
    this.flashes = [];
    this.emotes = new Map();
    this.look = null;
    this.sparks = new Sparks();
    this.placed = this.place.bind(this);
    this.map = document.createElement('canvas'); // the ground of the minimap
    this.camera = {x: 0, y: 0, height: 20, placed: false};
  }

  /** Begins with a match: builds the outlines once. */
  begin(match) {
    const drawn = kind => ({...kind, flat: kind.parts.map(p => [p.radius, ...p.corners])});
    const ready = kind => Object.assign(kind, outline(kind.flat), {size: kind.flat.length ? extent(kind.flat[0]) : 0.4});
    this.kinds = match.archetypes.map(drawn).map(ready);
    this.ground = match.ground.map(g => ({...g, kind: ready(drawn(g.kind))}));
    this.strata = this.ground.filter(e => e.kind.thin && e.kind.flat.length > 1 && e.kind.look !== 'PLAIN').flatMap(e => strata(e, match.bounds[1] - BELOW));
    this.flashes = [];
    this.emotes.clear();
    this.sparks.clear();
    this.drawMap(match);
    this.camera.placed = false;
  }

  /** Lets a kind of event be seen at its place. */
  flash(kind, event, nowMs) {
    const share = kind.fullStrength ? Math.max(LEAST_SHARE, Math.min(1, event.strength / kind.fullStrength)) : 1;
    const replaced = this.setOff(this.look?.events[kind.name], event.x, event.y, Math.PI / 2, share, kind.rgb);
    this.look?.react(this.look.events[kind.name], this.world.bodies.get(event.first), 0, 1, share);
    if (kind.radius > 0 || kind.label) this.flashes.push({look: replaced ? {...kind, radius: 0} : kind, x: event.x, y: event.y, ms: nowMs});
  }

  /** Sets off what is seen of some effects; returns whether there are particles, which take the place of the usual. */
  setOff(effects, x, y, way, share, rgb) {
    let flies = false;
    for (const effect of effects || []) {
      if (effect.kind === 'PARTICLES') { this.sparks.burst(effect, x, y, way, share, rgb); flies = true; }
      if (effect.kind === 'SHAKE') this.sparks.tremble(effect, x - this.camera.x, y - this.camera.y, share);
    }
    return flies;
  }

  emote(player, text, nowMs) { this.emotes.set(player, {text, ms: nowMs}); }

  toWorld(px, py) {
    const c = this.camera, scale = this.canvas.clientHeight / c.height;
    return [c.x + (px - this.canvas.clientWidth / 2) / scale, c.y - (py - this.canvas.clientHeight / 2) / scale];
  }

  toScreen(x, y) {
    const c = this.camera, scale = this.canvas.clientHeight / c.height;
    return [(x - c.x) * scale + this.canvas.clientWidth / 2, (c.y - y) * scale + this.canvas.clientHeight / 2];
  }

  /**
   * Shows the whole level if that is readable, or follows the own body up to the level's edges, as the game's look says. `all`
   * are the places of all players, `other` says whether the look's other height holds.
   */
  follow(own, all, other, seconds) {
    const [minX, minY, maxX, maxY] = this.world.match.bounds, c = this.camera;
    const width = maxX - minX + 2 * MARGIN, height = maxY - minY + 2 * MARGIN;
    const aspect = this.canvas.clientWidth / this.canvas.clientHeight, whole = Math.max(height, width / aspect);
    const readable = this.canvas.clientHeight / whole >= LEAST_PIXELS;
    const follows = own || c.placed, wanted = this.look?.camera, least = wanted && (other ? wanted.otherHeight : wanted.height);
    const zone = own && this.world.match.zones.find(z => wanted?.zones.includes(z.name) && z.minX <= own[0] && own[0] <= z.maxX && z.minY <= own[1] && own[1] <= z.maxY);
    let near = !follows || whole <= WHOLE_HEIGHT && readable ? whole : Math.min(height, Math.max(FOLLOW_HEIGHT, FOLLOW_WIDTH / aspect)), zoom = 1;
    const fits = (left, right, low, high) => {
      near = Math.min(whole, Math.max(least, FOLLOW_WIDTH / aspect, high - low, (right - left) / aspect));
      own = [(left + right) / 2, (low + high) / 2];
    };
    if (own && wanted?.lead) own = [own[0] + own[3] * wanted.lead, own[1] + own[4] * wanted.lead];
    if (zone) {
      fits(zone.minX, zone.maxX, zone.minY, zone.maxY);
    } else if (follows && wanted?.all && own) {
      const xs = all.map(p => p[0]), ys = all.map(p => p[1]);
      fits(Math.min(...xs) - AROUND_ALL, Math.max(...xs) + AROUND_ALL, Math.min(...ys) - AROUND_ALL, Math.max(...ys) + AROUND_ALL);
    } else if (follows && least) {
      near = Math.min(whole, Math.max(least, FOLLOW_WIDTH / aspect));
    }
    if (c.placed && (wanted?.all || wanted?.zones.length || wanted?.condition)) zoom = 1 - Math.exp(-ZOOM * seconds);
    c.height += (near - c.height) * zoom;
    const midX = (minX + maxX) / 2, midY = (minY + maxY) / 2;
    const slackX = Math.max(0, (width - c.height * aspect) / 2), slackY = Math.max(0, (height - c.height) / 2);
    const clamp = (v, mid, slack) => Math.max(mid - slack, Math.min(mid + slack, v));
    const goalX = clamp(own ? own[0] : c.placed ? c.x : midX, midX, slackX), goalY = clamp(own ? own[1] : c.placed ? c.y : midY, midY, slackY);
    const step = c.placed ? 1 - Math.exp(-FOLLOW * seconds) : 1;
    c.x += (goalX - c.x) * step;
    c.y += (goalY - c.y) * step;
    c.placed ||= !!own;
  }

  /** Draws the moment of a tick; `aim` turns the own eyes. */
  draw(tick, nowMs, seconds, aim) {
    const canvas = this.canvas, g = canvas.getContext('2d', {alpha: false}), ratio = Math.min(2, devicePixelRatio || 1), world = this.world;
    const width = Math.round(canvas.clientWidth * ratio), height = Math.round(canvas.clientHeight * ratio);
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, {width, height});
    const match = world.match;
    g.setTransform(1, 0, 0, 1, 0, 0);
    const sky = g.createLinearGradient(0, 0, 0, height);
    sky.addColorStop(0, match ? hex(match.theme.sky) : '#16202c');
    sky.addColorStop(1, match ? hex(match.theme.background) : '#0c1017');
    g.fillStyle = sky;
    g.fillRect(0, 0, width, height);
    if (!match) return;
    const shown = [...world.shown(tick)].map(body => ({body, kind: this.kinds[body.archetype], pose: world.pose(body, tick)})).filter(d => d.kind);
    const own = shown.find(d => d.body === world.own);
    this.ownPose = own?.pose;
    const look = this.look, players = shown.filter(d => d.kind.look === 'PLAYER' && d.body.owner >= 0 && d.body.owner < 1024);
    this.dots = own && !players.includes(own) ? [...players, own] : players;
    this.marked = shown.filter(d => look?.marks?.includes(d.kind.name));
    const other = look?.camera.condition && own && look.number(world, look.camera.condition, match.player, own.body.id);
    this.follow(own?.pose, players.map(d => d.pose), other, seconds);
    const s = height / this.camera.height, [shiftX, shiftY] = this.sparks.shift(), time = nowMs / 1000;
    this.view = [s, 0, 0, -s, width / 2 - s * (this.camera.x + shiftX), height / 2 + s * (this.camera.y + shiftY)];
    for (const d of shown) this.dress(d, seconds);
    for (const e of this.ground) e.sprites = look?.spritesOf(e.kind.name);
    const hasGrid = !look?.drawBackgrounds(g, this.view, this.camera, width / s, time);
    g.setTransform(...this.view);
    this.backdrop(g, match, hasGrid);
    for (const [path, colour] of this.strata) { g.fillStyle = colour; g.fill(path); }
    g.fillStyle = 'rgb(0 0 0 / .28)';
    for (const e of this.ground) if (!e.kind.thin && !e.kind.sensor && !e.sprites) { this.place(g, e.x + SHADOW[0], e.y + SHADOW[1], e.angle); g.fill(e.kind.path); }
    for (const d of shown) if (!d.kind.thin && !d.kind.sensor && !d.sprites) { this.place(g, d.pose[0] + SHADOW[0], d.pose[1] + SHADOW[1], d.pose[2]); g.fill(d.kind.path); }
    g.globalAlpha = 0.28;
    for (const d of shown) if (d.sprites) this.sprites(g, d, d === own ? aim : null, time, true);
    g.globalAlpha = 1;
    for (const e of this.ground) {
      if (e.sprites) look.paint(g, this.placed, e.kind, e.sprites, e, null, e.kind.rgb, () => 0, null, time, false);
      else this.body(g, e.kind, e.kind.rgb, e.x, e.y, e.angle, time);
    }
    g.setTransform(...this.view);
    for (const d of shown) if (!look?.trails[d.kind.name]) this.streak(g, d);
    for (const d of shown) {
      if (d.sprites) { this.sprites(g, d, d === own ? aim : null, time, false); continue; }
      const [x, y, angle] = d.pose, r = d.track?.reaction && this.look.reactionOf(d.track, x, y);
      this.bend = r && this.look.bend(r, x, y);
      this.body(g, d.kind, this.colour(d), x, y, angle, time);
      if (d.kind.look === 'PLAYER') this.face(g, d, d === own, aim, time);
      if (r?.flash) this.lightUp(g, d.kind, r, x, y, angle);
      this.bend = null;
    }
    g.setTransform(...this.view);
    this.joints(g, shown);
    this.rings(g, nowMs);
    this.sparks.fly(match.gravity, seconds);
    if (look) this.sparks.draw(g, (file, rgb) => look.tinted(file, rgb));
    g.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.labels(g, shown, own, nowMs);
  }

  /** Returns whether all of the level is in the picture. */
  showsAll() {
    const [minX, minY, maxX, maxY] = this.world.match.bounds, c = this.camera;
    return maxY - minY <= c.height && maxX - minX <= c.height * this.canvas.clientWidth / this.canvas.clientHeight;
  }

  /** Draws the ground of the minimap, once for a match. */
  drawMap({bounds: [minX, minY, maxX, maxY]}) {
    const scale = this.mapScale = MINIMAP / Math.max(maxX - minX, maxY - minY), g = this.map.getContext('2d');
    Object.assign(this.map, {width: Math.round(scale * (maxX - minX)), height: Math.round(scale * (maxY - minY))});
    for (const e of this.ground) {
      if (e.kind.sensor) continue;
      const cos = scale * Math.cos(e.angle), sin = scale * Math.sin(e.angle);
      g.setTransform(cos, -sin, -sin, -cos, scale * (e.x - minX), scale * (maxY - e.y));
      g.fillStyle = g.strokeStyle = hex(e.kind.rgb);
      g.lineWidth = 1.5 / scale;
      g[e.kind.thin ? 'stroke' : 'fill'](e.kind.path);
    }
  }

  /** Draws the whole level with its players on another canvas, small. */
  drawMinimap(canvas) {
    const [minX, , , maxY] = this.world.match.bounds, scale = this.mapScale, {width, height} = this.map, g = canvas.getContext('2d');
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, {width, height});
    g.clearRect(0, 0, width, height);
    g.drawImage(this.map, 0, 0);
    for (const d of this.marked || []) {
      for (const [r, colour] of [[5.5, '#fff'], [4, hex(d.kind.rgb)]]) {
        const x = scale * (d.pose[0] - minX), y = scale * (maxY - d.pose[1]);
        g.fillStyle = colour;
        g.beginPath(); g.moveTo(x - r, y); g.lineTo(x, y - r); g.lineTo(x + r, y); g.lineTo(x, y + r); g.fill();
      }
    }
    for (const d of this.dots || []) {
      const own = d.body === this.world.own;
      for (const [radius, colour] of own ? [[4.5, '#fff'], [3, hex(this.colour(d))]] : [[3, hex(this.colour(d))]]) {
        g.fillStyle = colour;
        g.beginPath(); g.arc(scale * (d.pose[0] - minX), scale * (maxY - d.pose[1]), radius, 0, 7); g.fill();
      }
    }
  }

  /** Finds what a look has for a body: its sprites, its trail, and what a blow sets off. */
  dress(d, seconds) {
    const look = this.look;
    d.sprites = look?.spritesOf(d.kind.name);
    if (!look) return;
    const [x, y, , vx, vy] = d.pose;
    d.track = look.follow(d.body, d.pose, seconds);
    const trail = look.trails[d.kind.name], blows = look.blows[d.kind.name];
    if (trail && Math.hypot(vx, vy) > TRAIL_FROM) this.sparks.stream(trail, x, y, vx, vy, seconds, this.colour(d));
    const blow = look.blow(d.track, d.kind.look === 'PLAYER', d.pose);
    if (!blow || !blows) return;
    const share = Math.max(LEAST_SHARE, Math.min(1, blow.size / HARD_BLOW)), at = [x - blow.x * d.kind.size, y - blow.y * d.kind.size];
    this.setOff(blows, ...at, Math.atan2(blow.y, blow.x), share, d.kind.rgb);
    look.react(blows, d.body, blow.x, blow.y, share);
    this.onBlow?.(blows, ...at, share);
  }

  sprites(g, d, aim, time, silhouette) {
    const [x, y, angle] = d.pose, move = silhouette ? SHADOW : [0, 0], owner = d.body.owner & 1023;
    const by = value => this.look.number(this.world, value, owner, d.body.id);
    this.look.paint(g, this.placed, d.kind, d.sprites, {x: x + move[0], y: y + move[1], angle}, d.track, this.colour(d), by, aim, time, silhouette);
  }

  place(g, x, y, angle) {
    const v = this.view, cos = Math.cos(angle), sin = Math.sin(angle);
    g.setTransform(v[0], 0, 0, -v[0], v[4], v[5]);
    if (this.bend) g.transform(...this.bend);
    g.transform(cos, sin, -sin, cos, x, y);
  }

  /** Lights up the shapes of a body that reacts to a blow. */
  lightUp(g, kind, reaction, x, y, angle) {
    this.place(g, x, y, angle);
    g.fillStyle = shade(reaction.rgb, 1, reaction.flash);
    g.fill(kind.path);
  }

  backdrop(g, match, hasGrid) {
    const [minX, minY, maxX, maxY] = match.bounds;
    if (hasGrid) this.grid(g, match, minX, minY, maxX, maxY);
    g.lineWidth = EDGE;
    for (const zone of match.zones.filter(z => z.rgb >= 0)) {
      g.fillStyle = shade(zone.rgb, 1, 0.22);
      g.strokeStyle = shade(zone.rgb, 1, 0.7);
      g.fillRect(zone.minX, zone.minY, zone.maxX - zone.minX, zone.maxY - zone.minY);
      g.strokeRect(zone.minX, zone.minY, zone.maxX - zone.minX, zone.maxY - zone.minY);
    }
  }

  grid(g, match, minX, minY, maxX, maxY) {
    g.lineWidth = 1 / this.view[0];
    g.strokeStyle = shade(match.theme.grid, 1, 0.4);
    g.beginPath();
    for (let x = Math.ceil(minX / GRID) * GRID; x <= maxX; x += GRID) { g.moveTo(x, minY); g.lineTo(x, maxY); }
    for (let y = Math.ceil(minY / GRID) * GRID; y <= maxY; y += GRID) { g.moveTo(minX, y); g.lineTo(maxX, y); }
    g.stroke();
  }

  /** Returns a body's colour: of a player's the one chosen, unless there are teams. */
  colour({body, kind}) {
    const player = kind.look === 'PLAYER' && !this.world.match.teams.length && this.world.players.get(body.owner & 1023);
    return player && player.rgb >= 0 ? player.rgb : kind.rgb;
  }

  body(g, kind, rgb, x, y, angle, time) {
    this.place(g, x, y, angle);
    g.globalAlpha = kind.sensor && kind.look === 'PLAIN' ? 0.25 : 1;
    g.fillStyle = hex(rgb);
    g.strokeStyle = kind.thin ? hex(rgb) : hex(kind.outline);
    g.lineWidth = kind.thin ? 2 * EDGE : EDGE;
    if (!kind.thin) g.fill(kind.path);
    g.stroke(kind.path);
    if (kind.look !== 'PLAYER' && kind.look !== 'WALL' && kind.look !== 'PLATFORM') details(g, kind.look, kind.flat, rgb, kind.outline, time);
    g.globalAlpha = 1;
  }

  streak(g, {body, kind, pose: [x, y, , vx, vy]}) {
    const speed = Math.hypot(vx, vy);
    if (speed < STREAK_FROM || kind.look !== 'BALL' && kind.look !== 'PLAYER') return;
    const share = Math.min(1, 0.3 + 0.7 * (speed - STREAK_FROM) / (STREAK_FULL - STREAK_FROM)), r = 0.9 * kind.size;
    g.fillStyle = shade(this.colour({body, kind}), 1.2, 0.22 * share);
    for (const layer of [1, 2]) {
      g.beginPath();
      g.moveTo(x - vy / speed * r, y + vx / speed * r);
      g.lineTo(x - vx * STREAK_S * layer, y - vy * STREAK_S * layer);
      g.lineTo(x + vy / speed * r, y - vx / speed * r);
      g.fill();
    }
  }

  face(g, {body, kind, pose: [x, y, angle, vx, vy]}, own, aim, time) {
    const look = own ? aim : vx * vx + vy * vy > 0.3 ? Math.atan2(vy, vx) : angle;
    const player = this.world.players.get(body.owner & 1023);
    if (player?.rgb >= 0 && this.world.match.teams.length) {
      this.place(g, x, y, angle);
      g.strokeStyle = hex(player.rgb);
      g.lineWidth = 0.16;
      g.stroke(kind.path);
    }
    this.place(g, x, y, look);
    eyes(g, kind.size);
    if (!own) return;
    this.place(g, x, y, angle);
    g.strokeStyle = `rgb(255 255 255 / ${0.7 + 0.25 * Math.sin(4 * time)})`;
    g.lineWidth = EDGE;
    if (kind.flat[0].length === 3) { g.beginPath(); g.arc(0, 0, kind.size * 1.3, 0, 2 * Math.PI); g.stroke(); } else g.stroke(kind.path);
  }

  joints(g, shown) {
    if (!this.world.joints.length) return;
    const poses = new Map(shown.map(d => [d.body.id, d.pose]));
    const anchor = (id, x, y) => {
      const pose = poses.get(id);
      if (id < 0) return [x, y];
      return pose && [pose[0] + Math.cos(pose[2]) * x - Math.sin(pose[2]) * y, pose[1] + Math.sin(pose[2]) * x + Math.cos(pose[2]) * y];
    };
    g.strokeStyle = g.fillStyle = '#c8b48a';
    g.lineWidth = EDGE;
    for (const j of this.world.joints) {
      const a = anchor(j.first, j.ax, j.ay), b = anchor(j.second, j.bx, j.by);
      if (!a || !b) continue;
      g.beginPath(); g.moveTo(...a); g.lineTo(...b); g.stroke();
      g.beginPath(); g.arc(...a, EDGE, 0, 7); g.arc(...b, EDGE, 0, 7); g.fill();
    }
  }

  rings(g, nowMs) {
    this.flashes = this.flashes.filter(f => nowMs - f.ms < 1000 * LABEL_S);
    for (const {look, x, y, ms} of this.flashes) {
      const left = 1 - (nowMs - ms) / 1000 / RING_S;
      if (left <= 0 || !look.radius) continue;
      g.strokeStyle = shade(look.rgb, 1, left);
      g.lineWidth = 0.05 + 0.2 * left * Math.min(1, look.radius);
      g.beginPath(); g.arc(x, y, look.radius * (1 - left * left), 0, 2 * Math.PI); g.stroke();
    }
  }

  labels(g, shown, own, nowMs) {
    g.textAlign = 'center';
    g.lineJoin = 'round';
    g.lineWidth = 3;
    g.strokeStyle = 'rgb(12 16 23 / .8)';
    const scale = this.canvas.clientHeight / this.camera.height, match = this.world.match;
    const write = (text, x, y, colour) => { g.strokeText(text, x, y); g.fillStyle = colour; g.fillText(text, x, y); };
    for (const d of shown) {
      if (d.kind.look !== 'PLAYER' || d.body.owner < 0 || d.body.owner > 1023) continue;
      const player = this.world.players.get(d.body.owner), [x, y] = this.toScreen(d.pose[0], d.pose[1]), above = y - d.kind.size * scale;
      g.font = '600 12px system-ui, sans-serif';
      if (player && d !== own) write(player.name, x, above - 8, '#e8eef6');
      match.gauges.filter(gauge => gauge.kind === 'OVER_HEADS').forEach((gauge, i) => {
        const value = this.world.field('player', d.body.owner, gauge.field);
        if (value === undefined) return;
        const share = Math.max(0, Math.min(1, (value - gauge.least) / (gauge.most - gauge.least)));
        g.fillStyle = '#0c1017c0'; g.fillRect(x - 18, above - 5 + 6 * i, 36, 4);
        g.fillStyle = '#5ad18a'; g.fillRect(x - 18, above - 5 + 6 * i, 36 * share, 4);
      });
      const emote = this.emotes.get(d.body.owner);
      if (emote && nowMs - emote.ms < EMOTE_MS) { g.font = '700 16px system-ui, sans-serif'; write(emote.text, x, above - 24, '#ffb340'); }
    }
    for (const {look, x, y, ms} of this.flashes) {
      const age = (nowMs - ms) / 1000;
      if (!look.label) continue;
      const [px, py] = this.toScreen(x, y + RISE * age);
      g.font = `700 ${look.radius >= 2 ? 24 : 16}px system-ui, sans-serif`;
      g.globalAlpha = Math.max(0, 1 - age / LABEL_S);
      write(look.label, px, py, hex(look.rgb));
      g.globalAlpha = 1;
    }
  }
}

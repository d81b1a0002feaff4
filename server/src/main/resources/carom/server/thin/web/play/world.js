// What the server told, and where bodies are shown: a little late and between two snapshots, so that they glide.

const KEPT = 12, BLEND = 0.05, LEAST_SPARE_MS = 4, MOST_LATE_MS = 250;

export class World {
  constructor() { this.begin(null, 60); }

  /** Forgets everything and begins with a match. */
  begin(match, tickRate) {
    this.match = match;
    this.tickRate = tickRate;
    this.bodies = new Map();
    this.fields = new Map();
    this.players = new Map();
    this.joints = [];
    this.tick = -1;
    this.base = null; // ms at which tick 0 would have arrived, on a line without jitter
    this.gapMs = 33;
    this.jitterMs = 0;
    this.own = null;
  }

  /** Takes a snapshot that arrives now. */
  take({tick, bodies, gone}, nowMs) {
    const before = this.tick;
    this.tick = tick;
    const at = nowMs - tick * 1000 / this.tickRate;
    if (this.base === null || at < this.base || at - this.base > 1000) this.base = at;
    else this.base += (at - this.base) * BLEND * 0.2;
    this.jitterMs += (Math.abs(at - this.base) - this.jitterMs) * BLEND;
    if (before >= 0) this.gapMs += (Math.min(200, (tick - before) * 1000 / this.tickRate) - this.gapMs) * BLEND;
    for (const id of gone) {
      const body = this.bodies.get(id);
      if (body) body.goneTick = tick;
    }
    for (const [id, x, y, angle, archetype, owner] of bodies) {
      let body = this.bodies.get(id);
      if (archetype !== undefined) {
        body = {id, archetype, owner, poses: [], goneTick: Infinity, fromTick: tick};
        this.bodies.set(id, body);
        if (owner === this.match.player) this.own = body;
      }
      if (!body) continue;
      const last = body.poses[body.poses.length - 1];
      // What wasn't told rested: its last pose was good up to the snapshot before.
      if (last && last[0] < before) body.poses.push([before, last[1], last[2], last[3]]);
      body.poses.push([tick, x, y, angle]);
      while (body.poses.length > KEPT) body.poses.shift();
    }
  }

  /** Returns the tick that is shown at a time: so late that the next snapshot is nearly always there. */
  shownTick(nowMs) {
    if (this.base === null) return -1;
    const late = Math.min(MOST_LATE_MS, this.gapMs + Math.max(LEAST_SPARE_MS, 3 * this.jitterMs));
    return Math.min(this.tick, (nowMs - this.base - late) * this.tickRate / 1000);
  }

  /** Forgets bodies that are gone, and returns those that are there at a tick. */
  *shown(tick) {
    for (const body of this.bodies.values()) {
      if (tick >= body.goneTick) {
        this.bodies.delete(body.id);
        if (this.own === body) this.own = null;
      } else if (body.poses.length) {
        yield body;
      }
    }
  }

  /** Returns [x, y, angle, vx, vy] of a body at a tick. */
  pose(body, tick) {
    const poses = body.poses;
    let k = poses.length - 1;
    while (k > 0 && poses[k][0] > tick) k--;
    const [t0, x0, y0, a0] = poses[k], to = poses[k + 1];
    if (!to || tick <= t0) return [x0, y0, a0, 0, 0];
    const [t1, x1, y1, a1] = to, part = Math.min(1, (tick - t0) / (t1 - t0));
    const turn = Math.atan2(Math.sin(a1 - a0), Math.cos(a1 - a0)), perS = this.tickRate / (t1 - t0);
    return [x0 + part * (x1 - x0), y0 + part * (y1 - y0), a0 + part * turn, (x1 - x0) * perS, (y1 - y0) * perS];
  }

  /** Takes fields over; a null means that this player may no longer know it. */
  learn(scopes) {
    for (const [scope, ids] of Object.entries(scopes)) {
      for (const [id, values] of Object.entries(ids)) {
        for (const [name, value] of Object.entries(values)) {
          const key = `${scope} ${id} ${name}`;
          if (value === null) this.fields.delete(key);
          else this.fields.set(key, value);
        }
      }
    }
  }

  field(scope, id, name) { return this.fields.get(`${scope} ${id} ${name}`); }
}

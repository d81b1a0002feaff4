// The link to the server: docs/protocol/THIN.md in JavaScript. JSON texts, snapshots and inputs in the binary form.

const SNAPSHOT = 1, INPUT = 2, POSITION = 1 / 512, TURN = 2 * Math.PI / 1024;
const SILENCE_MS = 12_000, FIRST_WAIT_MS = 500, LONGEST_WAIT_MS = 8_000;

const address = () => `${location.protocol === 'https:' ? 'wss:' : 'ws:'}//${location.host}/thin`;

export class Thin {
  /**
   * `hear` has a function for each message of the server, and: `snapshot({tick, input, bodies, gone})` with bodies
   * [id, x, y, angle] or [id, x, y, angle, archetype, owner]; `state(text)`, empty when all is well; `end(text)`.
   */
  constructor(hear) {
    this.hear = hear;
    this.secret = '';
    this.standby = '';
    this.inputs = [];
    this.bytesIn = 0;
  }

  /** Asks for the rooms over a link of its own; `take` gets each list of them. */
  static rooms(take) {
    const socket = new WebSocket(address());
    socket.onopen = () => socket.send('{"rooms":{}}');
    socket.onmessage = e => {
      const value = JSON.parse(e.data).rooms;
      if (value) take(value);
      if (value?.left === 0) socket.close();
    };
  }

  /** Joins, the first time with a ticket; after a loss it comes back to its seat by itself until `close`. */
  join(values, ticket) {
    this.joining = values;
    this.ticket = ticket;
    this.secret = values.secret || '';
    this.wait = FIRST_WAIT_MS;
    this.losses = 0;
    this.open();
  }

  open() {
    clearTimeout(this.timer);
    this.count = 0;
    this.seen = -1;
    this.inputs = [];
    this.poses = new Map();
    const socket = this.socket = new WebSocket(address());
    socket.binaryType = 'arraybuffer';
    this.heardMs = performance.now();
    socket.onopen = () => {
      this.say('join', {version: 1, binary: true, ...this.joining, token: this.ticket || this.joining.token, secret: this.secret || undefined});
      this.ticket = '';
    };
    socket.onmessage = e => {
      if (socket !== this.socket) return;
      this.heardMs = performance.now();
      if (typeof e.data === 'string') {
        this.bytesIn += e.data.length;
        const message = JSON.parse(e.data), name = Object.keys(message)[0];
        this.take(name, message[name]);
      } else {
        this.bytesIn += e.data.byteLength;
        this.snapshot(new Uint8Array(e.data));
      }
    };
    socket.onclose = () => { if (socket === this.socket) this.lost(); };
  }

  take(name, value) {
    if (name === 'welcome') {
      this.secret = value.secret;
      this.wait = FIRST_WAIT_MS;
      this.losses = 0;
      this.hear.state('');
    } else if (name === 'match') {
      this.poses.clear();
      this.seen = -1;
    } else if (name === 'standby') {
      this.standby = value.server;
    } else if (name === 'redirect') {
      this.close();
    } else if (name === 'refused' || name === 'goodbye') {
      this.close();
      this.hear.end(value.text || value.reason);
      return;
    }
    this.hear[name]?.(value);
  }

  /** Reads a snapshot; poses are differences to the last of the same body. */
  snapshot(bytes) {
    let at = 0;
    const next = () => {
      let value = 0, shift = 1;
      for (;;) {
        const b = bytes[at++];
        value += (b & 127) * shift;
        if (b < 128) return value;
        shift *= 128;
      }
    };
    const signed = () => { const v = next(); return v % 2 ? -(v + 1) / 2 : v / 2; };
    if (bytes[at++] !== SNAPSHOT) return;
    const tick = next(), input = next() - 1, gone = [], bodies = [];
    for (let i = next(), id = 0; i > 0; i--) {
      gone.push(id += next());
      this.poses.delete(id);
    }
    for (let i = next(), id = 0; i > 0; i--) {
      const head = next(), isNew = head % 2 === 1;
      id += Math.floor(head / 2);
      const pose = isNew ? [0, 0, 0] : this.poses.get(id);
      pose[0] += signed();
      pose[1] += signed();
      pose[2] = pose[2] + signed() & 1023;
      this.poses.set(id, pose);
      const body = [id, pose[0] * POSITION, pose[1] * POSITION, pose[2] * TURN];
      if (isNew) body.push(next(), next() - 1);
      bodies.push(body);
    }
    this.seen = tick;
    this.hear.snapshot({tick, input, bodies, gone});
  }

  /** Sends an input with the two before it, so that none is lost: buttons, moves -1..1, aim in radians. */
  input(buttons, moveX, moveY, aim) {
    if (this.seen < 0 || !this.isOpen()) return;
    const steps = v => Math.round(Math.max(-1, Math.min(1, v)) * 127) & 255;
    const turn = Math.round(aim / (2 * Math.PI) * 65536) & 65535;
    this.inputs.unshift([buttons & 255, buttons >> 8 & 255, steps(moveX), steps(moveY), turn & 255, turn >> 8]);
    this.inputs.length = Math.min(3, this.inputs.length);
    this.count++;
    const out = [INPUT];
    for (let v of [this.count, this.seen + 1]) {
      for (; v > 127; v = Math.floor(v / 128)) out.push(v & 127 | 128);
      out.push(v);
    }
    for (const input of this.inputs) out.push(...input);
    this.socket.send(new Uint8Array(out));
  }

  say(name, values = {}) {
    if (this.isOpen()) this.socket.send(JSON.stringify({[name]: values}));
  }

  isOpen() { return this.socket?.readyState === WebSocket.OPEN; }

  /** Call it now and then: a link that says nothing for long is opened anew. */
  watch() {
    if (this.joining && this.socket && performance.now() - this.heardMs > SILENCE_MS) {
      const silent = this.socket;
      this.lost();
      silent.close();
    }
  }

  lost() {
    this.socket = null;
    if (!this.joining) return;
    if (++this.losses > 1 && this.standby && navigator.onLine) { // the room goes on there
      const server = this.standby;
      this.close();
      this.hear.redirect({server});
      return;
    }
    this.hear.state('The connection is lost. Trying again ...');
    this.timer = setTimeout(() => this.open(), this.wait);
    this.wait = Math.min(LONGEST_WAIT_MS, 2 * this.wait);
  }

  /** Ends the stay; the server keeps no place. */
  leave() {
    this.say('leave');
    this.close();
  }

  close() {
    clearTimeout(this.timer);
    const socket = this.socket;
    this.socket = this.joining = null;
    socket?.close();
  }
}

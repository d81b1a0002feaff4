// Keys, mouse, gamepad and glass as one input: buttons, moves from -1 to 1, an aim in radians. A game's look may say what does what.

const JUMP = 1, ACTION = 2, SECOND = 4, DOWN = 8, UP = 16;
const MOVES = {KeyA: 'left', ArrowLeft: 'left', KeyD: 'right', ArrowRight: 'right', KeyW: 'up', ArrowUp: 'up', KeyS: 'down', ArrowDown: 'down'};
const BUTTONS = {Space: 'main', KeyE: 'second', ShiftLeft: 'second', KeyJ: 'main', KeyK: 'second'};
const GLASS = [['A', 'main'], ['B', 'second']];
const PAD = {A: 0, B: 1, X: 2, Y: 3, L1: 4, R1: 5, Back: 8, Start: 9, L3: 10, R3: 11};
const MOUSE = ['left', 'middle', 'right'];
const CODES = {Left: 'ArrowLeft', Right: 'ArrowRight', Up: 'ArrowUp', Down: 'ArrowDown', 'L-Shift': 'ShiftLeft', 'R-Shift': 'ShiftRight',
  'L-Ctrl': 'ControlLeft', 'R-Ctrl': 'ControlRight', 'L-Alt': 'AltLeft', 'R-Alt': 'AltRight', Delete: 'Backspace', 'Forward Delete': 'Delete', '`': 'Backquote',
  '-': 'Minus', '=': 'Equal', '[': 'BracketLeft', ']': 'BracketRight', '\\': 'Backslash', ';': 'Semicolon', "'": 'Quote', ',': 'Comma', '.': 'Period', '/': 'Slash',
  'Page Up': 'PageUp', 'Page Down': 'PageDown'};
const DEAD = 0.2, STICK = 56, EDGE = 0.9;

/** Returns the code that browsers give a key which the window calls by a name, such as "W" or "L-Shift". */
function codeOf(name) {
  if (/^[A-Z]$/.test(name)) return `Key${name}`;
  if (/^[0-9]$/.test(name)) return `Digit${name}`;
  if (/^Num(pad)? [0-9]$/.test(name)) return `Numpad${name.at(-1)}`;
  return CODES[name] || name;
}

export class Controls {
  /** `glass` has the elements `left` and `right` for sticks, and `buttons`; `canPlay` tells whether presses are for the game; `onGlass` hears of touches. */
  constructor(canvas, glass, canPlay, onGlass) {
    this.canvas = canvas;
    this.held = new Set();
    this.mouse = {x: 0, y: 0, down: new Set(), aims: false};
    this.glass = glass;
    this.left = this.stick(glass.left);
    this.right = this.stick(glass.right);
    this.pressed = new Set(); // buttons on glass
    this.unread = new Set(); // went down since the last read
    this.taps = []; // [set, what]: let go before a read has seen it, so the next one shall
    this.aim = 0;
    this.canPlay = canPlay;
    this.onGlass = onGlass;
    this.use([]);
    addEventListener('keydown', e => {
      if (this.keys.has(e.code) && canPlay()) { this.press(this.held, e.code); e.preventDefault(); }
    });
    addEventListener('keyup', e => this.letGo(this.held, e.code));
    addEventListener('blur', () => this.release());
    document.addEventListener('visibilitychange', () => this.release());
    canvas.addEventListener('contextmenu', e => e.preventDefault());
    canvas.addEventListener('pointermove', e => {
      if (e.pointerType !== 'touch') Object.assign(this.mouse, {x: e.offsetX, y: e.offsetY, aims: true});
    });
    canvas.addEventListener('pointerdown', e => {
      if (e.pointerType === 'touch') { onGlass(); return; }
      Object.assign(this.mouse, {x: e.offsetX, y: e.offsetY, aims: true});
      this.press(this.mouse.down, MOUSE[e.button]);
    });
    addEventListener('pointerup', e => { if (e.pointerType !== 'touch') this.letGo(this.mouse.down, MOUSE[e.button]); });
  }

  /** Takes the actions of a game's look in place of the usual ones: its buttons, its movements or place, and its aim, each if it has any. */
  use(actions) {
    const of = (...kinds) => actions.filter(a => kinds.includes(a.kind));
    this.buttons = of('BUTTON').map(a => ({...a, name: a.bindings[0].name, codes: a.bindings[0].keys.map(codeOf)}));
    this.moves = of('MOVE_X', 'MOVE_Y').map(a => ({...a, less: a.bindings[0].keys.map(codeOf), more: a.bindings[1].keys.map(codeOf)}));
    this.place = of('POINT')[0];
    this.aiming = of('AIM')[0];
    this.keys = new Set([...this.buttons.flatMap(b => b.codes), ...this.moves.flatMap(m => [...m.less, ...m.more])]);
    if (!this.moves.length && !this.place) Object.keys(MOVES).forEach(code => this.keys.add(code));
    if (!this.buttons.length) Object.keys(BUTTONS).forEach(code => this.keys.add(code));
    this.release();
    const shown = this.buttons.length ? this.buttons.map(b => [b.name, b.button]) : GLASS;
    this.glass.buttons.replaceChildren(...shown.map(([name, what]) => this.glassButton(name, what)));
    this.glass.right.hidden = !!this.buttons.length && !this.aiming;
  }

  /** Returns what the keys do, for people: "W, Space: jump". */
  words() {
    const words = (names, what) => `${names.join(', ')}: ${what}`;
    const keys = b => words([...b.bindings[0].keys, ...b.mouse.map(m => `${m} mouse`)], b.name);
    return [...this.moves.flatMap(m => m.bindings.map(b => words(b.keys, b.name))), ...this.buttons.map(keys)].join(' · ');
  }

  glassButton(name, what) {
    const element = document.createElement('button');
    element.className = 'round';
    element.textContent = name;
    const set = on => e => {
      e.preventDefault();
      element.classList.toggle('down', on);
      if (on) { this.press(this.pressed, what); this.onGlass(); } else this.letGo(this.pressed, what);
    };
    element.addEventListener('pointerdown', set(true));
    for (const event of ['pointerup', 'pointercancel', 'pointerleave']) element.addEventListener(event, set(false));
    return element;
  }

  /** Makes a stick of an element: {x, y} from -1 to 1 while a finger holds it. */
  stick(element) {
    const stick = {x: 0, y: 0, held: false}, knob = element.firstElementChild;
    let pointer = null;
    const move = e => {
      const box = element.getBoundingClientRect(), dx = e.clientX - box.left - box.width / 2, dy = e.clientY - box.top - box.height / 2;
      const far = Math.max(1, Math.hypot(dx, dy) / STICK);
      stick.x = dx / far / STICK;
      stick.y = -dy / far / STICK;
      knob.style.transform = `translate(${dx / far}px, ${dy / far}px)`;
    };
    element.addEventListener('pointerdown', e => {
      e.preventDefault();
      pointer = e.pointerId;
      element.setPointerCapture(pointer);
      stick.held = true;
      this.onGlass();
      move(e);
    });
    element.addEventListener('pointermove', e => { if (e.pointerId === pointer) move(e); });
    const end = e => {
      if (e.pointerId !== pointer) return;
      pointer = null;
      Object.assign(stick, {x: 0, y: 0, held: false});
      knob.style.transform = '';
    };
    element.addEventListener('pointerup', end);
    element.addEventListener('pointercancel', end);
    return stick;
  }

  press(set, what) {
    if (!set.has(what)) this.unread.add(what);
    this.taps = this.taps.filter(tap => tap[1] !== what);
    set.add(what);
  }

  letGo(set, what) {
    if (this.unread.has(what)) this.taps.push([set, what]); else set.delete(what);
  }

  release() {
    this.unread.clear();
    this.taps = [];
    this.held.clear();
    this.pressed.clear();
    this.mouse.down.clear();
  }

  /** Returns [buttons, moveX, moveY, aim]; `toWorld` turns pixels of the canvas into metres, `own` is the own place. */
  read(toWorld, own) {
    const pad = [...navigator.getGamepads?.() ?? []].find(p => p?.connected && p.mapping === 'standard');
    const axis = i => Math.abs(pad?.axes[i] ?? 0) < DEAD ? 0 : pad.axes[i], padButton = i => pad?.buttons[i]?.pressed ? 1 : 0;
    const sticks = {left: [axis(0), -axis(1)], right: [axis(2), -axis(3)], 'd-pad': [padButton(15) - padButton(14), padButton(12) - padButton(13)]};
    let [x, y] = this.moves.length || this.place ? this.ownMoves(sticks) : this.usualMoves(sticks);
    if (this.place && (x || y)) this.mouse.aims = false;
    const pointed = this.mouse.aims && own ? toWorld(this.mouse.x, this.mouse.y) : null;
    if (pointed && this.place?.mouse.length) [x, y] = [0, 1].map(i => (pointed[i] - own[i]) / this.place.range);
    const length = Math.max(1, Math.hypot(x, y));
    x /= length;
    y /= length;
    let [aimX, aimY] = [this.right.x, this.right.y];
    for (const name of this.aiming ? this.aiming.sticks : ['right']) { aimX += sticks[name][0]; aimY += sticks[name][1]; }
    if (aimX || aimY) { this.aim = Math.atan2(aimY, aimX); this.mouse.aims = false; }
    else if (pointed && (!this.aiming || this.aiming.mouse.length)) this.aim = Math.atan2(pointed[1] - own[1], pointed[0] - own[0]);
    else if (x || y) this.aim = Math.atan2(y, x);
    const buttons = this.buttons.length ? this.ownButtons(padButton) : this.usualButtons(padButton, y);
    for (const [set, what] of this.taps) set.delete(what);
    this.taps = [];
    this.unread.clear();
    return this.canPlay() ? [buttons, x, y, this.aim] : [0, 0, 0, this.aim];
  }

  any(codes) { return codes.some(code => this.held.has(code)) ? 1 : 0; }

  usualMoves(sticks) {
    const is = way => this.any(Object.keys(MOVES).filter(code => MOVES[code] === way && !this.buttons.some(b => b.codes.includes(code))));
    const {left, 'd-pad': cross} = sticks;
    return [is('right') - is('left') + this.left.x + left[0] + cross[0], is('up') - is('down') + this.left.y + left[1] + cross[1]];
  }

  /** Returns the movements of the look's actions, or the way to its place; on glass, each has its way of the left stick. */
  ownMoves(sticks) {
    const way = [0, 0];
    for (const m of this.moves) {
      const at = m.kind === 'MOVE_X' ? 0 : 1;
      way[at] += this.any(m.more) - this.any(m.less) + (at ? this.left.y : this.left.x);
      for (const name of m.sticks) way[at] += sticks[name][at];
    }
    if (this.place) {
      for (const [x, y] of [[this.left.x, this.left.y], ...this.place.sticks.map(name => sticks[name])]) { way[0] += x; way[1] += y; }
    }
    return way;
  }

  usualButtons(padButton, y) {
    const is = name => this.any(Object.keys(BUTTONS).filter(code => BUTTONS[code] === name)) || this.pressed.has(name);
    const main = is('main') || this.mouse.down.has('left') || padButton(0) || padButton(2) || padButton(5);
    const second = is('second') || this.mouse.down.has('right') || padButton(1);
    const up = this.any(['KeyW', 'ArrowUp']) || y > 0.5;
    return (main || up ? JUMP : 0) | (main ? ACTION : 0) | (second ? SECOND : 0) | (y < -0.5 ? DOWN : 0) | (y > 0.5 ? UP : 0);
  }

  /** Returns the buttons of the look's actions. The aiming stick at its edge also does what the left mouse button does. */
  ownButtons(padButton) {
    const fires = Math.hypot(this.right.x, this.right.y) > EDGE;
    let bits = 0;
    for (const b of this.buttons) {
      const held = this.any(b.codes) || this.pressed.has(b.button) || b.mouse.some(m => this.mouse.down.has(m) || m === 'left' && fires) || b.pad.some(p => padButton(PAD[p]));
      if (held) bits |= b.button;
    }
    return bits;
  }
}

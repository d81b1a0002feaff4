// Keys, mouse, gamepad and glass as one input: buttons, moves from -1 to 1, an aim in radians.

const JUMP = 1, ACTION = 2, SECOND = 4, DOWN = 8, UP = 16;
const KEYS = {KeyA: 'left', ArrowLeft: 'left', KeyD: 'right', ArrowRight: 'right', KeyW: 'up', ArrowUp: 'up', KeyS: 'down', ArrowDown: 'down',
  Space: 'main', KeyE: 'second', ShiftLeft: 'second', KeyJ: 'main', KeyK: 'second'};
const DEAD = 0.2, STICK = 56;

export class Controls {
  /** `onGlass` is called at the first touch; `canPlay` says whether presses are for the game. */
  constructor(canvas, sticks, canPlay, onGlass) {
    this.canvas = canvas;
    this.held = new Set();
    this.mouse = {x: 0, y: 0, left: false, right: false, aims: false};
    this.left = this.stick(sticks.left);
    this.right = this.stick(sticks.right);
    this.pressed = new Set(); // buttons on glass
    this.aim = 0;
    this.canPlay = canPlay;
    this.onGlass = onGlass;
    addEventListener('keydown', e => {
      if (KEYS[e.code] && canPlay()) { this.held.add(KEYS[e.code]); e.preventDefault(); }
    });
    addEventListener('keyup', e => this.held.delete(KEYS[e.code]));
    addEventListener('blur', () => this.release());
    document.addEventListener('visibilitychange', () => this.release());
    canvas.addEventListener('contextmenu', e => e.preventDefault());
    canvas.addEventListener('pointermove', e => {
      if (e.pointerType === 'touch') return;
      Object.assign(this.mouse, {x: e.offsetX, y: e.offsetY, aims: true});
    });
    canvas.addEventListener('pointerdown', e => {
      if (e.pointerType === 'touch') { onGlass(); return; }
      Object.assign(this.mouse, {x: e.offsetX, y: e.offsetY, aims: true});
      this.mouse[e.button === 2 ? 'right' : 'left'] = true;
    });
    addEventListener('pointerup', e => { if (e.pointerType !== 'touch') this.mouse[e.button === 2 ? 'right' : 'left'] = false; });
    for (const [element, bit] of sticks.buttons) {
      const set = on => e => {
        e.preventDefault();
        element.classList.toggle('down', on);
        if (on) { this.pressed.add(bit); onGlass(); } else this.pressed.delete(bit);
      };
      element.addEventListener('pointerdown', set(true));
      for (const name of ['pointerup', 'pointercancel', 'pointerleave']) element.addEventListener(name, set(false));
    }
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

  release() {
    this.held.clear();
    this.pressed.clear();
    this.mouse.left = this.mouse.right = false;
  }

  /** Returns [buttons, moveX, moveY, aim]; `toWorld` turns pixels of the canvas into metres, `own` is the own place. */
  read(toWorld, own) {
    const is = name => this.held.has(name) ? 1 : 0;
    let x = is('right') - is('left') + this.left.x, y = is('up') - is('down') + this.left.y;
    let main = is('main') || this.mouse.left || this.pressed.has('main');
    let second = is('second') || this.mouse.right || this.pressed.has('second');
    let aimX = this.right.x, aimY = this.right.y;
    const pad = [...navigator.getGamepads?.() ?? []].find(p => p?.connected && p.mapping === 'standard');
    if (pad) {
      const axis = v => Math.abs(v) < DEAD ? 0 : v, button = i => pad.buttons[i]?.pressed ? 1 : 0;
      x += axis(pad.axes[0]) + button(15) - button(14);
      y += button(12) - button(13) - axis(pad.axes[1]);
      aimX += axis(pad.axes[2]);
      aimY -= axis(pad.axes[3]);
      main ||= button(0) || button(2) || button(5);
      second ||= button(1);
    }
    const length = Math.max(1, Math.hypot(x, y));
    x /= length;
    y /= length;
    if (aimX || aimY) { this.aim = Math.atan2(aimY, aimX); this.mouse.aims = false; }
    else if (this.mouse.aims && own) { const at = toWorld(this.mouse.x, this.mouse.y); this.aim = Math.atan2(at[1] - own[1], at[0] - own[0]); }
    else if (x || y) this.aim = Math.atan2(y, x);
    if (!this.canPlay()) return [0, 0, 0, this.aim];
    const up = is('up') || y > 0.5;
    const buttons = (main || up ? JUMP : 0) | (main ? ACTION : 0) | (second ? SECOND : 0) | (y < -0.5 ? DOWN : 0) | (y > 0.5 ? UP : 0);
    return [buttons, x, y, this.aim];
  }
}

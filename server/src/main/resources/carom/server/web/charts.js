// Charts of one figure a second. A chart draws itself on a canvas; nothing here knows the server.

const SECONDS = 300;
const LEFT = 34;
const PAD = 4;

/** Height of the axis of time. */
const AXIS = 13;

/** Returns the least 1, 2 or 5 times a power of ten that is not below a value. */
function niceMaximum(value) {
  if (!(value > 0)) return 1;
  const power = Math.pow(10, Math.floor(Math.log10(value)));
  return [1, 2, 5, 10].find(step => step * power >= value) * power;
}

function short(value) {
  const size = Math.abs(value);
  if (size >= 1e6) return (value / 1e6).toFixed(1) + 'M';
  if (size >= 1e4) return (value / 1e3).toFixed(0) + 'k';
  return Number.isInteger(value) || size >= 100 ? value.toFixed(0) : size >= 10 ? value.toFixed(1) : value.toFixed(2);
}

export class Chart {
  /**
   * @param series [{name, label, colour: 1..6, help: text to show below the pointer, or none}];
   *   `stacked` draws them on top of each other; `whole` says that values are whole numbers
   */
  constructor(parent, {title, unit, series, stacked, whole}) {
    this.series = series;
    this.whole = whole;
    this.stacked = stacked;
    const box = document.createElement('div');
    box.className = 'chart';
    const head = document.createElement('h3');
    head.append(title);
    head.appendChild(document.createElement('span')).textContent = unit;
    this.canvas = document.createElement('canvas');
    this.canvas.setAttribute('role', 'img');
    this.canvas.setAttribute('aria-label', title);
    const legend = document.createElement('div');
    legend.className = 'legend';
    this.values = series.map(each => {
      const entry = legend.appendChild(document.createElement('span'));
      entry.appendChild(document.createElement('i')).className = 'k' + each.colour;
      entry.append(each.label + ' ');
      each.entry = entry;
      entry.title = each.help || '';
      return entry.appendChild(document.createElement('b'));
    });
    box.append(head, this.canvas, legend);
    parent.append(box);
    this.hover = -1;
    this.canvas.addEventListener('pointermove', event => { this.hover = event.offsetX; this.draw(); });
    this.canvas.addEventListener('pointerleave', () => { this.hover = -1; this.draw(); });
  }

  /** Shows rows of values, the last one of this second; a value is null where it isn't known. */
  show(rows, columns) {
    this.rows = rows;
    this.at = this.series.map(each => columns.indexOf(each.name));
    this.draw();
  }

  draw() {
    if (!this.rows) return;
    const ratio = window.devicePixelRatio || 1;
    const width = this.canvas.clientWidth, height = this.canvas.clientHeight;
    if (!width) return;
    this.canvas.width = width * ratio;
    this.canvas.height = height * ratio;
    const g = this.canvas.getContext('2d');
    g.scale(ratio, ratio);
    const style = getComputedStyle(document.documentElement);
    const colour = name => style.getPropertyValue(name).trim();
    const rows = this.rows.slice(-SECONDS);
    const values = rows.map(row => this.at.map(i => row[i] || 0));
    if (this.stacked) {
      for (const each of values) for (let i = 1; i < each.length; i++) each[i] += each[i - 1];
    }
    const most = niceMaximum(Math.max(0, ...values.flat()));
    const top = this.whole ? most + most % 2 : most; // half of it is shown, too
    const x = i => LEFT + (width - LEFT - PAD) * (1 - (rows.length - 1 - i) / (SECONDS - 1));
    const y = value => height - AXIS - (height - AXIS - PAD - 4) * Math.min(1, value / top);
    g.font = '10px system-ui, sans-serif';
    g.textAlign = 'right';
    g.textBaseline = 'middle';
    for (const part of [0, 0.5, 1]) {
      g.strokeStyle = colour('--line');
      g.beginPath(); g.moveTo(LEFT, y(top * part)); g.lineTo(width - PAD, y(top * part)); g.stroke();
      g.fillStyle = colour('--quiet');
      g.fillText(short(top * part), LEFT - 4, y(top * part));
    }
    g.textBaseline = 'bottom';
    for (let ago = 0; ago < SECONDS; ago += 60) {
      const at = x(rows.length - 1 - ago);
      g.textAlign = ago ? 'center' : 'right';
      g.fillText(ago ? `−${ago / 60} min` : 'now', at, height);
      g.beginPath(); g.moveTo(at, y(0)); g.lineTo(at, y(0) + 2); g.stroke();
    }
    for (let s = this.series.length - 1; s >= 0; s--) {
      g.strokeStyle = g.fillStyle = colour('--c' + this.series[s].colour);
      g.beginPath();
      values.forEach((each, i) => { if (rows[i][this.at[s]] !== null) g.lineTo(x(i), y(each[s])); });
      if (this.stacked && rows.length > 1) {
        g.lineTo(x(rows.length - 1), y(0)); g.lineTo(x(0), y(0)); g.fill();
      } else {
        g.lineWidth = 1.5; g.stroke(); g.lineWidth = 1;
      }
    }
    this.tell(rows, g, x, height, colour);
  }

  /** Explains the series of a name when the pointer rests on it. */
  explain(name, text) {
    for (const each of this.series) if (each.name === name) each.entry.title = text;
  }

  /** Writes the newest value of each series, or those under the pointer. */
  tell(rows, g, x, height, colour) {
    let i = rows.length - 1;
    if (this.hover >= LEFT && rows.length) {
      i = Math.max(0, Math.min(i, Math.round(i - (x(i) - this.hover) / (x(1) - x(0)))));
      g.strokeStyle = colour('--quiet');
      g.beginPath(); g.moveTo(x(i), PAD); g.lineTo(x(i), height - AXIS); g.stroke();
    }
    const row = rows[i];
    this.values.forEach((value, s) => { value.textContent = !row ? '' : row[this.at[s]] === null ? '–' : short(row[this.at[s]] || 0); });
  }
}

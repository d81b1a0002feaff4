// Draws bodies: shared by the page that plays and the operators' page. Metres, y up; the canvas' transform does the rest.

export const hex = rgb => '#' + (rgb & 0xffffff).toString(16).padStart(6, '0');

/** Returns a colour scaled towards black (below 1) or white (above 1), as CSS. */
export function shade(rgb, scale, alpha = 1) {
  const channel = at => {
    const value = rgb >> at & 255;
    return Math.round(scale <= 1 ? value * scale : value + (255 - value) * Math.min(1, scale - 1));
  };
  return `rgb(${channel(16)} ${channel(8)} ${channel(0)} / ${alpha})`;
}

/** Width of the edge of a body, metres. */
export const EDGE = 0.07;

/** Builds the outline of a body from its parts: each is [radius, x, y, ...] with one, two or more corners. */
export function outline(parts) {
  const path = new Path2D();
  let thin = true;
  for (const [radius, ...xy] of parts) {
    const n = xy.length / 2;
    if (n === 1) {
      path.moveTo(xy[0] + radius, xy[1]);
      path.arc(xy[0], xy[1], radius, 0, 2 * Math.PI);
      thin = false;
    } else if (n === 2 && radius < 1e-3) {
      path.moveTo(xy[0], xy[1]);
      path.lineTo(xy[2], xy[3]);
    } else {
      const edge = i => Math.atan2(xy[2 * ((i + 1) % n) + 1] - xy[2 * i + 1], xy[2 * ((i + 1) % n)] - xy[2 * i]);
      for (let i = 0; i < n; i++) {
        const into = edge((i + n - 1) % n) - Math.PI / 2, out = edge(i) - Math.PI / 2;
        if (radius < 1e-3) path[i ? 'lineTo' : 'moveTo'](xy[2 * i], xy[2 * i + 1]);
        else path.arc(xy[2 * i], xy[2 * i + 1], radius, into, out);
      }
      path.closePath();
      thin = false;
    }
  }
  return {path, thin};
}

/** Returns half of the smaller side of a part, metres: how large details on it may be. */
export function extent([radius, ...xy]) {
  if (xy.length === 2) return radius;
  let minX = Infinity, minY = Infinity, maxX = -Infinity, maxY = -Infinity;
  for (let i = 0; i < xy.length; i += 2) {
    minX = Math.min(minX, xy[i]); maxX = Math.max(maxX, xy[i]);
    minY = Math.min(minY, xy[i + 1]); maxY = Math.max(maxY, xy[i + 1]);
  }
  return radius + Math.min(maxX - minX, maxY - minY) / 2;
}

/**
 * Draws what tells kinds apart, in the body's frame: spots of balls, planks of crates, rings.
 * `look` is in capitals; `seconds` lets bumpers pulse.
 */
export function details(g, look, parts, rgb, edge, seconds) {
  for (const part of parts) {
    const r = extent(part), round = part.length === 3;
    const x = round ? part[1] : 0, y = round ? part[2] : 0;
    g.fillStyle = g.strokeStyle = look === 'BALL' || look === 'CRATE' ? hex(edge) : shade(rgb, 1.35);
    g.lineWidth = EDGE;
    g.beginPath();
    switch (look) {
      case 'BALL':
        for (let i = 0; i < 3; i++) {
          const a = i * 2 * Math.PI / 3, px = x + Math.cos(a) * r * 0.55, py = y + Math.sin(a) * r * 0.55;
          g.moveTo(px + r * 0.2, py);
          g.arc(px, py, r * 0.2, 0, 2 * Math.PI);
        }
        g.fill();
        break;
      case 'CRATE': {
        const h = r * 0.62;
        g.lineWidth = EDGE * 1.4;
        g.moveTo(-h, -h); g.lineTo(h, h); g.moveTo(-h, h); g.lineTo(h, -h);
        g.stroke();
        break;
      }
      case 'BUMPER':
        g.lineWidth = EDGE * 1.6;
        g.arc(x, y, r * (0.55 + 0.06 * Math.sin(seconds * 3)), 0, 2 * Math.PI);
        g.stroke();
        g.beginPath();
        g.arc(x, y, r * 0.22, 0, 2 * Math.PI);
        g.fill();
        break;
      case 'COIN': g.arc(x, y, r * 0.72, 0, 2 * Math.PI); g.stroke(); break;
      case 'LAMP': g.arc(x, y, r * 0.5, 0, 2 * Math.PI); g.fill(); break;
      default:
        if (round && look === 'PLAIN') {
          g.strokeStyle = hex(edge);
          g.moveTo(x, y); g.lineTo(x + r, y);
          g.stroke();
        }
    }
  }
}

/** Draws two eyes that look along an angle, in the world's frame turned to it. */
export function eyes(g, r) {
  for (const side of [-1, 1]) {
    const x = 0.42 * r, y = 0.3 * r * side;
    g.fillStyle = '#fff';
    g.beginPath(); g.arc(x, y, 0.24 * r, 0, 2 * Math.PI); g.fill();
    g.fillStyle = '#10141c';
    g.beginPath(); g.arc(x + 0.09 * r, y, 0.12 * r, 0, 2 * Math.PI); g.fill();
  }
}

package carom.client.desktop.game;

import carom.client.desktop.paint.Canvas;
import carom.client.desktop.paint.UiColours;
import carom.sim.level.Area;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.math.MathUtils;

/**
 * Draws areas: water with a surface that moves, wind as streaks, another gravity as arrows, mud as
 * specks, an attractor as rings. Render thread only; allocates nothing.
 */
final class AreaPainter {
  /** Square metres for each streak, arrow or speck, and the most of them in one area. */
  private static final float METRES_EACH = 5;

  private static final int MOST = 60;

  /** Length of a streak of wind, seconds of its way. */
  private static final float STREAK_SECONDS = 0.16f;

  /** Width of a streak or an arrow, metres. */
  private static final float LINE_M = 0.06f;

  /** Length of a piece of the water's surface, metres. */
  private static final float WAVE_M = 0.5f;

  private static final float WAVE_HEIGHT_M = 0.07f;
  private static final int RINGS = 4;

  /** Steps of the sequences that scatter points evenly (the plastic number's). */
  private static final float SCATTER_X = 0.7548777f;

  private static final float SCATTER_Y = 0.5698403f;

  private final Canvas canvas;
  private final Color color = new Color();
  private final float[] quad = new float[8];

  // Where the area's frame is.
  private float x;
  private float y;
  private float cos;
  private float sin;
  private float power = 1;

  AreaPainter(Canvas canvas) {
    this.canvas = canvas;
  }

  /** Sets the frame of the areas drawn next. */
  void frame(float newX, float newY, float newCos, float newSin) {
    x = newX;
    y = newY;
    cos = newCos;
    sin = newSin;
  }

  /** Sets how strong the areas drawn next are, 0..1. */
  void power(float newPower) {
    power = newPower;
  }

  /** Draws what lies behind the bodies in an area. */
  void behind(Area area, float seconds) {
    if (power <= 0) {
      return;
    }
    if (area.kind() == Area.Kind.WATER || area.kind() == Area.Kind.GRAVITY) {
      cos = 1;
      sin = 0;
    }
    switch (area.kind()) {
      case WATER -> fill(area, area.maxY(), 0.30f);
      case WIND -> {
        fill(area, area.maxY(), 0.05f);
        streaks(area, seconds);
      }
      case GRAVITY -> {
        fill(area, area.maxY(), 0.08f);
        arrows(area, seconds);
      }
      case DRAG -> {
        fill(area, area.maxY(), 0.35f);
        specks(area);
      }
      case ATTRACTOR -> rings(area, seconds);
    }
  }

  /** Draws what lies before the bodies in an area. */
  void before(Area area, float seconds) {
    if (area.kind() != Area.Kind.WATER || power <= 0) {
      return;
    }
    cos = 1;
    sin = 0;
    fill(area, area.maxY(), 0.22f);
    shade(area, 1.6f, 0.9f);
    float from = area.minX();
    float level = surface(area, from, seconds);
    while (from < area.maxX()) {
      float to = Math.min(area.maxX(), from + WAVE_M);
      float next = surface(area, to, seconds);
      canvas.line(x + from, y + level, x + to, y + next, LINE_M, color);
      from = to;
      level = next;
    }
  }

  private void shade(Area area, float lightness, float alpha) {
    UiColours.shade(area.rgb(), lightness, alpha * (0.3f + 0.7f * power), color);
  }

  private static float surface(Area area, float at, float seconds) {
    return area.maxY()
        + WAVE_HEIGHT_M
            * (MathUtils.sin(at * 1.3f + seconds * 1.7f) + MathUtils.sin(at * 0.7f - seconds))
            / 2;
  }

  private void fill(Area area, float top, float alpha) {
    shade(area, 1, alpha);
    corner(0, area.minX(), area.minY());
    corner(1, area.maxX(), area.minY());
    corner(2, area.maxX(), top);
    corner(3, area.minX(), top);
    canvas.convex(quad, 4, color);
  }

  private void corner(int index, float px, float py) {
    quad[2 * index] = worldX(px, py);
    quad[2 * index + 1] = worldY(px, py);
  }

  private float worldX(float px, float py) {
    return x + cos * px - sin * py;
  }

  private float worldY(float px, float py) {
    return y + sin * px + cos * py;
  }

  private void line(float x1, float y1, float x2, float y2) {
    canvas.line(worldX(x1, y1), worldY(x1, y1), worldX(x2, y2), worldY(x2, y2), LINE_M, color);
  }

  private static int marks(Area area) {
    float metres = (area.maxX() - area.minX()) * (area.maxY() - area.minY());
    return (int) Math.min(MOST, 3 + metres / METRES_EACH);
  }

  /** Returns a coordinate of a mark that moves and comes back at the other end. */
  private static float wrapped(float min, float max, float share, float moved) {
    float size = max - min;
    float at = (share * size + moved) % size;
    return min + (at < 0 ? at + size : at);
  }

  private void streaks(Area area, float seconds) {
    for (int i = 0, n = marks(area); i < n; i++) {
      float px = wrapped(area.minX(), area.maxX(), share(i, SCATTER_X), area.x() * seconds);
      float py = wrapped(area.minY(), area.maxY(), share(i, SCATTER_Y), area.y() * seconds);
      float tailX = MathUtils.clamp(px - area.x() * STREAK_SECONDS, area.minX(), area.maxX());
      float tailY = MathUtils.clamp(py - area.y() * STREAK_SECONDS, area.minY(), area.maxY());
      shade(area, 1, 0.18f + 0.3f * share(i, 0.61f));
      line(px, py, tailX, tailY);
    }
  }

  private void arrows(Area area, float seconds) {
    float length = (float) Math.sqrt(area.x() * area.x() + area.y() * area.y());
    if (length == 0) {
      return;
    }
    float dx = area.x() / length;
    float dy = area.y() / length;
    shade(area, 1.2f, 0.35f);
    for (int i = 0, n = marks(area); i < n; i++) {
      float px = wrapped(area.minX(), area.maxX(), share(i, SCATTER_X), 0.6f * dx * seconds);
      float py = wrapped(area.minY(), area.maxY(), share(i, SCATTER_Y), 0.6f * dy * seconds);
      float size = 0.25f;
      line(px, py, px - size * (dx + dy), py - size * (dy - dx));
      line(px, py, px - size * (dx - dy), py - size * (dy + dx));
    }
  }

  private void specks(Area area) {
    shade(area, 0.6f, 0.6f);
    for (int i = 0, n = marks(area); i < n; i++) {
      float px = wrapped(area.minX(), area.maxX(), share(i, SCATTER_X), 0);
      float py = wrapped(area.minY(), area.maxY(), share(i, SCATTER_Y), 0);
      canvas.disc(worldX(px, py), worldY(px, py), 0.07f + 0.06f * share(i, 0.61f), color);
    }
  }

  /** Draws rings that shrink into an attractor's point, or grow out of it if it repels. */
  private void rings(Area area, float seconds) {
    float atX = worldX(area.x(), area.y());
    float atY = worldY(area.x(), area.y());
    shade(area, 1, 0.06f);
    canvas.disc(atX, atY, area.range(), color);
    float way = area.strength() < 0 ? seconds : -seconds;
    for (int i = 0; i < RINGS; i++) {
      float share = (((float) i / RINGS + 0.2f * way) % 1 + 1) % 1;
      shade(area, 1.2f, 0.4f * (1 - share));
      canvas.ring(atX, atY, area.range() * share, LINE_M, color);
    }
  }

  /** Returns the place of a mark in a sequence that scatters them, 0..1. */
  private static float share(int index, float step) {
    float at = (index + 1) * step;
    return at - (int) at;
  }
}

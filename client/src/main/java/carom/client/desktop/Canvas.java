package carom.client.desktop;

import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.graphics.GL20;
import com.badlogic.gdx.graphics.glutils.ShapeRenderer;
import com.badlogic.gdx.math.MathUtils;
import com.badlogic.gdx.math.Matrix4;
import com.badlogic.gdx.utils.Disposable;

/**
 * Filled and outlined figures in one batch, in whatever units the projection says. Lines, rings and
 * discs fade over a pixel along their edges, which on a processor that draws costs a fraction of
 * multisampling; fills without round corners don't, they are smooth under their outlines. Calls
 * stand between {@link #begin} and {@link #end}; render thread only; no allocation per figure.
 */
final class Canvas implements Disposable {
  private static final int MAX_VERTICES = 30_000;

  /** Least of 1 + cosine between two edges' normals: a sharper corner is cut off. */
  private static final float SHARPEST = 0.25f;

  private final ShapeRenderer shapes = new ShapeRenderer(MAX_VERTICES);
  private final Color solid = new Color();
  private final Color clear = new Color();

  /** Pixels per unit, which decides how many sides a circle needs. */
  private float pixelsPerUnit = 1;

  /** Half a pixel in units. */
  private float halfPixel = 0.5f;

  // Of the stroke or disc that is drawn: up to where it is solid and from where on clear.
  private float core;
  private float rim;

  // From a corner of an outline to where the parallels of its edges at distance 1 meet.
  private float mitreX;
  private float mitreY;

  /**
   * Starts a batch.
   *
   * @param projection world (or screen) to clip space
   * @param pixelsPerUnit size of one unit on the screen, greater than zero
   */
  void begin(Matrix4 projection, float pixelsPerUnit) {
    this.pixelsPerUnit = pixelsPerUnit;
    halfPixel = 0.5f / pixelsPerUnit;
    Gdx.gl.glEnable(GL20.GL_BLEND);
    Gdx.gl.glBlendFunc(GL20.GL_SRC_ALPHA, GL20.GL_ONE_MINUS_SRC_ALPHA);
    shapes.setProjectionMatrix(projection);
    shapes.begin(ShapeRenderer.ShapeType.Filled);
  }

  void end() {
    shapes.end();
  }

  void rect(float x, float y, float width, float height, Color color) {
    shapes.setColor(color);
    shapes.rect(x, y, width, height);
  }

  /** An opaque rectangle whose colour runs from the lower to the upper edge. */
  void gradient(float x, float y, float width, float height, Color lower, Color upper) {
    shapes.flush();
    Gdx.gl.glDisable(GL20.GL_BLEND); // it may be as large as the window
    shapes.rect(x, y, width, height, lower, lower, upper, upper);
    shapes.flush();
    Gdx.gl.glEnable(GL20.GL_BLEND);
  }

  void line(float x1, float y1, float x2, float y2, float width, Color color) {
    float dx = x2 - x1;
    float dy = y2 - y1;
    float length = (float) Math.sqrt(dx * dx + dy * dy);
    if (length == 0) {
      return;
    }
    stroke(width, color);
    float nx = -dy / length;
    float ny = dx / length;
    edge(x1, y1, nx, ny, x2, y2, nx, ny);
  }

  void disc(float x, float y, float radius, Color color) {
    core = Math.max(0, radius - halfPixel);
    rim = radius + halfPixel;
    paint(color, Math.min(1, radius / halfPixel));
    int n = sides(radius);
    float cos = 1;
    float sin = 0;
    for (int i = 1; i <= n; i++) {
      float angle = MathUtils.PI2 * i / n;
      float nextCos = MathUtils.cos(angle);
      float nextSin = MathUtils.sin(angle);
      shapes.triangle(
          x,
          y,
          x + cos * core,
          y + sin * core,
          x + nextCos * core,
          y + nextSin * core,
          solid,
          solid,
          solid);
      band(x, y, cos, sin, x, y, nextCos, nextSin, core, solid, rim, clear);
      cos = nextCos;
      sin = nextSin;
    }
  }

  /** A ring whose outer edge has the given radius. */
  void ring(float x, float y, float radius, float width, Color color) {
    arc(x, y, radius, width, 0, MathUtils.PI2, color);
  }

  /** Part of a ring, counter-clockwise from an angle, in radians. */
  void arc(
      float x, float y, float radius, float width, float fromRad, float sweepRad, Color color) {
    int n = Math.max(3, Math.round(sides(radius) * Math.abs(sweepRad) / MathUtils.PI2));
    width = Math.min(width, radius);
    float middle = radius - width / 2;
    stroke(width, color);
    float cos = MathUtils.cos(fromRad);
    float sin = MathUtils.sin(fromRad);
    for (int i = 1; i <= n; i++) {
      float angle = fromRad + sweepRad * i / n;
      float nextCos = MathUtils.cos(angle);
      float nextSin = MathUtils.sin(angle);
      edge(
          x + cos * middle,
          y + sin * middle,
          cos,
          sin,
          x + nextCos * middle,
          y + nextSin * middle,
          nextCos,
          nextSin);
      cos = nextCos;
      sin = nextSin;
    }
  }

  /** A convex figure of {@code count} corners, counter-clockwise, as x, y pairs. */
  void convex(float[] xy, int count, Color color) {
    shapes.setColor(color);
    for (int i = 2; i < count; i++) {
      shapes.triangle(xy[0], xy[1], xy[2 * i - 2], xy[2 * i - 1], xy[2 * i], xy[2 * i + 1]);
    }
  }

  /** The closed line through {@code count} corners of a convex figure, with pointed joints. */
  void outline(float[] xy, int count, float width, Color color) {
    if (count < 3) {
      line(xy[0], xy[1], xy[2], xy[3], width, color);
      return;
    }
    stroke(width, color);
    mitre(xy, count - 2, count - 1, 0);
    for (int i = 0, j = count - 1; i < count; j = i++) {
      float beforeX = mitreX;
      float beforeY = mitreY;
      mitre(xy, j, i, i + 1 < count ? i + 1 : 0);
      edge(xy[2 * j], xy[2 * j + 1], beforeX, beforeY, xy[2 * i], xy[2 * i + 1], mitreX, mitreY);
    }
  }

  private void mitre(float[] xy, int before, int at, int after) {
    float ax = xy[2 * at] - xy[2 * before];
    float ay = xy[2 * at + 1] - xy[2 * before + 1];
    float bx = xy[2 * after] - xy[2 * at];
    float by = xy[2 * after + 1] - xy[2 * at + 1];
    float a = 1 / Math.max(Float.MIN_NORMAL, (float) Math.sqrt(ax * ax + ay * ay));
    float b = 1 / Math.max(Float.MIN_NORMAL, (float) Math.sqrt(bx * bx + by * by));
    float scale = 1 / Math.max(SHARPEST, 1 + (ax * bx + ay * by) * a * b);
    mitreX = (ay * a + by * b) * scale;
    mitreY = -(ax * a + bx * b) * scale;
  }

  /** Prepares for lines of a width; what is thinner than a pixel gets fainter instead. */
  private void stroke(float width, Color color) {
    float half = width / 2;
    core = Math.max(0, half - halfPixel);
    rim = half + halfPixel;
    paint(color, Math.min(1, width / rim));
  }

  private void paint(Color color, float coverage) {
    solid.set(color).a *= coverage;
    clear.set(color).a = 0;
  }

  /** One straight piece of a stroke, between two points and along their mitres. */
  private void edge(
      float x1, float y1, float mx1, float my1, float x2, float y2, float mx2, float my2) {
    band(x1, y1, mx1, my1, x2, y2, mx2, my2, -rim, clear, -core, solid);
    if (core > 0) {
      band(x1, y1, mx1, my1, x2, y2, mx2, my2, -core, solid, core, solid);
    }
    band(x1, y1, mx1, my1, x2, y2, mx2, my2, core, solid, rim, clear);
  }

  /** The part of a stroke from one distance to another, each with its colour. */
  private void band(
      float x1,
      float y1,
      float mx1,
      float my1,
      float x2,
      float y2,
      float mx2,
      float my2,
      float from,
      Color fromColor,
      float to,
      Color toColor) {
    float ax = x1 + from * mx1;
    float ay = y1 + from * my1;
    float cx = x2 + to * mx2;
    float cy = y2 + to * my2;
    shapes.triangle(
        ax, ay, x2 + from * mx2, y2 + from * my2, cx, cy, fromColor, fromColor, toColor);
    shapes.triangle(ax, ay, cx, cy, x1 + to * mx1, y1 + to * my1, fromColor, toColor, toColor);
  }

  private int sides(float radius) {
    return MathUtils.clamp((int) (6 * Math.sqrt(radius * pixelsPerUnit)), 8, 96);
  }

  @Override
  public void dispose() {
    shapes.dispose();
  }
}

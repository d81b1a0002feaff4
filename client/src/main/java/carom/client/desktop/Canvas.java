package carom.client.desktop;

import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.graphics.GL20;
import com.badlogic.gdx.graphics.glutils.ShapeRenderer;
import com.badlogic.gdx.math.MathUtils;
import com.badlogic.gdx.math.Matrix4;
import com.badlogic.gdx.utils.Disposable;

/**
 * Filled and outlined figures in one batch, in whatever units the projection says. Edges are
 * smoothed by the window's multisampling. Calls stand between {@link #begin} and {@link #end};
 * render thread only; no allocation per figure.
 */
final class Canvas implements Disposable {
  private static final int MAX_VERTICES = 30_000;

  private final ShapeRenderer shapes = new ShapeRenderer(MAX_VERTICES);

  /** Pixels per unit, which decides how many sides a circle needs. */
  private float pixelsPerUnit = 1;

  /**
   * Starts a batch.
   *
   * @param projection world (or screen) to clip space
   * @param pixelsPerUnit size of one unit on the screen, greater than zero
   */
  void begin(Matrix4 projection, float pixelsPerUnit) {
    this.pixelsPerUnit = pixelsPerUnit;
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

  /** A rectangle whose colour runs from the lower to the upper edge. */
  void gradient(float x, float y, float width, float height, Color lower, Color upper) {
    shapes.rect(x, y, width, height, lower, lower, upper, upper);
  }

  void line(float x1, float y1, float x2, float y2, float width, Color color) {
    shapes.setColor(color);
    shapes.rectLine(x1, y1, x2, y2, width);
  }

  void disc(float x, float y, float radius, Color color) {
    shapes.setColor(color);
    shapes.circle(x, y, radius, sides(radius));
  }

  /** A ring whose outer edge has the given radius. */
  void ring(float x, float y, float radius, float width, Color color) {
    arc(x, y, radius, width, 0, MathUtils.PI2, color);
  }

  /** Part of a ring, counter-clockwise from an angle, in radians. */
  void arc(
      float x, float y, float radius, float width, float fromRad, float sweepRad, Color color) {
    shapes.setColor(color);
    int n = Math.max(3, Math.round(sides(radius) * Math.abs(sweepRad) / MathUtils.PI2));
    float inner = Math.max(0, radius - width);
    float cos = MathUtils.cos(fromRad);
    float sin = MathUtils.sin(fromRad);
    for (int i = 1; i <= n; i++) {
      float angle = fromRad + sweepRad * i / n;
      float nextCos = MathUtils.cos(angle);
      float nextSin = MathUtils.sin(angle);
      float ax = x + cos * inner;
      float ay = y + sin * inner;
      float bx = x + cos * radius;
      float by = y + sin * radius;
      float cx = x + nextCos * radius;
      float cy = y + nextSin * radius;
      shapes.triangle(ax, ay, bx, by, cx, cy);
      shapes.triangle(ax, ay, cx, cy, x + nextCos * inner, y + nextSin * inner);
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

  /** The closed line through {@code count} corners, with round joints. */
  void outline(float[] xy, int count, float width, Color color) {
    shapes.setColor(color);
    for (int i = 0, j = count - 1; i < count; j = i++) {
      shapes.rectLine(xy[2 * j], xy[2 * j + 1], xy[2 * i], xy[2 * i + 1], width);
      shapes.circle(xy[2 * i], xy[2 * i + 1], width / 2, 8);
    }
  }

  private int sides(float radius) {
    return MathUtils.clamp((int) (6 * Math.sqrt(radius * pixelsPerUnit)), 8, 96);
  }

  @Override
  public void dispose() {
    shapes.dispose();
  }
}

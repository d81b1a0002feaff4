package carom.client.desktop;

import carom.physics.geometry.Circle;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Shape;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.math.MathUtils;

/** Draws physics shapes at a pose, on a canvas in metres. Render thread only. */
final class ShapePainter {
  private final Canvas canvas;
  private final float[] corners = new float[2 * Convex.MAX_VERTICES];
  private int cornerCount;
  private float x;
  private float y;
  private float cos = 1;
  private float sin;

  ShapePainter(Canvas canvas) {
    this.canvas = canvas;
  }

  /** Where the next shapes stand: the body's origin in metres, and its rotation. */
  void pose(float x, float y, float cos, float sin) {
    this.x = x;
    this.y = y;
    this.cos = cos;
    this.sin = sin;
  }

  /** Fills every part of a shape. */
  void fill(Shape shape, Color color) {
    for (Convex part : shape.parts()) {
      if (part instanceof Circle circle) {
        canvas.disc(
            worldX(circle.centerX(), circle.centerY()),
            worldY(circle.centerX(), circle.centerY()),
            circle.radius(),
            color);
      } else {
        corners(part);
        canvas.convex(corners, cornerCount, color);
        fillRounding(part, color);
      }
    }
  }

  /** Draws the edge of every part of a shape, on the inside for circles, centred for the others. */
  void outline(Shape shape, float width, Color color) {
    for (Convex part : shape.parts()) {
      if (part instanceof Circle circle) {
        canvas.ring(
            worldX(circle.centerX(), circle.centerY()),
            worldY(circle.centerX(), circle.centerY()),
            circle.radius(),
            width,
            color);
      } else if (part.radius() > 0) {
        outlineRounded(part, width, color);
      } else {
        corners(part);
        canvas.outline(corners, cornerCount, width, color);
      }
    }
  }

  /** A strip along each edge and a disc at each corner. */
  private void fillRounding(Convex part, Color color) {
    float r = part.radius();
    for (int i = 0; r > 0 && i < part.vertexCount(); i++) {
      int next = (i + 1) % part.vertexCount();
      float nx = r * part.normalX(i);
      float ny = r * part.normalY(i);
      corner(0, part.vertexX(i), part.vertexY(i));
      corner(1, part.vertexX(i) + nx, part.vertexY(i) + ny);
      corner(2, part.vertexX(next) + nx, part.vertexY(next) + ny);
      corner(3, part.vertexX(next), part.vertexY(next));
      canvas.convex(corners, 4, color);
      canvas.disc(corners[0], corners[1], r, color);
    }
  }

  /** Edges moved outwards, joined by arcs. */
  private void outlineRounded(Convex part, float width, Color color) {
    float r = part.radius();
    int count = part.vertexCount();
    for (int i = 0; i < count; i++) {
      int next = (i + 1) % count;
      int before = (i + count - 1) % count;
      float nx = part.normalX(i);
      float ny = part.normalY(i);
      float mx = part.normalX(before);
      float my = part.normalY(before);
      float inner = r - width / 2;
      corner(0, part.vertexX(i) + inner * nx, part.vertexY(i) + inner * ny);
      corner(1, part.vertexX(next) + inner * nx, part.vertexY(next) + inner * ny);
      canvas.line(corners[0], corners[1], corners[2], corners[3], width, color);
      float from = MathUtils.atan2(sin * mx + cos * my, cos * mx - sin * my);
      float sweep = MathUtils.atan2(mx * ny - my * nx, mx * nx + my * ny);
      corner(0, part.vertexX(i), part.vertexY(i));
      canvas.arc(corners[0], corners[1], r, width, from, count == 2 ? MathUtils.PI : sweep, color);
    }
  }

  private void corner(int index, float px, float py) {
    corners[2 * index] = worldX(px, py);
    corners[2 * index + 1] = worldY(px, py);
  }

  /** World x of a point in the body's frame. */
  float worldX(float px, float py) {
    return x + cos * px - sin * py;
  }

  /** World y of a point in the body's frame. */
  float worldY(float px, float py) {
    return y + sin * px + cos * py;
  }

  private void corners(Convex part) {
    cornerCount = part.vertexCount();
    for (int i = 0; i < cornerCount; i++) {
      corners[2 * i] = worldX(part.vertexX(i), part.vertexY(i));
      corners[2 * i + 1] = worldY(part.vertexX(i), part.vertexY(i));
    }
  }
}

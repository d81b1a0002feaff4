package carom.client.desktop;

import carom.physics.geometry.Circle;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Shape;
import com.badlogic.gdx.graphics.Color;

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
      } else {
        corners(part);
        canvas.outline(corners, cornerCount, width, color);
      }
    }
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

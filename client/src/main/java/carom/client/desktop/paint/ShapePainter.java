package carom.client.desktop.paint;

import carom.physics.geometry.Box;
import carom.physics.geometry.Capsule;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Shape;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.math.MathUtils;

/** Draws physics shapes at a pose, on a canvas in metres. Render thread only. */
public final class ShapePainter {
  private final Canvas canvas;
  private final Color inside = new Color();
  private final float[] corners = new float[2 * Convex.MAX_VERTICES];
  private int cornerCount;
  private float x;
  private float y;
  private float cos = 1;
  private float sin;

  /** Creates a painter at the origin, unrotated. */
  public ShapePainter(Canvas canvas) {
    this.canvas = canvas;
  }

  /** Sets where the next shapes stand: the body's origin in metres, and its rotation. */
  public void pose(float x, float y, float cos, float sin) {
    this.x = x;
    this.y = y;
    this.cos = cos;
    this.sin = sin;
  }

  /** Fills every part of a shape. */
  public void fill(Shape shape, Color color) {
    for (Convex part : shape.parts()) {
      part(part, color, 0, 0, color);
    }
  }

  /** Draws the edge of every part of a shape: inside of round ones, centred for the others. */
  public void outline(Shape shape, float width, Color color) {
    for (Convex part : shape.parts()) {
      part(part, null, usualGrowth(part, width), width, color);
    }
  }

  /** Fills a shape and draws its edge, but not the edges between its parts. */
  public void paint(Shape shape, Color fill, float width, Color edge) {
    if (shape.parts().size() == 1) {
      Convex part = shape.parts().get(0);
      part(part, fill, usualGrowth(part, width), width, edge);
      return;
    }
    for (Convex part : shape.parts()) {
      part(part, null, width, 2 * width, edge); // the inner half is painted over
    }
    fill(shape, fill);
  }

  private static float usualGrowth(Convex part, float width) {
    return part.radius() > 0 ? 0 : width / 2;
  }

  /**
   * Draws a part of a shape.
   *
   * @param fill its colour; null = only the edge
   * @param growth by how much the outside of the edge is outside of the shape, metres; corners
   *     given one by one have their edges centred instead
   * @param width of the edge, metres; 0 = only the fill
   */
  private void part(Convex part, Color fill, float growth, float width, Color edge) {
    if (fill == null) {
      inside.set(edge).a = 0;
    } else {
      inside.set(fill);
    }
    if (part instanceof Circle c) {
      float px = worldX(c.centerX(), c.centerY());
      float py = worldY(c.centerX(), c.centerY());
      canvas.box(px, py, cos, sin, 0, 0, c.radius() + growth, inside, width, edge);
    } else if (part instanceof Box b) {
      float px = worldX(b.centerX(), b.centerY());
      float py = worldY(b.centerX(), b.centerY());
      float w = b.halfWidth() + growth;
      float h = b.halfHeight() + growth;
      canvas.box(px, py, cos, sin, w, h, 0, inside, width, edge);
    } else if (part instanceof Capsule c) {
      capsule(c, growth, width, edge);
    } else {
      if (fill != null) {
        corners(part);
        canvas.convex(corners, cornerCount, fill);
        fillRounding(part, fill);
      }
      if (width > 0 && part.radius() > 0) {
        outlineRounded(part, width, edge);
      } else if (width > 0) {
        corners(part);
        canvas.outline(corners, cornerCount, width, edge);
      }
    }
  }

  private void capsule(Capsule c, float growth, float width, Color edge) {
    float dx = (c.vertexX(1) - c.vertexX(0)) / c.length();
    float dy = (c.vertexY(1) - c.vertexY(0)) / c.length();
    float mx = (c.vertexX(0) + c.vertexX(1)) / 2;
    float my = (c.vertexY(0) + c.vertexY(1)) / 2;
    canvas.box(
        worldX(mx, my),
        worldY(mx, my),
        cos * dx - sin * dy,
        sin * dx + cos * dy,
        c.length() / 2,
        0,
        c.radius() + growth,
        inside,
        width,
        edge);
  }

  /** Fills a strip along each edge and a disc at each corner. */
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

  /** Draws the edges moved outwards, joined by arcs. */
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
      canvas.arc(corners[0], corners[1], r, width, from, sweep, color);
    }
  }

  private void corner(int index, float px, float py) {
    corners[2 * index] = worldX(px, py);
    corners[2 * index + 1] = worldY(px, py);
  }

  /** Returns the world x of a point in the body's frame. */
  public float worldX(float px, float py) {
    return x + cos * px - sin * py;
  }

  /** Returns the world y of a point in the body's frame. */
  public float worldY(float px, float py) {
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

package carom.client.desktop.paint;

import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.graphics.GL20;
import com.badlogic.gdx.graphics.Mesh;
import com.badlogic.gdx.graphics.VertexAttribute;
import com.badlogic.gdx.graphics.VertexAttributes.Usage;
import com.badlogic.gdx.graphics.glutils.ShaderProgram;
import com.badlogic.gdx.math.MathUtils;
import com.badlogic.gdx.math.Matrix4;
import com.badlogic.gdx.utils.Disposable;

/**
 * Draws filled and outlined figures in one batch, in the units of the projection. Calls stand
 * between {@link #begin} and {@link #end}. Render thread only; no allocation per figure.
 *
 * <p>Nearly all figures are boxes with round corners: discs and rings, lines, crates, capsules. A
 * box is two triangles. Its shader computes each pixel's distance to the edge, so the box is smooth
 * and may have an edge of another colour. Without a graphics card, a picture costs by the number of
 * its triangles. {@link #rect} and {@link #convex} have no smooth edges; the latter is smooth under
 * its outline.
 */
public final class Canvas implements Disposable {
  private static final int MAX_FIGURES = 4_096;
  private static final int CORNERS = 4;

  /** Floats of a vertex: position, place in the figure, half size, radius, edge, two colours. */
  private static final int STRIDE = 10;

  /** Distance inside a figure at which its edge doesn't matter, px. */
  private static final float INSIDE = 1e6f;

  /** Least value of 1 + cosine between the normals of two edges; a sharper corner is cut off. */
  private static final float SHARPEST = 0.25f;

  private static final String VERTEX_SHADER =
      """
      uniform mat4 u_projection;
      attribute vec2 a_position;
      attribute vec2 a_place;
      attribute vec2 a_half;
      attribute vec2 a_rim;
      attribute vec4 a_fill;
      attribute vec4 a_edge;
      varying vec2 v_place;
      varying vec2 v_half;
      varying vec2 v_rim;
      varying vec4 v_fill;
      varying vec4 v_edge;
      void main() {
        v_place = a_place;
        v_half = a_half;
        v_rim = a_rim;
        v_fill = a_fill;
        v_edge = a_edge;
        gl_Position = u_projection * vec4(a_position, 0.0, 1.0);
      }
      """;

  /** Shader of flat colours, for which Mesa's software renderer has a fast path. */
  private static final String PLAIN_SHADER =
      """
      varying vec4 v_fill;
      void main() {
        gl_FragColor = v_fill;
      }
      """;

  /** Shader of smooth boxes. Computes the distance to a box with round corners, in pixels. */
  private static final String SMOOTH_SHADER =
      """
      varying vec2 v_place;
      varying vec2 v_half;
      varying vec2 v_rim;
      varying vec4 v_fill;
      varying vec4 v_edge;
      void main() {
        vec2 q = abs(v_place) - v_half;
        float distance = length(max(q, 0.0)) + min(max(q.x, q.y), 0.0) - v_rim.x;
        vec4 color = mix(v_fill, v_edge, clamp(0.5 + distance + v_rim.y, 0.0, 1.0));
        color.a *= clamp(0.5 - distance, 0.0, 1.0);
        gl_FragColor = color;
      }
      """;

  private final ShaderProgram plain = shader(PLAIN_SHADER);
  private final ShaderProgram smooth = shader(SMOOTH_SHADER);
  private final Mesh mesh;
  private final float[] vertices = new float[MAX_FIGURES * CORNERS * STRIDE];
  private final Color thin = new Color();
  private int used;
  private ShaderProgram shader = smooth;
  private Matrix4 projection;

  /** Pixels per unit. */
  private float scale = 1;

  /** Half a pixel in units. */
  private float halfPixel = 0.5f;

  // What the next corners say.
  private float halfWidth;
  private float halfHeight;
  private float radius;
  private float edge;
  private float fillBits;
  private float edgeBits;

  // From a corner of an outline to where the parallels of its edges at distance 1 meet.
  private float mitreX;
  private float mitreY;

  /** Compiles the shaders. Needs the toolkit to run. */
  public Canvas() {
    mesh =
        new Mesh(
            false,
            MAX_FIGURES * CORNERS,
            MAX_FIGURES * 6,
            new VertexAttribute(Usage.Position, 2, "a_position"),
            new VertexAttribute(Usage.Generic, 2, "a_place"),
            new VertexAttribute(Usage.Generic, 2, "a_half"),
            new VertexAttribute(Usage.Generic, 2, "a_rim"),
            new VertexAttribute(Usage.ColorPacked, 4, "a_fill"),
            new VertexAttribute(Usage.ColorPacked, 4, "a_edge"));
    short[] indices = new short[MAX_FIGURES * 6];
    for (int i = 0, corner = 0; i < indices.length; corner += CORNERS) {
      indices[i++] = (short) corner;
      indices[i++] = (short) (corner + 1);
      indices[i++] = (short) (corner + 2);
      indices[i++] = (short) (corner + 2);
      indices[i++] = (short) (corner + 3);
      indices[i++] = (short) corner;
    }
    mesh.setIndices(indices);
  }

  private static ShaderProgram shader(String fragments) {
    ShaderProgram shader = new ShaderProgram(VERTEX_SHADER, fragments);
    if (!shader.isCompiled()) {
      throw new IllegalStateException("the canvas' shader doesn't compile: " + shader.getLog());
    }
    return shader;
  }

  /**
   * Starts a batch.
   *
   * @param newProjection world (or screen) to clip space; kept until {@link #end}
   * @param pixelsPerUnit size of one unit on the screen, greater than zero
   */
  public void begin(Matrix4 newProjection, float pixelsPerUnit) {
    projection = newProjection;
    scale = pixelsPerUnit;
    halfPixel = 0.5f / pixelsPerUnit;
    Gdx.gl.glEnable(GL20.GL_BLEND);
    Gdx.gl.glBlendFunc(GL20.GL_SRC_ALPHA, GL20.GL_ONE_MINUS_SRC_ALPHA);
  }

  /** Draws what is left of the batch. */
  public void end() {
    flush();
  }

  /** Forgets a batch that can't be ended as it should, because something threw in the middle. */
  public void abandon() {
    used = 0;
  }

  private void flush() {
    if (used == 0) {
      return;
    }
    mesh.setVertices(vertices, 0, used);
    shader.bind();
    shader.setUniformMatrix("u_projection", projection);
    mesh.render(shader, GL20.GL_TRIANGLES, 0, used / (CORNERS * STRIDE) * 6);
    used = 0;
  }

  // ---- figures

  /** Draws a sharp rectangle along the axes, from its lower left corner. */
  public void rect(float x, float y, float width, float height, Color color) {
    whole(color);
    room(plain);
    corner(x, y, 0, 0);
    corner(x + width, y, 0, 0);
    corner(x + width, y + height, 0, 0);
    corner(x, y + height, 0, 0);
  }

  /** Draws the sharp edge of a rectangle along the axes, inside of it. */
  public void frame(float x, float y, float width, float height, float edgeWidth, Color color) {
    rect(x, y, width, edgeWidth, color);
    rect(x, y + height - edgeWidth, width, edgeWidth, color);
    rect(x, y + edgeWidth, edgeWidth, height - 2 * edgeWidth, color);
    rect(x + width - edgeWidth, y + edgeWidth, edgeWidth, height - 2 * edgeWidth, color);
  }

  /** Draws lines one pixel wide along the axes, through all multiples of a step in a rectangle. */
  public void grid(float minX, float minY, float maxX, float maxY, float step, Color color) {
    float pixel = 2 * halfPixel;
    for (float x = MathUtils.ceil(minX / step) * step; x <= maxX; x += step) {
      rect(onPixel(x, Gdx.graphics.getWidth(), 0), minY, pixel, maxY - minY, color);
    }
    for (float y = MathUtils.ceil(minY / step) * step; y <= maxY; y += step) {
      rect(minX, onPixel(y, Gdx.graphics.getHeight(), 1), maxX - minX, pixel, color);
    }
  }

  /** Rounds a place on an axis down to the begin of its pixel. */
  private float onPixel(float place, float pixels, int axis) {
    float size = projection.val[axis == 0 ? Matrix4.M00 : Matrix4.M11];
    float shift = projection.val[axis == 0 ? Matrix4.M03 : Matrix4.M13];
    float pixel = MathUtils.floor((place * size + shift + 1) * pixels / 2);
    return (pixel * 2 / pixels - 1 - shift) / size;
  }

  /** Draws an opaque rectangle whose colour runs from the lower to the upper edge. */
  public void gradient(float x, float y, float width, float height, Color lower, Color upper) {
    flush();
    Gdx.gl.glDisable(GL20.GL_BLEND); // it may be as large as the window
    rect(x, y, width, height, lower);
    float bits = upper.toFloatBits();
    vertices[used - STRIDE - 2] = bits;
    vertices[used - 2] = bits;
    flush();
    Gdx.gl.glEnable(GL20.GL_BLEND);
  }

  /** Draws a line with square ends. A line thinner than a pixel is fainter instead. */
  public void line(float x1, float y1, float x2, float y2, float width, Color color) {
    float dx = x2 - x1;
    float dy = y2 - y1;
    float length = (float) Math.sqrt(dx * dx + dy * dy);
    if (length > 0) {
      Color tint = stroke(width, color);
      float half = Math.max(width / 2, halfPixel);
      box((x1 + x2) / 2, (y1 + y2) / 2, dx / length, dy / length, length / 2, half, 0, tint);
    }
  }

  /** Draws a filled circle around (x, y) with radius {@code r}. */
  public void disc(float x, float y, float r, Color color) {
    box(x, y, 1, 0, 0, 0, r, color);
  }

  /** Draws a ring whose outer edge has the given radius. */
  public void ring(float x, float y, float r, float width, Color color) {
    thin.set(color).a = 0;
    box(x, y, 1, 0, 0, 0, r, thin, Math.min(width, r), color);
  }

  /** Draws a box with round corners and no edge. */
  void box(float x, float y, float cos, float sin, float halfW, float halfH, float r, Color color) {
    box(x, y, cos, sin, halfW, halfH, r, color, 0, color);
  }

  /**
   * Draws a box with round corners.
   *
   * @param x its middle
   * @param y its middle
   * @param cos of the angle it is turned by
   * @param sin of that angle
   * @param halfW half its width, less the radius; 0 and above
   * @param halfH half its height, less the radius; 0 and above
   * @param r radius of its corners; 0 and above
   * @param fill colour inside
   * @param edgeWidth width of its edge, which is inside, too
   * @param edgeColor colour of the edge
   */
  void box(
      float x,
      float y,
      float cos,
      float sin,
      float halfW,
      float halfH,
      float r,
      Color fill,
      float edgeWidth,
      Color edgeColor) {
    halfWidth = halfW * scale;
    halfHeight = halfH * scale;
    radius = r * scale;
    edge = edgeWidth > 0 ? edgeWidth * scale : -1; // not even where the outside fades
    fillBits = fill.toFloatBits();
    edgeBits = edgeColor.toFloatBits();
    float w = halfW + r + halfPixel;
    float h = halfH + r + halfPixel;
    float px = w * scale;
    float py = h * scale;
    float wx = w * cos;
    float wy = w * sin;
    float hx = -h * sin;
    float hy = h * cos;
    room(smooth);
    corner(x - wx - hx, y - wy - hy, -px, -py);
    corner(x + wx - hx, y + wy - hy, px, -py);
    corner(x + wx + hx, y + wy + hy, px, py);
    corner(x - wx + hx, y - wy + hy, -px, py);
  }

  /** Draws part of a ring, counter-clockwise from an angle, radians. */
  public void arc(
      float x, float y, float r, float width, float fromRad, float sweepRad, Color color) {
    int n = MathUtils.clamp((int) (Math.sqrt(r * scale) * Math.abs(sweepRad)), 3, 96);
    float middle = r - width / 2;
    Color tint = stroke(width, color);
    float cos = MathUtils.cos(fromRad);
    float sin = MathUtils.sin(fromRad);
    for (int i = 1; i <= n; i++) {
      float angle = fromRad + sweepRad * i / n;
      float nextCos = MathUtils.cos(angle);
      float nextSin = MathUtils.sin(angle);
      band(
          x + cos * middle,
          y + sin * middle,
          cos,
          sin,
          x + nextCos * middle,
          y + nextSin * middle,
          nextCos,
          nextSin,
          width,
          tint);
      cos = nextCos;
      sin = nextSin;
    }
  }

  /** Draws a sharp convex figure of {@code count} corners, counter-clockwise, as x, y pairs. */
  public void convex(float[] xy, int count, Color color) {
    whole(color);
    for (int i = 1; i + 1 < count; i += 2) {
      int last = Math.min(i + 2, count - 1);
      room(smooth);
      corner(xy[0], xy[1], 0, 0);
      corner(xy[2 * i], xy[2 * i + 1], 0, 0);
      corner(xy[2 * i + 2], xy[2 * i + 3], 0, 0);
      corner(xy[2 * last], xy[2 * last + 1], 0, 0);
    }
  }

  /**
   * Draws the closed line through {@code count} corners of a convex figure, with pointed joints.
   */
  void outline(float[] xy, int count, float width, Color color) {
    if (count < 3) {
      line(xy[0], xy[1], xy[2], xy[3], width, color);
      return;
    }
    Color tint = stroke(width, color);
    mitre(xy, count - 2, count - 1, 0);
    for (int i = 0, j = count - 1; i < count; j = i++) {
      float beforeX = mitreX;
      float beforeY = mitreY;
      mitre(xy, j, i, i + 1 < count ? i + 1 : 0);
      band(
          xy[2 * j],
          xy[2 * j + 1],
          beforeX,
          beforeY,
          xy[2 * i],
          xy[2 * i + 1],
          mitreX,
          mitreY,
          width,
          tint);
    }
  }

  private void mitre(float[] xy, int before, int at, int after) {
    float ax = xy[2 * at] - xy[2 * before];
    float ay = xy[2 * at + 1] - xy[2 * before + 1];
    float bx = xy[2 * after] - xy[2 * at];
    float by = xy[2 * after + 1] - xy[2 * at + 1];
    float a = 1 / Math.max(Float.MIN_NORMAL, (float) Math.sqrt(ax * ax + ay * ay));
    float b = 1 / Math.max(Float.MIN_NORMAL, (float) Math.sqrt(bx * bx + by * by));
    float size = 1 / Math.max(SHARPEST, 1 + (ax * bx + ay * by) * a * b);
    mitreX = (ay * a + by * b) * size;
    mitreY = -(ax * a + bx * b) * size;
  }

  /** Draws one straight piece of a stroke, between two points and along their mitres. */
  private void band(
      float x1,
      float y1,
      float mx1,
      float my1,
      float x2,
      float y2,
      float mx2,
      float my2,
      float width,
      Color color) {
    whole(color);
    float half = Math.max(width / 2, halfPixel);
    halfHeight = half * scale;
    float reach = half + halfPixel;
    float py = reach * scale;
    room(smooth);
    corner(x1 - reach * mx1, y1 - reach * my1, 0, -py);
    corner(x2 - reach * mx2, y2 - reach * my2, 0, -py);
    corner(x2 + reach * mx2, y2 + reach * my2, 0, py);
    corner(x1 + reach * mx1, y1 + reach * my1, 0, py);
  }

  /** Returns the colour of a line; one thinner than a pixel is fainter. */
  private Color stroke(float width, Color color) {
    float pixels = width * scale;
    if (pixels >= 1) {
      return color;
    }
    thin.set(color).a *= pixels;
    return thin;
  }

  // ---- vertices

  /** Makes the next corners those of a figure without an edge. */
  private void whole(Color color) {
    halfWidth = INSIDE;
    halfHeight = INSIDE;
    radius = 0;
    edge = -1;
    fillBits = color.toFloatBits();
    edgeBits = fillBits;
  }

  /** Makes room for four corners of a figure that a shader draws. */
  private void room(ShaderProgram drawn) {
    if (used == vertices.length || drawn != shader) {
      flush();
      shader = drawn;
    }
  }

  private void corner(float x, float y, float px, float py) {
    float[] v = vertices;
    int at = used;
    v[at] = x;
    v[at + 1] = y;
    v[at + 2] = px;
    v[at + 3] = py;
    v[at + 4] = halfWidth;
    v[at + 5] = halfHeight;
    v[at + 6] = radius;
    v[at + 7] = edge;
    v[at + 8] = fillBits;
    v[at + 9] = edgeBits;
    used = at + STRIDE;
  }

  @Override
  public void dispose() {
    mesh.dispose();
    plain.dispose();
    smooth.dispose();
  }
}

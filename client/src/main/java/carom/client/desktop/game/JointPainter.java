package carom.client.desktop.game;

import carom.client.desktop.paint.Canvas;
import carom.client.desktop.paint.UiColours;
import carom.physics.JointType;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.math.MathUtils;

/** Draws joints that show: rods, ropes, springs, and the ropes of pulleys. */
final class JointPainter {
  private static final float WIDTH_M = 0.035f;
  private static final float WIDTH_PX = 1.2f;

  /** Turns of a spring, half ones. */
  private static final int TURNS = 12;

  private final Canvas canvas;
  private final Color rope = UiColours.rgb(0xc9d4e4);
  private float pixelsPerMetre = 1;
  private float width;

  /** Creates a painter on a canvas. */
  public JointPainter(Canvas canvas) {
    this.canvas = canvas;
  }

  /**
   * Begins a picture.
   *
   * @param scale pixels per metre
   */
  public void begin(float scale) {
    pixelsPerMetre = scale;
    width = Math.max(WIDTH_PX / scale, WIDTH_M);
  }

  /**
   * Draws a joint between two points, metres. Joints that hold bodies at one point don't show.
   *
   * @param sprung whether it gives way as a spring
   * @param rest length of a spring at ease, metres
   * @param alpha opacity, 0..1
   */
  public void draw(
      JointType type,
      float ax,
      float ay,
      float bx,
      float by,
      boolean sprung,
      float rest,
      float alpha) {
    rope.a = alpha;
    float dx = bx - ax;
    float dy = by - ay;
    float length = (float) Math.sqrt(dx * dx + dy * dy);
    if (type == JointType.MOUSE) {
      canvas.line(ax, ay, bx, by, width, UiColours.ACCENT);
      canvas.disc(ax, ay, 4 / pixelsPerMetre, UiColours.ACCENT);
    } else if (type == JointType.DISTANCE && (!sprung || length < 0.3f)) {
      canvas.line(ax, ay, bx, by, width, rope);
    } else if (type == JointType.DISTANCE) {
      spring(ax, ay, dx, dy, length, rest);
    }
  }

  /** Draws the ropes of a pulley: from A over two points of the world to B, metres. */
  public void pulley(
      float ax,
      float ay,
      float groundAX,
      float groundAY,
      float groundBX,
      float groundBY,
      float bx,
      float by,
      float alpha) {
    rope.a = alpha;
    canvas.line(ax, ay, groundAX, groundAY, width, rope);
    canvas.line(groundAX, groundAY, groundBX, groundBY, width, rope);
    canvas.line(groundBX, groundBY, bx, by, width, rope);
  }

  /** Draws a zigzag of a fixed number of turns, wider when it is compressed. */
  private void spring(float ax, float ay, float dx, float dy, float length, float rest) {
    float amplitude = MathUtils.clamp(0.09f * rest * rest / length, 0.04f, 0.25f);
    float px = ax;
    float py = ay;
    for (int i = 1; i <= TURNS; i++) {
      boolean end = i == 1 || i == TURNS;
      float side = end ? 0 : i % 2 == 0 ? amplitude : -amplitude;
      float t = i / (float) TURNS;
      float x = ax + dx * t - dy / length * side;
      float y = ay + dy * t + dx / length * side;
      canvas.line(px, py, x, y, width, rope);
      px = x;
      py = y;
    }
  }
}

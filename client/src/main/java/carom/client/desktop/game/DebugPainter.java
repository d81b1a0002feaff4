package carom.client.desktop.game;

import carom.client.desktop.paint.Canvas;
import carom.client.desktop.paint.ShapePainter;
import carom.physics.Body;
import carom.physics.BodyType;
import carom.physics.Joint;
import carom.physics.JointType;
import carom.physics.World;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Segment;
import carom.physics.geometry.Shape;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.graphics.OrthographicCamera;
import com.badlogic.gdx.math.MathUtils;
import java.util.EnumSet;
import java.util.Set;

/** Draws debug layers of a physics world over the picture. Render thread only. */
final class DebugPainter {
  /** A layer that can be shown. */
  public enum Layer {
    /** The edges of all shapes; sensors, bullets and the front of one-sided lines are marked. */
    SHAPES("shapes"),
    /** The tight bounding boxes of shapes. */
    BOXES("boxes"),
    /** The broadphase's boxes, with their margin. */
    FAT_BOXES("fat boxes"),
    /** The cells of the broadphase's trees; their hue is the depth. */
    TREE("tree"),
    /** The contact points with normal and impulse. */
    CONTACTS("contacts"),
    /** The joints with anchors, axes and limits. */
    JOINTS("joints"),
    /** The centres of mass, with the body's axes and its velocity. */
    CENTRES("centres");

    /** Name for people. */
    public final String label;

    Layer(String label) {
      this.label = label;
    }
  }

  private static final Color SHAPE = new Color(1, 1, 1, 0.9f);
  private static final Color STATIC = new Color(0.6f, 0.7f, 0.85f, 0.9f);
  private static final Color DISABLED = new Color(0.5f, 0.5f, 0.5f, 0.5f);
  private static final Color ASLEEP = new Color(0.55f, 0.6f, 0.9f, 0.8f);
  private static final Color BULLET = new Color(1, 0.4f, 0.9f, 1);
  private static final Color SENSOR = new Color(0.5f, 1, 0.5f, 0.7f);
  private static final Color AABB = new Color(0.35f, 0.85f, 1, 0.45f);
  private static final Color FAT = new Color(0.9f, 0.6f, 1, 0.4f);
  private static final Color CONTACT = new Color(1, 0.35f, 0.3f, 1);
  private static final Color IMPULSE = new Color(1, 0.8f, 0.3f, 1);
  private static final Color JOINT = new Color(1, 0.85f, 0.2f, 0.9f);
  private static final Color LIMIT = new Color(0.4f, 1, 0.8f, 0.8f);
  private static final Color X_AXIS = new Color(1, 0.4f, 0.4f, 1);
  private static final Color Y_AXIS = new Color(0.4f, 1, 0.4f, 1);
  private static final Color VELOCITY = new Color(0.5f, 0.8f, 1, 0.8f);
  private static final float NORMAL_PX = 18;
  private static final float CELL_HUES = 47;

  /** All layers except the fat boxes, which hide the tight ones. */
  private static final Set<Layer> USUAL = EnumSet.complementOf(EnumSet.of(Layer.FAT_BOXES));

  private final Canvas canvas;
  private final ShapePainter shapes;
  private final Color cell = new Color();
  private float lineM;

  /** Creates a painter of debug layers. */
  public DebugPainter(Canvas canvas) {
    this.canvas = canvas;
    shapes = new ShapePainter(canvas);
  }

  /** Draws the usual layers. */
  public <T> void draw(World<T> world, OrthographicCamera camera, float pixelsPerMetre) {
    draw(world, camera, pixelsPerMetre, USUAL);
  }

  /** Draws some layers. */
  public <T> void draw(
      World<T> world, OrthographicCamera camera, float pixelsPerMetre, Set<Layer> layers) {
    lineM = 1.5f / pixelsPerMetre;
    canvas.begin(camera.combined, pixelsPerMetre);
    if (layers.contains(Layer.TREE)) {
      world.forEachTreeCell(
          (minX, minY, maxX, maxY, depth) -> {
            cell.fromHsv(depth * CELL_HUES % 360, 0.6f, 1).a = 0.35f;
            frame(minX, minY, maxX, maxY, cell);
          });
    }
    if (layers.contains(Layer.FAT_BOXES)) {
      world.forEachAabb(true, (minX, minY, maxX, maxY) -> frame(minX, minY, maxX, maxY, FAT));
    }
    if (layers.contains(Layer.BOXES)) {
      world.forEachAabb(false, (minX, minY, maxX, maxY) -> frame(minX, minY, maxX, maxY, AABB));
    }
    if (layers.contains(Layer.SHAPES)) {
      world.forEachBody(this::shapes);
    }
    if (layers.contains(Layer.CENTRES)) {
      world.forEachBody(this::centre);
    }
    if (layers.contains(Layer.JOINTS)) {
      world.forEachJoint(this::joint);
    }
    if (layers.contains(Layer.CONTACTS)) {
      float normal = NORMAL_PX / pixelsPerMetre;
      world.forEachContact(
          (x, y, nx, ny, separation, impulse) -> {
            canvas.disc(x, y, 2 * lineM, CONTACT);
            canvas.line(x, y, x + nx * normal, y + ny * normal, lineM, CONTACT);
            // A hundred times the impulse is three times the length.
            float size = Math.min(4 * normal, 0.5f * normal * (float) Math.sqrt(impulse));
            canvas.line(x, y, x - nx * size, y - ny * size, 1.6f * lineM, IMPULSE);
          });
    }
    canvas.end();
  }

  private <T> void shapes(Body<T> body) {
    shapes.pose(body.x(), body.y(), body.cos(), body.sin());
    for (int i = 0; i < body.shapeCount(); i++) {
      Shape shape = body.shape(i);
      shapes.outline(shape, lineM, color(body, i));
      for (Convex part : shape.parts()) {
        if (part instanceof Segment segment && segment.isOneSided()) {
          front(segment);
        }
      }
    }
  }

  private static <T> Color color(Body<T> body, int i) {
    if (body.sensor(i)) {
      return SENSOR;
    }
    if (!body.isEnabled()) {
      return DISABLED;
    }
    if (body.type() == BodyType.DYNAMIC && !body.awake()) {
      return ASLEEP;
    }
    return body.isBullet() ? BULLET : body.type() == BodyType.DYNAMIC ? SHAPE : STATIC;
  }

  /** Draws a mark on the side where a line is solid. */
  private void front(Segment s) {
    float x = (s.vertexX(0) + s.vertexX(1)) / 2;
    float y = (s.vertexY(0) + s.vertexY(1)) / 2;
    float tick = 6 * lineM;
    canvas.line(
        shapes.worldX(x, y),
        shapes.worldY(x, y),
        shapes.worldX(x + s.normalX(0) * tick, y + s.normalY(0) * tick),
        shapes.worldY(x + s.normalX(0) * tick, y + s.normalY(0) * tick),
        lineM,
        SENSOR);
  }

  private <T> void centre(Body<T> body) {
    if (body.type() == BodyType.STATIC) {
      return;
    }
    float x = body.centerX();
    float y = body.centerY();
    float arm = 6 * lineM;
    canvas.line(x, y, x + arm * body.cos(), y + arm * body.sin(), lineM, X_AXIS);
    canvas.line(x, y, x - arm * body.sin(), y + arm * body.cos(), lineM, Y_AXIS);
    canvas.line(x, y, x + 0.1f * body.velocityX(), y + 0.1f * body.velocityY(), lineM, VELOCITY);
  }

  /** Draws a joint from body to anchor to anchor to body, with its limits. */
  private <T> void joint(Joint<T> joint) {
    float ax = joint.anchorAX();
    float ay = joint.anchorAY();
    float bx = joint.anchorBX();
    float by = joint.anchorBY();
    Body<T> a = joint.bodyA();
    Body<T> b = joint.bodyB();
    if (a != null) {
      canvas.line(a.centerX(), a.centerY(), ax, ay, lineM, JOINT);
    }
    if (joint.type() == JointType.PULLEY) {
      canvas.line(ax, ay, joint.groundAX(), joint.groundAY(), lineM, JOINT);
      canvas.line(joint.groundBX(), joint.groundBY(), bx, by, lineM, JOINT);
    } else {
      canvas.line(ax, ay, bx, by, lineM, JOINT);
    }
    canvas.line(bx, by, b.centerX(), b.centerY(), lineM, JOINT);
    canvas.disc(ax, ay, 2 * lineM, JOINT);
    canvas.disc(bx, by, 2 * lineM, JOINT);
    float arm = 16 * lineM;
    if (joint.isDriven()) {
      canvas.ring(bx, by, arm / 2, lineM, JOINT);
    }
    switch (joint.type()) {
      case REVOLUTE -> {
        if (joint.isLimited()) {
          // B's direction now, less its angle, is where 0 is.
          float zero = MathUtils.atan2(b.centerY() - by, b.centerX() - bx) - joint.angle();
          float sweep = joint.upper() - joint.lower();
          canvas.arc(bx, by, arm, lineM, zero + joint.lower(), sweep, LIMIT);
        }
      }
      case PRISMATIC, WHEEL -> {
        float from = joint.isLimited() ? joint.lower() : -arm;
        float to = joint.isLimited() ? joint.upper() : arm;
        float x = joint.axisX();
        float y = joint.axisY();
        canvas.line(ax + from * x, ay + from * y, ax + to * x, ay + to * y, lineM, LIMIT);
        if (joint.isLimited()) {
          stop(ax, ay, x, y, from);
          stop(ax, ay, x, y, to);
        }
      }
      case DISTANCE -> {
        float dx = bx - ax;
        float dy = by - ay;
        float length = (float) Math.sqrt(dx * dx + dy * dy);
        if (joint.isLimited() && length > 0) {
          stop(ax, ay, dx / length, dy / length, joint.lower());
          stop(ax, ay, dx / length, dy / length, joint.upper());
        }
      }
      default -> {}
    }
  }

  /** Draws a bar across an axis. */
  private void stop(float x, float y, float axisX, float axisY, float at) {
    float px = x + at * axisX;
    float py = y + at * axisY;
    float arm = 4 * lineM;
    canvas.line(
        px - axisY * arm, py + axisX * arm, px + axisY * arm, py - axisX * arm, lineM, LIMIT);
  }

  private void frame(float minX, float minY, float maxX, float maxY, Color color) {
    canvas.frame(minX, minY, maxX - minX, maxY - minY, lineM, color);
  }
}

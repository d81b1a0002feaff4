package carom.client.desktop;

import carom.physics.Body;
import carom.physics.Joint;
import carom.physics.World;
import carom.sim.Entity;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.graphics.OrthographicCamera;

/**
 * What the physics sees: shapes, AABBs, KD-tree cells, joints and contacts of the predicted world,
 * over the picture. Render thread only.
 */
final class DebugPainter {
  private static final Color SHAPE = new Color(1, 1, 1, 0.9f);
  private static final Color SENSOR = new Color(0.5f, 1, 0.5f, 0.7f);
  private static final Color AABB = new Color(0.35f, 0.85f, 1, 0.45f);
  private static final Color CONTACT = new Color(1, 0.35f, 0.3f, 1);
  private static final Color JOINT = new Color(1, 0.85f, 0.2f, 0.9f);
  private static final float NORMAL_M = 0.5f;
  private static final float CELL_HUES = 47;

  private final Canvas canvas;
  private final ShapePainter shapes;
  private final float[] corners = new float[8];
  private final Color cell = new Color();
  private float lineM;

  DebugPainter(Canvas canvas) {
    this.canvas = canvas;
    shapes = new ShapePainter(canvas);
  }

  void draw(World<Entity> world, OrthographicCamera camera, float pixelsPerMetre) {
    lineM = 1.5f / pixelsPerMetre;
    canvas.begin(camera.combined, pixelsPerMetre);
    world.forEachTreeCell(
        (minX, minY, maxX, maxY, depth) -> {
          cell.fromHsv(depth * CELL_HUES % 360, 0.6f, 1).a = 0.35f;
          frame(minX, minY, maxX, maxY, cell);
        });
    world.forEachAabb(false, (minX, minY, maxX, maxY) -> frame(minX, minY, maxX, maxY, AABB));
    world.forEachBody(
        body -> {
          shapes.pose(body.x(), body.y(), body.cos(), body.sin());
          for (int i = 0; i < body.shapeCount(); i++) {
            shapes.outline(body.shape(i), lineM, body.sensor(i) ? SENSOR : SHAPE);
          }
        });
    world.forEachJoint(joint -> joint(joint, 3 / pixelsPerMetre));
    world.forEachContact(
        (x, y, normalX, normalY, separation, impulse) -> {
          canvas.disc(x, y, 3.5f / pixelsPerMetre, CONTACT);
          canvas.line(x, y, x + normalX * NORMAL_M, y + normalY * NORMAL_M, lineM, CONTACT);
        });
    canvas.end();
  }

  /** From body to anchor to anchor to body. */
  private void joint(Joint<Entity> joint, float radius) {
    float ax = joint.anchorAX();
    float ay = joint.anchorAY();
    float bx = joint.anchorBX();
    float by = joint.anchorBY();
    Body<Entity> a = joint.bodyA();
    Body<Entity> b = joint.bodyB();
    if (a != null) {
      canvas.line(a.centerX(), a.centerY(), ax, ay, lineM, JOINT);
    }
    canvas.line(ax, ay, bx, by, lineM, JOINT);
    canvas.line(bx, by, b.centerX(), b.centerY(), lineM, JOINT);
    canvas.disc(ax, ay, radius, JOINT);
    canvas.disc(bx, by, radius, JOINT);
  }

  private void frame(float minX, float minY, float maxX, float maxY, Color color) {
    corners[0] = minX;
    corners[1] = minY;
    corners[2] = maxX;
    corners[3] = minY;
    corners[4] = maxX;
    corners[5] = maxY;
    corners[6] = minX;
    corners[7] = maxY;
    canvas.outline(corners, 4, lineM, color);
  }
}

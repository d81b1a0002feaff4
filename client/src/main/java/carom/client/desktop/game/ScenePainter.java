package carom.client.desktop.game;

import carom.client.desktop.paint.Canvas;
import carom.client.desktop.paint.ShapePainter;
import carom.client.desktop.paint.UiColours;
import carom.physics.Body;
import carom.physics.BodyType;
import carom.physics.Joint;
import carom.physics.JointType;
import carom.physics.World;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Segment;
import carom.physics.geometry.Shape;
import carom.physics.math.Aabb;
import carom.physics.particles.Particles;
import carom.sim.pool.ShownParticles;
import carom.sim.scene.SceneColors;
import carom.sim.scene.SceneRun;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.graphics.OrthographicCamera;

/**
 * Draws the world of a scene, in metres: what the materials' tags say in colour, see {@link
 * SceneColors}. Render thread only.
 */
final class ScenePainter {
  private static final float SHADOW_X = 0.12f;
  private static final float SHADOW_Y = -0.16f;
  private static final float EDGE_M = 0.045f;
  private static final float GROUND_M = 0.4f;

  /** Diameter of a particle relative to its spacing: water has no holes. */
  private static final float PARTICLE = 1.25f;

  /** Share of white that a particle gets per m/s. */
  private static final float FOAM = 0.05f;

  /** Colour towards which sleeping bodies fade. */
  private static final int ASLEEP = 0x2b3646;

  /** Size below which bodies have no edges and shadows, px. */
  private static final float SMALL_PX = 7;

  private final Canvas canvas;
  private final ShapePainter shapes;
  private final JointPainter joints;
  private final Color fill = new Color();
  private final Color edge = new Color();
  private final Color lower = UiColours.rgb(0x0e1420);
  private final Color upper = UiColours.rgb(0x1d2838);
  private final Color gridLine = new Color(0.6f, 0.75f, 1, 0.05f);
  private final Aabb box = new Aabb();
  private final Aabb seen = new Aabb();
  private final float[] band = new float[8];
  private float pixelsPerMetre;
  private float edgeM;

  ScenePainter(Canvas canvas) {
    this.canvas = canvas;
    shapes = new ShapePainter(canvas);
    joints = new JointPainter(canvas);
  }

  /** Draws everything that the camera sees. */
  void draw(SceneRun run, OrthographicCamera camera, float scale) {
    World<String> world = run.world();
    pixelsPerMetre = scale;
    edgeM = Math.min(EDGE_M, 2.2f / scale);
    float halfWidth = camera.viewportWidth / 2;
    float halfHeight = camera.viewportHeight / 2;
    seen.set(
        camera.position.x - halfWidth,
        camera.position.y - halfHeight,
        camera.position.x + halfWidth,
        camera.position.y + halfHeight);
    canvas.begin(camera.combined, scale);
    backdrop();
    world.forEachBody(this::shadow);
    world.forEachBody(body -> body(body, true));
    run.particles().forEach(this::particles);
    world.forEachBody(body -> body(body, false));
    joints.begin(scale);
    world.forEachJoint(this::joint);
    canvas.end();
  }

  private void backdrop() {
    canvas.gradient(seen.minX, seen.minY, seen.width(), seen.height(), lower, upper);
    float step = 1;
    while (step * pixelsPerMetre < 40) {
      step *= 5;
    }
    canvas.grid(seen.minX, seen.minY, seen.maxX, seen.maxY, step, gridLine);
  }

  private <T> boolean visible(Body<T> body) {
    body.aabb(box);
    return box.overlaps(seen);
  }

  private boolean small() {
    return Math.max(box.width(), box.height()) * pixelsPerMetre < SMALL_PX;
  }

  private <T> void shadow(Body<T> body) {
    if (!visible(body) || small()) {
      return;
    }
    shapes.pose(body.x() + SHADOW_X, body.y() + SHADOW_Y, body.cos(), body.sin());
    for (int i = 0; i < body.shapeCount(); i++) {
      if (!body.sensor(i)) {
        shapes.fill(body.shape(i), UiColours.SHADOW);
      }
    }
  }

  /** Draws particles; fast ones are lighter, like foam. */
  private void particles(ShownParticles some) {
    Particles all = some.particles();
    float size = PARTICLE * all.spacing();
    boolean small = size * pixelsPerMetre < SMALL_PX;
    for (int i = 0; i < all.count(); i++) {
      float x = all.x(i);
      float y = all.y(i);
      if (!seen.contains(x, y)) {
        continue;
      }
      float speed = Math.abs(all.velocityX(i)) + Math.abs(all.velocityY(i));
      int rgb = SceneColors.mix(some.rgb(), SceneColors.PAPER, Math.min(0.6f, speed * FOAM));
      UiColours.shade(rgb, 1, 1, fill);
      if (small) {
        canvas.rect(x - size / 2, y - size / 2, size, size, fill);
      } else {
        canvas.disc(x, y, size / 2, fill);
      }
    }
  }

  /** Draws the shapes of a body that are behind, sensors and statics, or those in front. */
  private <T> void body(Body<T> body, boolean behind) {
    if (!visible(body)) {
      return;
    }
    shapes.pose(body.x(), body.y(), body.cos(), body.sin());
    for (int i = 0; i < body.shapeCount(); i++) {
      boolean back = body.sensor(i) || body.type() == BodyType.STATIC;
      if (back == behind) {
        shape(body, i);
      }
    }
  }

  private <T> void shape(Body<T> body, int i) {
    Shape shape = body.shape(i);
    int rgb = body.material(i).tag();
    if (rgb == 0) {
      rgb = untagged(body);
    }
    if (body.sensor(i)) {
      UiColours.shade(rgb, 1, 0.22f, fill);
      shapes.paint(shape, fill, edgeM, UiColours.shade(rgb, 1.2f, 0.6f, edge));
      return;
    }
    boolean still = body.type() == BodyType.STATIC;
    if (body.type() == BodyType.DYNAMIC && !body.awake()) {
      rgb = SceneColors.mix(rgb, ASLEEP, 0.5f);
    }
    UiColours.shade(rgb, 1, 1, fill);
    UiColours.shade(rgb, still ? 1.25f : 0.62f, 1, edge);
    if (small()) {
      shapes.fill(shape, fill);
      return;
    }
    for (Convex part : shape.parts()) {
      if (part instanceof Segment segment) {
        line(segment, rgb);
      }
    }
    if (shape.area() > 0) {
      shapes.paint(shape, fill, edgeM, edge);
    }
    if (shape instanceof Circle circle && !still) {
      spoke(circle);
    }
  }

  /** Draws a spoke, so that rolling shows. */
  private void spoke(Circle circle) {
    float x = circle.centerX();
    float y = circle.centerY();
    canvas.line(
        shapes.worldX(x, y),
        shapes.worldY(x, y),
        shapes.worldX(x + circle.radius() * 0.85f, y),
        shapes.worldY(x + circle.radius() * 0.85f, y),
        edgeM,
        edge);
  }

  /** Draws a line, and ground behind it if it is solid from one side. */
  private void line(Segment s, int rgb) {
    float x0 = s.vertexX(0);
    float y0 = s.vertexY(0);
    float x1 = s.vertexX(1);
    float y1 = s.vertexY(1);
    if (s.isOneSided()) {
      corner(0, x0, y0);
      depth(1, s, 0);
      depth(2, s, 1);
      corner(3, x1, y1);
      canvas.convex(band, 4, UiColours.shade(rgb, 0.75f, 1, fill));
    }
    canvas.line(
        shapes.worldX(x0, y0),
        shapes.worldY(x0, y0),
        shapes.worldX(x1, y1),
        shapes.worldY(x1, y1),
        2.5f * edgeM,
        UiColours.shade(rgb, 1.3f, 1, fill));
    UiColours.shade(rgb, 1, 1, fill);
  }

  /** Sets the corner behind an end of a line, halfway towards the next line's if there is one. */
  private void depth(int i, Segment s, int end) {
    float nx = s.normalX(0); // the first edge's normal points to the front
    float ny = s.normalY(0);
    float x = s.vertexX(end);
    float y = s.vertexY(end);
    float scale = GROUND_M;
    if (s.isLinked(end)) {
      float along = end == 0 ? 1 : -1;
      float dx = along * (x - s.ghostX(end));
      float dy = along * (y - s.ghostY(end));
      float length = (float) Math.sqrt(dx * dx + dy * dy);
      float left =
          (s.vertexX(1) - s.vertexX(0)) * ny - (s.vertexY(1) - s.vertexY(0)) * nx; // of the front
      float turn = Math.copySign(1 / length, left);
      float ox = -dy * turn;
      float oy = dx * turn;
      scale /= Math.max(0.25f, 1 + nx * ox + ny * oy);
      nx += ox;
      ny += oy;
    }
    corner(i, x - scale * nx, y - scale * ny);
  }

  private void corner(int i, float x, float y) {
    band[2 * i] = shapes.worldX(x, y);
    band[2 * i + 1] = shapes.worldY(x, y);
  }

  /** Returns a colour that tells neighbours apart, for bodies without one. */
  private static int untagged(Body<?> body) {
    int rgb = SceneColors.untagged(body.type(), body.shape(0));
    return body.type() == BodyType.DYNAMIC
        ? SceneColors.mix(rgb, SceneColors.PAPER, body.index() * 7 % 11 / 30f)
        : rgb;
  }

  private <T> void joint(Joint<T> joint) {
    float ax = joint.anchorAX();
    float ay = joint.anchorAY();
    float bx = joint.anchorBX();
    float by = joint.anchorBY();
    if (joint.type() == JointType.PULLEY) {
      joints.pulley(
          ax,
          ay,
          joint.groundAX(),
          joint.groundAY(),
          joint.groundBX(),
          joint.groundBY(),
          bx,
          by,
          1);
    } else {
      joints.draw(joint.type(), ax, ay, bx, by, joint.isSprung(), joint.rest(), 1);
    }
  }
}

package carom.lab.bench;

import static java.nio.charset.StandardCharsets.UTF_8;

import carom.lab.measure.BenchRow;
import carom.physics.Body;
import carom.physics.BodyType;
import carom.physics.Joint;
import carom.physics.JointType;
import carom.physics.World;
import carom.physics.geometry.Convex;
import carom.sim.scene.Scene;
import carom.sim.scene.SceneReport;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * A scene as text, for programs that measure engines outside the JVM, and the poses in which such a
 * program leaves it.
 *
 * <p>Each line is a word and its numbers, floats in the fewest digits that give the same bits:
 *
 * <pre>
 * run WARM MEASURED TICKRATE            steps untimed and timed, ticks a second
 * world GRAVITY_X GRAVITY_Y SLEEPING    m/s^2; 1 if bodies may fall asleep, else 0
 * body TYPE X Y COS SIN VX VY W GRAVITY_SCALE AWAKE      TYPE is static, kinematic or dynamic
 * shape DENSITY FRICTION RESTITUTION GROUP RADIUS N X1 Y1 ... XN YN     of the body before
 * revolute A B X Y                      numbers of two bodies from 0, and the point in the world
 * </pre>
 *
 * <p>A shape is N points with a radius around them: a circle has one point, a capsule two. The
 * poses are a line {@code X Y COS SIN VX VY W AWAKE} for each body, in the same order.
 */
final class SceneFile implements AutoCloseable {
  private static final int NUMBERS_OF_A_POSE = 8;

  private final BenchScene how;
  private final World<String> world;
  private final Path folder;

  private SceneFile(BenchScene how, World<String> world, Path folder) {
    this.how = how;
    this.world = world;
    this.folder = folder;
  }

  /**
   * Writes a scene into a new temporary folder.
   *
   * @throws IOException if it can't be written
   * @throws UnsupportedOperationException if the scene has joints other than revolute ones
   */
  static SceneFile of(BenchScene how) throws IOException {
    Scene scene = how.scene();
    World<String> world = scene.start().world();
    SceneFile file = new SceneFile(how, world, Files.createTempDirectory("carom-scene"));
    try {
      Files.writeString(file.scene(), file.text(scene.tickRate()));
    } catch (IOException | RuntimeException e) {
      file.close();
      throw e;
    }
    return file;
  }

  /** Returns the path of the scene. */
  Path scene() {
    return folder.resolve("scene.txt");
  }

  /** Returns the path to which the program may write the poses at the end. */
  Path poses() {
    return folder.resolve("poses.txt");
  }

  private String text(int tickRate) {
    StringBuilder out = new StringBuilder();
    line(out, "run", how.warm(), how.measured(), tickRate);
    line(out, "world", world.gravityX(), world.gravityY(), world.def().sleeping() ? 1 : 0);
    List<Body<String>> bodies = new ArrayList<>();
    world.forEachBody(bodies::add);
    int[] numbers = new int[world.slotCount()];
    for (int i = 0; i < bodies.size(); i++) {
      numbers[bodies.get(i).index()] = i;
      body(out, bodies.get(i));
    }
    world.forEachJoint(joint -> joint(out, joint, numbers));
    return out.toString();
  }

  private static void body(StringBuilder out, Body<?> body) {
    line(
        out,
        "body " + body.type().name().toLowerCase(Locale.ROOT),
        body.x(),
        body.y(),
        body.cos(),
        body.sin(),
        body.velocityX(),
        body.velocityY(),
        body.angularVelocity(),
        body.gravityScale(),
        body.awake() ? 1 : 0);
    for (int i = 0; i < body.shapeCount(); i++) {
      for (Convex part : body.shape(i).parts()) {
        List<Number> numbers = new ArrayList<>();
        numbers.add(body.material(i).density());
        numbers.add(body.material(i).friction());
        numbers.add(body.material(i).restitution());
        numbers.add(body.filter(i).group());
        numbers.add(part.radius());
        numbers.add(part.vertexCount());
        for (int k = 0; k < part.vertexCount(); k++) {
          numbers.add(part.vertexX(k));
          numbers.add(part.vertexY(k));
        }
        line(out, "shape", numbers.toArray(new Number[0]));
      }
    }
  }

  private static void joint(StringBuilder out, Joint<?> joint, int[] numbers) {
    if (joint.type() != JointType.REVOLUTE) {
      throw new UnsupportedOperationException("joint " + joint.type());
    }
    int a = numbers[joint.bodyA().index()];
    int b = numbers[joint.bodyB().index()];
    line(out, "revolute", a, b, joint.anchorAX(), joint.anchorAY());
  }

  private static void line(StringBuilder out, String word, Number... numbers) {
    out.append(word);
    for (Number number : numbers) {
      out.append(' ').append(number);
    }
    out.append('\n');
  }

  /**
   * Returns a copy of a row with the figures of the poses that the program has written, judged as
   * those of the other engines. Without poses the row stays as it is.
   *
   * @throws IOException if there are poses that can't be read
   */
  BenchRow judged(BenchRow row) throws IOException {
    if (!row.isMeasured() || !Files.exists(poses())) {
      return row;
    }
    List<String> lines = Files.readAllLines(poses(), UTF_8);
    List<Body<String>> bodies = new ArrayList<>();
    world.forEachBody(bodies::add);
    if (lines.size() != bodies.size()) {
      throw new IOException("poses=" + lines.size() + ", bodies=" + bodies.size());
    }
    int awake = 0;
    for (int i = 0; i < bodies.size(); i++) {
      awake += place(bodies.get(i), lines.get(i));
    }
    SceneReport end = SceneReport.of(world);
    return row.withEnd(world.jointCount(), awake, end)
        .withFault(row.fault().isEmpty() ? how.gate().fault(end, awake) : row.fault());
  }

  /** Returns 1 if the body is awake and not static. */
  private static int place(Body<?> body, String line) throws IOException {
    String[] words = line.split(" ");
    if (words.length != NUMBERS_OF_A_POSE) {
      throw new IOException("a pose has " + NUMBERS_OF_A_POSE + " numbers: " + line);
    }
    float[] pose = new float[NUMBERS_OF_A_POSE];
    for (int i = 0; i < pose.length; i++) {
      try {
        pose[i] = Float.parseFloat(words[i]);
      } catch (NumberFormatException e) {
        throw new IOException("not a number in a pose: " + line, e);
      }
    }
    if (body.type() == BodyType.DYNAMIC) {
      body.setPose(pose[0], pose[1], pose[2], pose[3]);
      body.setVelocity(pose[4], pose[5]);
      body.setAngularVelocity(pose[6]);
    }
    return body.type() != BodyType.STATIC && pose[7] != 0 ? 1 : 0;
  }

  /** Deletes the files. */
  @Override
  public void close() {
    scene().toFile().delete();
    poses().toFile().delete();
    folder.toFile().delete();
  }
}

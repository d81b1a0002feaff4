package carom.physics;

import carom.physics.archive.Archive;
import carom.physics.archive.ArchiveWriter;
import carom.physics.geometry.MassData;
import carom.physics.rows.JointDefRow;

/**
 * Passes the arguments of calls that are objects through an archive: definitions, values of edits,
 * and whole states. The same lines write and read.
 */
final class CallValues {
  private static final float MOST = Float.MAX_VALUE;
  private static final int NONE = 0;
  private static final int BODY = 1;
  private static final int INTS = 2;
  private static final int SHAPES = 3;
  private static final int MASS = 4;
  private static final int LOCKS = 5;
  private static final int CONSTANTS = 6;
  private static final int STATE = 7;

  private CallValues() {}

  /**
   * Passes a value.
   *
   * @param value ignored when reading; a state can only be written
   * @return the value; of a state null, as {@link World#read} reads it from what follows
   */
  static Object pass(Archive a, Object value) {
    int kind = a.integer("kind of value", a.reads() ? 0 : kindOf(value), NONE, STATE);
    return switch (kind) {
      case NONE -> null;
      case BODY -> passBody(a, (BodyDef) value);
      case INTS -> passInts(a, (int[]) value);
      case SHAPES -> passShapes(a, (EditQueue.ShapesChange) value);
      case MASS -> new BodyArchive(a).passMass((MassData) value);
      case LOCKS -> passLocks(a, (MotionLocks) value);
      case CONSTANTS -> passDef(a, (WorldDef) value);
      default -> {
        if (!a.reads()) {
          ((WorldState) value).write((ArchiveWriter) a);
        }
        yield null;
      }
    };
  }

  private static int kindOf(Object value) {
    if (value == null) {
      return NONE;
    } else if (value instanceof BodyDef) {
      return BODY;
    } else if (value instanceof int[]) {
      return INTS;
    } else if (value instanceof EditQueue.ShapesChange) {
      return SHAPES;
    } else if (value instanceof MassData) {
      return MASS;
    } else if (value instanceof MotionLocks) {
      return LOCKS;
    } else if (value instanceof WorldDef) {
      return CONSTANTS;
    } else if (value instanceof WorldState) {
      return STATE;
    }
    throw new IllegalStateException("no layout for a call's value of " + value.getClass());
  }

  private static BodyDef passBody(Archive a, BodyDef given) {
    BodyDef d = given;
    int type = a.integer("type of body", a.reads() ? 0 : d.type.ordinal(), 0, 2);
    if (a.reads()) {
      d = new BodyDef(BodyType.values()[type]);
    }
    d.x = a.number("x", d.x, -MOST, MOST);
    d.y = a.number("y", d.y, -MOST, MOST);
    d.angle = a.number("angle", d.angle, -MOST, MOST);
    d.vx = a.number("velocity x", d.vx, -MOST, MOST);
    d.vy = a.number("velocity y", d.vy, -MOST, MOST);
    d.angularVelocity = a.number("angular velocity", d.angularVelocity, -MOST, MOST);
    d.linearDamping = a.number("linear damping", d.linearDamping, 0, MOST);
    d.angularDamping = a.number("angular damping", d.angularDamping, 0, MOST);
    d.gravityScale = a.number("gravity scale", d.gravityScale, -MOST, MOST);
    d.locks = passLocks(a, d.locks);
    d.bullet = a.flag("bullet", d.bullet);
    d.sleepAllowed = a.flag("sleep allowed", d.sleepAllowed);
    d.sleepSpeed = a.number("sleep speed", d.sleepSpeed, -MOST, MOST);
    d.awake = a.flag("awake", d.awake);
    BodyArchive archive = new BodyArchive(a);
    d.mass = archive.passMass(d.mass);
    ShapeDef[] shapes = archive.passShapes(d.shapes.toArray(new ShapeDef[0]));
    if (a.reads()) {
      d.shapes.addAll(java.util.List.of(shapes));
    }
    return d;
  }

  private static MotionLocks passLocks(Archive a, MotionLocks given) {
    return new MotionLocks(
        a.flag("lock x", given != null && given.linearX()),
        a.flag("lock y", given != null && given.linearY()),
        a.flag("lock angle", given != null && given.angularZ()));
  }

  private static int[] passInts(Archive a, int[] given) {
    int n = a.count("ints", a.reads() ? 0 : given.length, JointDefRow.INTS, Integer.BYTES);
    int[] ints = a.reads() ? new int[n] : given;
    a.integers("int", ints, n, Integer.MIN_VALUE, Integer.MAX_VALUE);
    return ints;
  }

  private static EditQueue.ShapesChange passShapes(Archive a, EditQueue.ShapesChange given) {
    boolean reads = a.reads();
    int most = Integer.MAX_VALUE;
    return new EditQueue.ShapesChange(
        new BodyArchive(a).passShapes(reads ? null : given.after),
        a.integer("place of shape", reads ? 0 : given.at, 0, most),
        a.integer("shapes removed", reads ? 0 : given.removed, 0, most),
        a.integer("shapes added", reads ? 0 : given.added, 0, most));
  }

  /** Passes all constants of a world. When reading, the given ones are ignored. */
  static WorldDef passDef(Archive a, WorldDef given) {
    return (a.reads() ? new WorldDef() : given).passed(a, true).passed(a, false);
  }
}

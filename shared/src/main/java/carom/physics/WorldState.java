package carom.physics;

import carom.physics.archive.Archive;
import carom.physics.archive.ArchiveException;
import carom.physics.archive.ArchiveReader;
import carom.physics.archive.ArchiveWriter;
import carom.physics.dynamics.DynamicsState;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.joint.JointStore;
import carom.physics.geometry.MassData;
import carom.physics.math.Limits;
import java.util.function.IntFunction;

/**
 * The state of a world at one moment. {@link World#save} makes it and {@link World#restore}
 * restores it; {@link #write} and {@link World#read} turn it into bytes and back.
 *
 * <p>A state belongs to the world that made it. Saving into the same object again costs no
 * allocation unless the world grew.
 */
public final class WorldState {
  /** Version of the byte format. Every change of the format raises it. */
  private static final int FORMAT = 2;

  private static final BodyType[] BODY_TYPES = BodyType.values();
  private static final JointType[] JOINT_TYPES = JointType.values();

  final World<?> owner;

  /** The constants that the world has. */
  WorldDef def;

  /** The version of the arithmetic that computed the state. */
  int physicsVersion = World.PHYSICS_VERSION;

  final DynamicsState dynamics;
  final Handles<?> handles = new Handles<>();

  WorldState(World<?> owner) {
    this.owner = owner;
    def = owner.firstDef();
    dynamics = new DynamicsState(owner.def());
  }

  /**
   * Returns how many bytes the last {@link World#save} into this state copied. Numbers that no step
   * changes, such as masses, and handles are only copied if one of them changed since the save
   * before.
   *
   * @return bytes of bodies, contacts and joints
   */
  public long bytes() {
    return dynamics.bytes();
  }

  /**
   * Returns the version of the arithmetic that computed the state, see {@link
   * World#PHYSICS_VERSION}. A world that restores a state of another version goes on from it, but
   * not to the bit as the one that was saved.
   *
   * @return 1 or more; this build's own unless the state was read from bytes of another build
   */
  public int physicsVersion() {
    return physicsVersion;
  }

  /**
   * Appends the state to an archive. It writes everything that {@link World#stateHash} covers,
   * shapes, materials and filters included, and the touching contacts. It doesn't write users.
   * Meanwhile the world may be stepped, even by another thread.
   *
   * @param archive receives about 100 bytes per body and 90 per touching contact
   * @throws IllegalArgumentException if the world has values beyond 1e30, or not a number
   */
  public void write(ArchiveWriter archive) {
    Limits.notNull("archive", archive);
    pass(archive);
  }

  /** Reads a state with handles: those of the world where they fit, else new ones for the users. */
  static <T> WorldState read(ArchiveReader archive, World<T> world, IntFunction<T> users) {
    WorldState s = new WorldState(world);
    try {
      s.pass(archive);
    } catch (ArchiveException e) {
      throw e;
    } catch (IllegalArgumentException e) {
      throw archive.refused(e.getMessage());
    }
    BodyStore bodies = s.dynamics.bodies();
    for (int slot = 0; slot < bodies.slots(); slot++) {
      if (bodies.type[slot] != BodyStore.FREE) {
        s.handles.handle(slot, s.handle(world, slot, users));
      }
    }
    JointStore joints = s.dynamics.joints();
    for (int j = 0; j < joints.slots(); j++) {
      if (joints.type[j] != JointStore.FREE) {
        s.handles.handle(j, handle(world, joints, j));
      }
    }
    return s;
  }

  private <T> Body<T> handle(World<T> world, int slot, IntFunction<T> users) {
    Body<T> known = world.body(slot);
    int generation = dynamics.bodies().generation(slot);
    T user = users.apply(slot);
    if (known != null
        && known.generation() == generation
        && (user == null || user == known.user())) {
      keepShapeUsers(handles.shapes(slot), known.shapes());
      return known;
    }
    BodyType type = BODY_TYPES[dynamics.bodies().type[slot]];
    return new Body<>(world, world.store(), slot, generation, type, handles.shapes(slot), user);
  }

  /** Lets shapes that were read stand for what those of the same numbers stand for in the world. */
  private static void keepShapeUsers(ShapeDef[] read, ShapeDef[] known) {
    for (int i = 0; i < read.length && i < known.length; i++) {
      if (known[i].user() != null) {
        read[i] = read[i].withUser(known[i].user());
      }
    }
  }

  private static <T> Joint<T> handle(World<T> world, JointStore read, int j) {
    Joint<T> known = world.joint(j);
    JointType type = JOINT_TYPES[read.type[j]];
    int generation = read.generation(j);
    boolean same = known != null && known.generation() == generation && known.type() == type;
    return same ? known : new Joint<>(world, world.dynamics().joints(), j, generation, type);
  }

  /** Passes all but handles through an archive. When reading, the state must be empty. */
  private void pass(Archive a) {
    a.integer("format of the state", FORMAT, FORMAT, FORMAT);
    physicsVersion = a.integer("physics version", physicsVersion, 1, Integer.MAX_VALUE);
    WorldDef first = owner.firstDef();
    long constants = a.bits("constants of the world", first.hash());
    a.require(constants == first.hash(), "the world was made with another WorldDef than this one");
    if (a.flag("constants were changed", def != first)) {
      WorldDef passed = (a.reads() ? first : def).passed(a, false);
      def = a.reads() ? passed : def;
    }
    dynamics.passSlots(a);
    BodyStore bodies = dynamics.bodies();
    BodyArchive archive = new BodyArchive(a);
    for (int slot = 0; slot < bodies.slots(); slot++) {
      if (bodies.type[slot] != BodyStore.FREE) {
        ShapeDef[] shapes = archive.passShapes(a.reads() ? null : handles.shapes(slot));
        MassData own = archive.passMass(a.reads() ? null : handles.ownMass(slot));
        if (a.reads()) {
          handles.consistsOf(slot, shapes, own);
          dynamics.embody(a, slot, World.specs(shapes), own);
        }
      }
    }
    dynamics.passRest(a);
  }
}

package carom.physics.dynamics;

import carom.physics.archive.Archive;
import carom.physics.dynamics.body.BodyMaker;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeSpec;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.contact.ContactArchive;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.contact.SleepingContacts;
import carom.physics.dynamics.joint.JointStore;
import carom.physics.dynamics.store.Stamp;
import carom.physics.geometry.MassData;
import carom.physics.settings.Settings;

/**
 * The state of a world at one moment: copies of its stores. Trees, fat boxes and rows of parts that
 * are close but don't touch are not in it; they follow from the rest.
 */
public final class DynamicsState {
  /** Most parts of all bodies together that are read: what bounds the memory they take. */
  public static final int MAX_PARTS = 1 << 20;

  final BodyStore bodies = new BodyStore();
  final ShapeTable parts;
  final ContactTable contacts = new ContactTable();
  final JointStore joints = new JointStore();
  final SleepingContacts sleepers = new SleepingContacts();
  final Stamp sleep = new Stamp();
  private final BodyMaker maker;
  private long bytes;

  /**
   * Makes an empty state to save into.
   *
   * @param settings of the world
   */
  public DynamicsState(Settings settings) {
    parts = new ShapeTable(settings);
    maker = new BodyMaker(bodies, parts);
  }

  /**
   * Returns what the last save copied, apart from shapes, which are copied if bodies came or went,
   * and from contacts, which are shared until one side writes.
   *
   * @return bytes of bodies and joints
   */
  public long bytes() {
    return bytes;
  }

  void take(BodyStore fromBodies, ContactTable fromContacts, JointStore fromJoints) {
    fromContacts.copyTo(contacts);
    bytes = fromBodies.copyTo(bodies) + fromJoints.copyTo(joints);
  }

  void takeSleep(SleepingContacts fromSleepers, Stamp fromSleep) {
    if (!fromSleep.same(sleep)) {
      bytes += fromSleepers.copyTo(sleepers);
      fromSleep.copyTo(sleep);
    }
  }

  /**
   * Returns the bodies' slots: how many, of which type and generation.
   *
   * @return the store; owned by this
   */
  public BodyStore bodies() {
    return bodies;
  }

  /**
   * Returns the joints.
   *
   * @return the store; owned by this
   */
  public JointStore joints() {
    return joints;
  }

  /**
   * Passes the bodies' slots through an archive, first of all; when reading, {@link #embody} must
   * follow for each slot in use, then {@link #passRest}.
   *
   * @param a reads into an empty state
   */
  public void passSlots(Archive a) {
    bodies.passSlots(a);
  }

  /**
   * Tells what a body that is being read consists of.
   *
   * @param a for complaints
   * @param body its slot; by ascending slots
   * @param shapes its shapes
   * @param own its mass, null to compute it from the shapes
   * @throws IllegalArgumentException if no body can be made of that
   */
  public void embody(Archive a, int body, ShapeSpec[] shapes, MassData own) {
    maker.embody(body, shapes, own);
    a.require(parts.used() <= MAX_PARTS, "parts=" + parts.used() + " are more than " + MAX_PARTS);
  }

  /**
   * Passes motion, joints and contacts through an archive.
   *
   * @param a see {@link #passSlots}
   */
  public void passRest(Archive a) {
    bodies.passMotion(a);
    joints.pass(a, bodies);
    ContactTable touching = contacts;
    if (!a.reads()) {
      touching = new ContactTable();
      int[] which = new int[contacts.count()];
      touching.take(contacts, which, contacts.touching(which));
    }
    ContactArchive.pass(touching, a, bodies, parts);
    for (int row = 0; a.reads() && row < touching.count(); row++) {
      a.require(
          !SleepingContacts.belongs(bodies, contacts.bodyA(row), contacts.bodyB(row)),
          "contact=" + row + " sleeps");
    }
    sleepers.pass(a, bodies, parts);
  }

  /**
   * Notes that everything was read, so that no copy of the world counts as equal to this state.
   *
   * @param world whose state this is
   */
  public void distinguish(Dynamics world) {
    world.distinguish(this);
  }

  void distinguish(
      BodyStore ownBodies,
      ContactTable ownContacts,
      JointStore ownJoints,
      SleepingContacts ownSleepers,
      Stamp ownSleep) {
    ownBodies.distinguish(bodies);
    ownContacts.distinguish(contacts);
    ownJoints.distinguish(joints);
    ownSleepers.rows.distinguish(sleepers.rows);
    ownSleep.distinguish(sleep);
  }
}

package carom.physics.dynamics;

/**
 * The state of a world at one moment: copies of its stores. Trees, fat boxes and rows of parts that
 * are close but don't touch are not in it; they follow from the rest.
 */
public final class DynamicsState {
  final BodyStore bodies = new BodyStore();
  final ShapeTable parts = new ShapeTable();
  final ContactTable contacts = new ContactTable();
  final JointStore joints = new JointStore();
  final SleepingContacts sleepers = new SleepingContacts();
  final Stamp sleep = new Stamp();
  private long bytes;

  /** Makes an empty state to save into. */
  public DynamicsState() {}

  /**
   * What the last save copied, apart from shapes, which are copied if bodies came or went.
   *
   * @return bytes of bodies, contacts and joints
   */
  public long bytes() {
    return bytes;
  }

  void take(BodyStore fromBodies, ContactTable fromContacts, JointStore fromJoints) {
    bytes = fromBodies.copyTo(bodies) + fromContacts.copyTo(contacts) + fromJoints.copyTo(joints);
  }

  void takeSleep(SleepingContacts fromSleepers, Stamp fromSleep) {
    if (!fromSleep.same(sleep)) {
      bytes += fromSleepers.copyTo(sleepers);
      fromSleep.copyTo(sleep);
    }
  }
}

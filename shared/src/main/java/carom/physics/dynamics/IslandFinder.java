package carom.physics.dynamics;

import carom.physics.dynamics.body.ActiveBodies;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.joint.JointStore;
import carom.physics.dynamics.pairs.PairFinder;
import carom.physics.dynamics.store.IntList;
import carom.physics.settings.Settings;

/**
 * Finds the islands of the active bodies: dynamic bodies that hold each other by touching contacts
 * or joints. Islands are found anew each time from contacts and joints, and valid until one of
 * these changes.
 */
final class IslandFinder {
  private final Settings settings;
  private final BodyStore bodies;
  private final ActiveBodies active;
  private final ContactTable contacts;
  private final JointStore joints;
  private final PairFinder pairs;
  private final Islands islands = new Islands();

  IslandFinder(
      Settings settings,
      BodyStore bodies,
      ActiveBodies active,
      ContactTable contacts,
      JointStore joints,
      PairFinder pairs) {
    this.settings = settings;
    this.bodies = bodies;
    this.active = active;
    this.contacts = contacts;
    this.joints = joints;
    this.pairs = pairs;
  }

  /** Makes room for as many bodies as the active list may hold, also in a list for them. */
  void reserve(IntList also) {
    islands.reserve(active.list.length);
    also.ensureRoom(active.list.length);
  }

  /** Finds all islands, and which of them contacts or joints keep awake. */
  void find() {
    islands.reserve(active.list.length);
    islands.reset(active.count);
    for (int row = 0; row < contacts.count(); row++) {
      if (contacts.responds(row) && (contacts.flags[row] & ContactTable.VETOED) == 0) {
        tie(contacts.bodyA(row), contacts.bodyB(row), contacts.surface(row) != 0);
      }
    }
    for (int j = joints.nextAwake(0); j >= 0; j = joints.nextAwake(j + 1)) {
      boolean runs = (joints.flags[j] & JointStore.DRIVEN) != 0 && joints.motorSpeed[j] != 0;
      tie(joints.bodyA[j], joints.bodyB[j], runs);
    }
  }

  /** Joins dynamic bodies; a kinematic one that hasn't rested for long keeps the other awake. */
  private void tie(int a, int b, boolean running) {
    int i = a < 0 ? -1 : active.index[a];
    int j = active.index[b];
    boolean dynamicA = i >= 0 && bodies.type[a] == BodyStore.DYNAMIC;
    boolean dynamicB = j >= 0 && bodies.type[b] == BodyStore.DYNAMIC;
    boolean restless = running;
    if (dynamicA && dynamicB) {
      islands.join(i, j);
    } else {
      restless |= i >= 0 && !dynamicA && bodies.sleepTime[a] < settings.sleepDelay();
      restless |= j >= 0 && !dynamicB && bodies.sleepTime[b] < settings.sleepDelay();
    }
    if (restless && dynamicA) {
      islands.keepAwake(i);
    }
    if (restless && dynamicB) {
      islands.keepAwake(j);
    }
  }

  /** Returns the number of the island of the active body in a place of the list. */
  int island(int place) {
    return islands.find(place);
  }

  /** Returns the number of an active body's island. */
  int islandOf(int body) {
    return islands.find(active.index[body]);
  }

  /** Keeps the island of the active body in a place of the list awake. */
  void keepAwake(int place) {
    islands.keepAwake(place);
  }

  /** Returns whether something keeps the island of the active body in a place awake. */
  boolean keptAwake(int place) {
    return islands.keptAwake(place);
  }

  /**
   * Returns whether a contact of an island is one that the next step ends, because its parts may
   * not touch.
   */
  boolean losesHold(int island) {
    for (int row = 0; row < contacts.count(); row++) {
      if ((contacts.flags[row] & ContactTable.TOUCHING) != 0
          && (isOf(contacts.bodyA(row), island) || isOf(contacts.bodyB(row), island))
          && !pairs.mayStay(contacts, row)) {
        return true;
      }
    }
    return false;
  }

  private boolean isOf(int body, int island) {
    return active.contains(body) && islandOf(body) == island;
  }
}

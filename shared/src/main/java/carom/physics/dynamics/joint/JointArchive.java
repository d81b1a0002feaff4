package carom.physics.dynamics.joint;

import carom.physics.archive.Archive;
import carom.physics.dynamics.body.BodyStore;

/**
 * Passes all joints of a store through an archive, in either direction, and checks what was read:
 * an archive may come from anywhere.
 */
final class JointArchive {
  /** Most joints in an archive. */
  private static final int MAX_JOINTS = 1 << 22;

  private final JointStore s;
  private final Archive a;
  private final BodyStore bodies;

  /**
   * Makes a pass.
   *
   * @param store empty if the archive is read
   * @param bodies those of the same world, which have been passed before
   */
  JointArchive(JointStore store, Archive archive, BodyStore bodies) {
    s = store;
    a = archive;
    this.bodies = bodies;
  }

  /** Writes or reads everything. */
  void pass() {
    int n = a.count("joint slots", s.slots(), MAX_JOINTS, 2 + Float.BYTES * s.floats.length);
    while (s.type.length < n) {
      s.grow();
    }
    a.bytes("type of joint", s.type, n, JointStore.FREE, JointStore.PULLEY);
    a.bytes("flags of joint", s.flags, n, 0, JointRanges.FLAGS);
    s.slots.passGenerations(a, "joint", n);
    a.integers("body of joint", s.bodyA, n, -1, bodies.slots() - 1);
    a.integers("body of joint", s.bodyB, n, -1, bodies.slots() - 1);
    for (float[] field : s.floats) {
      boolean unbounded = field == s.breakForce || field == s.breakTorque;
      a.numbers("number of joint", field, n, unbounded ? Float.POSITIVE_INFINITY : BodyStore.MOST);
    }
    a.numbers("ratio of joint", s.ratio, n, BodyStore.MOST);
    a.numbers("base of joint", s.baseAx, n, BodyStore.MOST);
    a.numbers("base of joint", s.baseAy, n, BodyStore.MOST);
    a.numbers("base of joint", s.baseBx, n, BodyStore.MOST);
    a.numbers("base of joint", s.baseBy, n, BodyStore.MOST);
    a.integers("turns of joint", s.turnsA, n, Integer.MIN_VALUE, Integer.MAX_VALUE);
    a.integers("turns of joint", s.turnsB, n, Integer.MIN_VALUE, Integer.MAX_VALUE);
    a.numbers("angle of joint", s.lastA, n, BodyStore.MOST);
    a.numbers("angle of joint", s.lastB, n, BodyStore.MOST);
    s.slots.passFree(a, "joint", n, s.type, JointStore.FREE);
    if (a.reads()) {
      checkJoints();
    }
    passLists();
  }

  /** Requires every joint to be of two bodies that exist, with numbers in their ranges. */
  private void checkJoints() {
    for (int j = 0; j < s.slots(); j++) {
      if (s.type[j] == JointStore.FREE) {
        s.clearFree(j);
        continue;
      }
      boolean grounded = s.bodyA[j] < 0 && JointTransfer.mayBeGrounded(s.type[j]);
      a.require(
          s.bodyB[j] >= 0
              && bodies.type[s.bodyB[j]] != BodyStore.FREE
              && s.bodyA[j] != s.bodyB[j]
              && (grounded || (s.bodyA[j] >= 0 && bodies.type[s.bodyA[j]] != BodyStore.FREE)),
          "joint=" + j + " of body=" + s.bodyA[j] + " with body=" + s.bodyB[j]);
      String problem = JointRanges.problem(s, j);
      a.require(problem == null, problem);
    }
  }

  /** Passes the ends of each body's joints in the order of its list, body after body. */
  private void passLists() {
    int[] ends = new int[2 * s.slots()];
    int n = 0;
    for (int body = 0; !a.reads() && body < s.lists.bodies(); body++) {
      for (int end = s.lists.first(body); end >= 0; end = s.lists.next(end)) {
        ends[n++] = end;
      }
    }
    n = a.count("ends of joints", n, 2 * s.slots(), Integer.BYTES);
    a.integers("end of joint", ends, n, 0, 2 * s.slots() - 1);
    if (!a.reads()) {
      return;
    }
    s.lists.clear(bodies.slots());
    boolean[] seen = new boolean[2 * s.slots()];
    int listed = 0;
    int last = -1;
    for (int i = 0; i < n; i++) {
      int end = ends[i];
      int body = end(end);
      a.require(
          s.type[end >> 1] != JointStore.FREE && body >= 0 && !seen[end],
          "end=" + end + " of no joint");
      seen[end] = true;
      if (last >= 0 && end(last) == body) {
        a.require(end < last, "the joints of body=" + body + " are out of order");
        s.lists.setNext(last, end);
      } else {
        a.require(s.lists.first(body) < 0, "the joints of body=" + body + " are in two lists");
        s.lists.setFirst(body, end);
      }
      last = end;
    }
    for (int end = 0; end < 2 * s.slots(); end++) {
      listed += s.type[end >> 1] != JointStore.FREE && end(end) >= 0 ? 1 : 0;
    }
    a.require(listed == n, "listed ends of joints=" + n + " of " + listed);
  }

  private int end(int end) {
    return (end & 1) == 0 ? s.bodyA[end >> 1] : s.bodyB[end >> 1];
  }
}

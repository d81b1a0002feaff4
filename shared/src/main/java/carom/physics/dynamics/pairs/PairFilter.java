package carom.physics.dynamics.pairs;

import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.contact.ContactKey;
import carom.physics.dynamics.contact.ContactTable;

/**
 * Decides which parts may touch: by the types of their bodies, their filters and joints, and at
 * last by a rule of the user. Workers ask {@link #keyOf}, which leaves the user's rule out; the
 * thread that steps then asks it about the pairs that were found.
 */
final class PairFilter {
  private final BodyStore bodies;
  private final ShapeTable parts;
  private final PairRule rule;

  /** The user's rule, null for none. */
  private PartRule custom;

  PairFilter(BodyStore bodies, ShapeTable parts, PairRule rule) {
    this.bodies = bodies;
    this.parts = parts;
    this.rule = rule;
  }

  /** Sets the user's rule, null for none. */
  void custom(PartRule newRule) {
    custom = newRule;
  }

  /**
   * Returns whether filters, joints, types and the user's rule let two parts touch. For the thread
   * that steps.
   */
  boolean mayTouch(int p, int q) {
    return mayMeet(p, q) && allowed(p, q);
  }

  private boolean allowed(int p, int q) {
    return custom == null
        || (parts.body[p] < parts.body[q] ? custom.mayTouch(p, q) : custom.mayTouch(q, p));
  }

  /**
   * Takes the pairs out that the user's rule refuses; pairs that have rows aren't asked again.
   *
   * @param keys ascending
   * @param count how many
   * @param rows the contact table, which is in the order of its keys
   * @return how many are left, at the front
   */
  int ask(long[] keys, int count, ContactTable rows) {
    if (custom == null) {
      return count;
    }
    int left = 0;
    int row = 0;
    long last = -1;
    for (int i = 0; i < count; i++) {
      long k = keys[i];
      while (row < rows.count() && rows.key[row] < k) {
        row++;
      }
      boolean known = row < rows.count() && rows.key[row] == k;
      if (k != last && (known || allowed(partA(k), partB(k)))) {
        keys[left++] = k;
      }
      last = k;
    }
    return left;
  }

  private int partA(long k) {
    return bodies.firstPart[ContactKey.bodyA(k)] + ContactKey.partA(k);
  }

  private int partB(long k) {
    return bodies.firstPart[ContactKey.bodyB(k)] + ContactKey.partB(k);
  }

  /** Returns whether filters, joints and types let two parts touch; for any thread. */
  private boolean mayMeet(int p, int q) {
    int a = parts.body[p];
    int b = parts.body[q];
    return (bodies.invMass[a] != 0 || bodies.invMass[b] != 0)
        && parts.meet(p, q)
        && rule.mayTouch(a, b);
  }

  /** Returns whether the parts of a row still may touch. */
  boolean mayStay(ContactTable rows, int row) {
    int p = rows.partA(row);
    int q = rows.partB(row);
    boolean gone = bodies.disabled(parts.body[p]) || bodies.disabled(parts.body[q]);
    return !gone && mayTouch(p, q);
  }

  /** Returns the key of two parts that may touch if the user's rule lets them, or -1. */
  long keyOf(int p, int q) {
    int a = parts.body[p];
    int b = parts.body[q];
    if (a == b || !mayMeet(p, q)) {
      return -1;
    }
    return a < b
        ? ContactKey.of(a, p - bodies.firstPart[a], b, q - bodies.firstPart[b])
        : ContactKey.of(b, q - bodies.firstPart[b], a, p - bodies.firstPart[a]);
  }
}

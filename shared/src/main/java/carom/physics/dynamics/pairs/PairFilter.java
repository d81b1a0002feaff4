package carom.physics.dynamics.pairs;

import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.contact.ContactKey;
import carom.physics.dynamics.contact.ContactTable;

/** Decides which parts may touch, by the types of their bodies, their filters and joints. */
final class PairFilter {
  private final BodyStore bodies;
  private final ShapeTable parts;
  private final PairRule rule;

  PairFilter(BodyStore bodies, ShapeTable parts, PairRule rule) {
    this.bodies = bodies;
    this.parts = parts;
    this.rule = rule;
  }

  /** Returns whether filters, joints and types let two parts touch. */
  boolean mayTouch(int p, int q) {
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

  /** Returns the key of two parts that may touch, or -1. */
  long keyOf(int p, int q) {
    int a = parts.body[p];
    int b = parts.body[q];
    if (a == b || !mayTouch(p, q)) {
      return -1;
    }
    return a < b
        ? ContactKey.of(a, p - bodies.firstPart[a], b, q - bodies.firstPart[b])
        : ContactKey.of(b, q - bodies.firstPart[b], a, p - bodies.firstPart[a]);
  }
}

package carom.physics.dynamics;

import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.contact.BodyContacts;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.joint.JointStore;
import carom.physics.dynamics.store.IntList;
import carom.physics.settings.Settings;
import java.util.Arrays;

/**
 * Scales the impulses with which contacts start the next step, when what they balanced goes: a body
 * that lay on another, a joint, most of a body's mass. They may be thousands of times the weight of
 * what is left: a light box from which a heavy one was taken leapt at 16 m/s.
 *
 * <p>Contacts push a body with S, and the load that goes did with R. So together they were T = S +
 * R, and what is left of S is a share {@code |T| / |S|}. What the other bodies of these contacts
 * lose by that goes on in the same way, down to the ground. Loads of like bodies are left alone:
 * visits of a step take that back.
 *
 * <p>No part of the state; one world's.
 */
final class LostLoads {
  /** Times of its own impulse that a body's contacts may start with. */
  private static final float EVEN = 4;

  private final Settings settings;
  private final BodyStore bodies;
  private final JointStore joints;
  private final ContactTable contacts;
  private final BodyContacts ofBody;

  /** Bodies that lost something, each once. */
  private final IntList open = new IntList();

  private boolean[] isKnown = new boolean[0]; // by slot
  private float[] lostX = new float[0];
  private float[] lostY = new float[0];

  LostLoads(
      Settings settings,
      BodyStore bodies,
      JointStore joints,
      ContactTable contacts,
      BodyContacts ofBody) {
    this.settings = settings;
    this.bodies = bodies;
    this.joints = joints;
    this.contacts = contacts;
    this.ofBody = ofBody;
  }

  /** Takes account of a contact that is about to end. {@link #settle} follows. */
  void losesContact(int row) {
    float x = impulseX(row);
    float y = impulseY(row);
    if (x != 0 || y != 0) {
      add(contacts.bodyA(row), -x, -y);
      add(contacts.bodyB(row), x, y);
      contacts.scale(row, 0);
    }
  }

  /** Takes account of a body that is about to go, with all its contacts. */
  void losesBody(int body) {
    for (int end = ofBody.firstEnd(body); end >= 0; end = ofBody.nextEnd(end)) {
      losesContact(end >> 1);
    }
    settle();
  }

  /** Takes account of a joint that is about to go. */
  void losesJoint(int joint) {
    float force = (float) Math.sqrt(square(joints.forceX[joint], joints.forceY[joint]));
    losesForce(joints.bodyA[joint], force);
    losesForce(joints.bodyB[joint], force);
    settle();
  }

  private void losesForce(int body, float force) {
    if (body < 0 || bodies.invMass[body] == 0) {
      return;
    }
    float weight = (float) Math.sqrt(square(settings.gravityX(), settings.gravityY()));
    weight *= Math.abs(bodies.gravityScale[body]) / bodies.invMass[body];
    if (force > EVEN * weight) {
      scale(body, weight / force);
    }
  }

  /** Takes account of the mass that a body has now, and not its old one. */
  void losesMass(int body, float oldInverse) {
    float inverse = bodies.invMass[body];
    if (oldInverse > 0 && inverse > EVEN * oldInverse) {
      scale(body, oldInverse / inverse);
      settle();
    }
  }

  /** Scales what the contacts start with of bodies that lost a load, and of all below. */
  void settle() {
    for (int i = 0; i < open.count; i++) {
      int body = open.values[i];
      float x = 0;
      float y = 0;
      for (int end = ofBody.firstEnd(body); end >= 0; end = ofBody.nextEnd(end)) {
        int sign = (end & 1) == 0 ? -1 : 1;
        x += sign * impulseX(end >> 1);
        y += sign * impulseY(end >> 1);
      }
      double whole = Math.sqrt(square(x, y));
      double left = Math.sqrt(square(x + lostX[body], y + lostY[body]));
      if (whole > EVEN * left) {
        scale(body, (float) (left / whole));
      }
    }
    for (int i = 0; i < open.count; i++) {
      isKnown[open.values[i]] = false;
    }
    open.count = 0;
  }

  /** Scales what all contacts of a body start with. */
  private void scale(int body, float share) {
    for (int end = ofBody.firstEnd(body); end >= 0; end = ofBody.nextEnd(end)) {
      int row = end >> 1;
      boolean isA = (end & 1) == 0;
      float lost = (1 - share) * (isA ? 1 : -1);
      add(
          isA ? contacts.bodyB(row) : contacts.bodyA(row),
          lost * impulseX(row),
          lost * impulseY(row));
      contacts.scale(row, share);
    }
  }

  /** Notes an impulse that a body's contacts don't push it with any more. */
  private void add(int body, float x, float y) {
    if (bodies.type[body] != BodyStore.DYNAMIC) {
      return;
    }
    if (body >= isKnown.length) {
      int capacity = Math.max(bodies.slots(), 2 * isKnown.length);
      isKnown = Arrays.copyOf(isKnown, capacity);
      lostX = Arrays.copyOf(lostX, capacity);
      lostY = Arrays.copyOf(lostY, capacity);
    }
    if (!isKnown[body]) {
      isKnown[body] = true;
      lostX[body] = 0;
      lostY[body] = 0;
      open.add(body);
    }
    lostX[body] += x;
    lostY[body] += y;
  }

  /** Returns the impulse on B with which a row starts, along x, N s. */
  private float impulseX(int row) {
    int at = row * ContactTable.CONTACT;
    float[] c = contacts.contact;
    float normal = c[at + ContactTable.NORMAL0] + c[at + ContactTable.NORMAL1];
    float tangent = c[at + ContactTable.TANGENT0] + c[at + ContactTable.TANGENT1];
    return normal * c[at + ContactTable.NX] - tangent * c[at + ContactTable.NY];
  }

  private float impulseY(int row) {
    int at = row * ContactTable.CONTACT;
    float[] c = contacts.contact;
    float normal = c[at + ContactTable.NORMAL0] + c[at + ContactTable.NORMAL1];
    float tangent = c[at + ContactTable.TANGENT0] + c[at + ContactTable.TANGENT1];
    return normal * c[at + ContactTable.NY] + tangent * c[at + ContactTable.NX];
  }

  private static double square(double x, double y) {
    return x * x + y * y;
  }
}

package carom.physics.dynamics;

import carom.physics.dynamics.body.ActiveBodies;
import carom.physics.dynamics.body.BodyMaker;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeSpec;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.contact.ContactEvents;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.pairs.PairFinder;
import carom.physics.geometry.MassData;
import carom.physics.settings.Settings;

/**
 * Makes, changes and removes bodies between steps, and makes all stages follow: each method leaves
 * the world so that it can be stepped.
 */
public final class BodyEditor {
  private final Settings settings;
  private final BodyStore bodies;
  private final ShapeTable parts;
  private final ActiveBodies active;
  private final ContactTable contacts;
  private final PairFinder pairs;
  private final Sleeping sleeping;
  private final Refilter refilter;
  private final EndedContacts ended;
  private final LostLoads lost;
  private final BodyMaker maker;

  /** True once a static body was moved by hand. */
  private boolean staticMoved;

  BodyEditor(
      Settings settings,
      BodyStore bodies,
      ShapeTable parts,
      ActiveBodies active,
      ContactTable contacts,
      PairFinder pairs,
      Sleeping sleeping,
      Refilter refilter,
      EndedContacts ended,
      LostLoads lost) {
    this.lost = lost;
    this.settings = settings;
    this.bodies = bodies;
    this.parts = parts;
    this.active = active;
    this.contacts = contacts;
    this.pairs = pairs;
    this.sleeping = sleeping;
    this.refilter = refilter;
    this.ended = ended;
    maker = new BodyMaker(bodies, parts);
  }

  /**
   * Makes a body at the origin. It takes part from {@link #enter} on.
   *
   * @param type one of {@link BodyStore}'s types
   * @param shapes what it consists of
   * @param own its mass, null to compute it from the shapes
   * @param fixedRotation whether only {@code setAngularVelocity} turns it
   * @return the slot
   */
  public int create(byte type, ShapeSpec[] shapes, MassData own, boolean fixedRotation) {
    int body = maker.make(type, shapes, own, fixedRotation);
    active.reserve(body + 1);
    return body;
  }

  /**
   * Adds a new body at its pose. A static or kinematic one wakes what it overlaps.
   *
   * @param body the slot
   * @param awake whether it starts awake; means nothing for a static body
   */
  public void enter(int body, boolean awake) {
    boolean maySleep = (bodies.flags[body] & BodyStore.SLEEPLESS) == 0 && settings.sleeping();
    if (!awake && maySleep && bodies.type[body] != BodyStore.STATIC) {
      bodies.flags[body] |= BodyStore.ASLEEP;
      bodies.vx[body] = 0;
      bodies.vy[body] = 0;
      bodies.w[body] = 0;
      enter(body);
      pairs.searchBody(body);
    } else {
      enter(body);
    }
    sleeping.wakeOverlapped(body);
  }

  /**
   * Checks that a dynamic body could be made of some shapes.
   *
   * @param shapes what it would consist of
   * @param own its mass, null to compute it from the shapes
   * @throws IllegalArgumentException if they have no mass, or too much
   */
  public static void checkMass(ShapeSpec[] shapes, MassData own) {
    BodyMaker.massOf(shapes, own);
  }

  /**
   * Checks that a body could be made of some shapes.
   *
   * @param type one of {@link BodyStore}'s types
   * @param shapes what it would consist of
   * @param own its mass, null to compute it from the shapes
   * @throws IllegalArgumentException if they have too many parts, or a dynamic body would have no
   *     mass, or too much
   */
  public static void checkShapes(byte type, ShapeSpec[] shapes, MassData own) {
    BodyMaker.partCount(shapes);
    BodyMaker.total(type, shapes, own);
  }

  /**
   * Makes a body static, kinematic or dynamic. Its origin, and the velocity there, stay, except
   * that a static body is at rest.
   *
   * @param body the slot
   * @param type one of {@link BodyStore}'s types
   * @param shapes what it consists of
   * @param own its mass, null to compute it from the shapes
   */
  public void setType(int body, byte type, ShapeSpec[] shapes, MassData own) {
    if (bodies.type[body] == type) {
      return;
    }
    MassData total = BodyMaker.total(type, shapes, own);
    sleeping.disturb(body);
    boolean enabled = !bodies.disabled(body);
    if (enabled) {
      leave(body);
    }
    bodies.type[body] = type;
    maker.refill(body, shapes, own, total);
    contacts.forgetManifolds(body);
    if (type == BodyStore.STATIC) {
      bodies.vx[body] = 0;
      bodies.vy[body] = 0;
      bodies.w[body] = 0;
    }
    bodies.clearForces(body);
    if (enabled) {
      enter(body);
      sleeping.wakeOverlapped(body);
    }
    sleeping.jointActivity().refreshBody(body);
    refilter.markStale();
  }

  /**
   * Takes a body out of the simulation, or back in. Its contacts end in the next step.
   *
   * @param body the slot
   * @param enabled whether it takes part
   */
  public void setEnabled(int body, boolean enabled) {
    if (bodies.disabled(body) != enabled) {
      return;
    }
    sleeping.disturb(body);
    if (!enabled) {
      sleeping.mergeWoken();
      lost.losesBody(body);
    }
    bodies.flags[body] ^= BodyStore.DISABLED;
    bodies.clearForces(body);
    if (enabled) {
      enter(body);
      sleeping.wakeOverlapped(body);
    } else {
      leave(body);
    }
    sleeping.jointActivity().refreshBody(body);
    refilter.markStale();
  }

  /**
   * Gives a body other materials, filters, sensors or another mass; its shapes stay. Its origin,
   * and the velocity there, stay, too.
   *
   * @param body the slot
   * @param shapes what it consists of
   * @param own its mass, null to compute it from the shapes
   */
  public void change(int body, ShapeSpec[] shapes, MassData own) {
    MassData total = BodyMaker.total(bodies.type[body], shapes, own);
    sleeping.disturb(body);
    sleeping.mergeWoken();
    float inverseMass = bodies.invMass[body];
    maker.refill(body, shapes, own, total);
    lost.losesMass(body, inverseMass);
    contacts.forgetManifolds(body);
    contacts.mixAgain(body, parts);
    sleeping.wakeOverlapped(body);
    refilter.markStale();
    sleeping.doAsked(); // by those who heard of contacts that ended
  }

  /**
   * Wakes a body and what it touches, and decides anew in the next step which parts may touch.
   *
   * @param body the slot
   */
  public void refilter(int body) {
    sleeping.disturb(body);
    sleeping.wakeOverlapped(body);
    refilter.markStale();
  }

  /**
   * Locks axes of a body's motion, or frees them. Its velocity along an axis that is newly locked
   * becomes zero.
   *
   * @param body the slot
   * @param axes {@link BodyStore#LOCK_X} and {@link BodyStore#LOCK_Y}, added up
   * @param fixed whether nothing but {@code setAngularVelocity} turns it
   * @param shapes what it consists of
   * @param own its mass, null to compute it from the shapes
   */
  public void setLocks(int body, int axes, boolean fixed, ShapeSpec[] shapes, MassData own) {
    int fresh = axes & ~bodies.flags[body];
    if ((fresh & BodyStore.LOCK_X) != 0) {
      bodies.vx[body] = 0;
    }
    if ((fresh & BodyStore.LOCK_Y) != 0) {
      bodies.vy[body] = 0;
    }
    bodies.setLinearLocks(body, axes);
    if (fixed) {
      bodies.w[body] = (bodies.flags[body] & BodyStore.FIXED_ROTATION) == 0 ? 0 : bodies.w[body];
      bodies.flags[body] |= BodyStore.FIXED_ROTATION;
    } else {
      bodies.flags[body] &= ~BodyStore.FIXED_ROTATION;
    }
    change(body, shapes, own);
  }

  /**
   * Gives a body other shapes. Contacts of the parts that go end now; those of all others stay,
   * with their impulses. The body's origin, and the velocity there, stay, too.
   *
   * @param body the slot
   * @param first number of the first part that goes, or in front of which parts come
   * @param removed how many parts go
   * @param shapes what it consists of from now on
   * @param own its mass, null to compute it from the shapes
   * @param events hears of contacts that end, null for none
   */
  public void reshape(
      int body, int first, int removed, ShapeSpec[] shapes, MassData own, ContactEvents events) {
    MassData total = BodyMaker.total(bodies.type[body], shapes, own);
    int before = bodies.partCount[body];
    endContacts(body, first, first + removed, events);
    boolean enabled = !bodies.disabled(body);
    if (enabled) {
      leave(body);
    }
    float inverseMass = bodies.invMass[body];
    maker.reshape(body, shapes, own, total);
    lost.losesMass(body, inverseMass);
    int shift = bodies.partCount[body] - before;
    contacts.renumberParts(body, first + removed, shift, bodies);
    contacts.forgetManifolds();
    contacts.mixAgain(body, parts);
    if (enabled) {
      enter(body);
      sleeping.wakeOverlapped(body);
    }
    refilter.markStale();
    sleeping.doAsked(); // by those who heard of contacts that ended
  }

  /** Adds a body to the active or sleeping ones and to the broadphase. */
  void enter(int body) {
    sleeping.enter(body);
    pairs.enter(body);
  }

  /** Removes a body from the active or sleeping ones and from the broadphase. */
  void leave(int body) {
    sleeping.leave(body);
    pairs.leave(body);
  }

  /**
   * Ends a body's contacts now; what still touches begins again in the next step.
   *
   * @param body the slot
   * @param events hears of them, null for none
   */
  public void endContacts(int body, ContactEvents events) {
    endContacts(body, 0, BodyStore.MAX_PARTS, events);
  }

  /** Ends the contacts of a body's parts with numbers from one on, to before another one. */
  private void endContacts(int body, int from, int to, ContactEvents events) {
    sleeping.disturb(body);
    sleeping.mergeWoken();
    if (events != null) {
      sleeping.suspend();
      try {
        for (int row = 0; row < contacts.count(); row++) {
          if (contacts.touches(row) && contacts.isOfParts(row, body, from, to)) {
            events.end(row);
          }
        }
      } finally {
        sleeping.resume();
      }
    }
    for (int row = 0; row < contacts.count(); row++) {
      if (contacts.isOfParts(row, body, from, to)) {
        ended.add(row);
        lost.losesContact(row);
      }
    }
    contacts.order().removeParts(body, from, to);
    lost.settle();
    pairs.searchAll();
  }

  /**
   * Removes a body; its touching contacts end first.
   *
   * @param body the slot
   * @param events hears of them, null for none
   */
  public void destroy(int body, ContactEvents events) {
    endContacts(body, events);
    if (!bodies.disabled(body)) {
      leave(body);
    }
    parts.release(bodies.firstPart[body], bodies.partCount[body]);
    bodies.release(body);
    sleeping.doAsked();
  }

  /**
   * Makes the world follow a body whose pose was changed by hand: boxes, pairs and sleep.
   *
   * @param body the slot
   */
  public void moved(int body) {
    if (bodies.disabled(body)) {
      return;
    }
    if (bodies.type[body] == BodyStore.STATIC) {
      pairs.moveStatic(body);
      staticMoved = true;
      sleeping.disturb(body);
      sleeping.wakeOverlapped(body);
    } else {
      pairs.posesChanged();
      sleeping.wake(body);
      sleeping.moved(body);
    }
  }

  /** Returns whether a static body was ever moved by hand. */
  boolean staticMoved() {
    return staticMoved;
  }
}

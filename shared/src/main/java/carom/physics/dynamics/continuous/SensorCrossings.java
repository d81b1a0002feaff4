package carom.physics.dynamics.continuous;

import carom.physics.broadphase.IntVisitor;
import carom.physics.broadphase.KdTree;
import carom.physics.collision.Collider;
import carom.physics.collision.Manifold;
import carom.physics.collision.Sweep;
import carom.physics.collision.TimeOfImpact;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.contact.ContactEvents;
import carom.physics.dynamics.contact.ContactKey;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.pairs.PairFinder;
import carom.physics.dynamics.store.KeySorter;
import carom.physics.math.Transform;
import java.util.Arrays;

/**
 * Finds the sensors that fast bodies cross within one step, entered and left again. Overlap at the
 * end of a step is left to the next narrow phase; overlap at the start is known already.
 *
 * <p>A crossing becomes a touching row of the contact table. So it begins at the end of this step,
 * ends with the next one, and belongs to the state in between.
 */
final class SensorCrossings {
  private static final int FIRST_CAPACITY = 16;

  /** Most stretches of two motions of which each may have been stopped once. */
  private static final int STRETCHES = 3;

  private final PairFinder pairs;
  private final BodyStore bodies;
  private final ShapeTable parts;
  private final ContactTable contacts;
  private final FastBodies fast;
  private final TargetMotion target;
  private final TimeOfImpact timeOfImpact = new TimeOfImpact();
  private final Collider collider = new Collider();
  private final Manifold manifold = new Manifold();
  private final KeySorter sorter = new KeySorter();
  private final IntVisitor onCandidate = this::candidate;

  /** Keys of the crossings of this step. */
  private long[] keys = new long[FIRST_CAPACITY];

  private int count;

  private final Flight striker = new Flight();

  // The search at present.
  private Flight flight;
  private int moverPart;
  private final SweptBox way;

  // Scratch.
  private final SweptBox other;
  private final Sweep own = new Sweep();
  private final Sweep theirs = new Sweep();
  private final Transform from = new Transform();
  private final Transform to = new Transform();
  private final float[] cuts = new float[STRETCHES + 1];

  SensorCrossings(
      PairFinder pairs,
      BodyStore bodies,
      ShapeTable parts,
      ContactTable contacts,
      FastBodies fast,
      TargetMotion target) {
    this.pairs = pairs;
    this.bodies = bodies;
    this.parts = parts;
    this.contacts = contacts;
    this.fast = fast;
    this.target = target;
    way = new SweptBox(parts);
    other = new SweptBox(parts);
  }

  /** Finds the crossings of all flights, which are settled, and of fast kinematic bodies. */
  void find() {
    for (int i = 0; i < fast.count(); i++) {
      find(fast.flight(i), false);
    }
    for (int i = 0; i < fast.strikers(); i++) {
      fast.striker(i, striker);
      find(striker, true);
    }
  }

  private void find(Flight f, boolean sensorsOnly) {
    flight = f;
    int first = bodies.firstPart[f.body];
    for (int part = first; part < first + bodies.partCount[f.body]; part++) {
      if (sensorsOnly && !parts.sensor[part]) {
        continue;
      }
      moverPart = part;
      way.setEmpty();
      way.add(part, f.beginning());
      if (f.split < 1) {
        way.add(part, f.second);
      }
      query(pairs.resting(), 0);
      if (fast.movingTargets()) {
        query(pairs.moving(), fast.drift());
      }
    }
  }

  /** Makes the crossings rows that touch, in the order of their keys, and tells of them. */
  void begin(ContactEvents events) {
    if (count == 0) {
      return;
    }
    keys = sorter.sort(keys, count);
    int n = 0;
    for (int i = 0; i < count; i++) {
      if (i == 0 || keys[i] != keys[i - 1]) {
        keys[n++] = keys[i];
      }
    }
    count = 0;
    contacts.order().touch(keys, n, bodies, parts);
    for (int i = 0; i < n && events != null; i++) {
      events.begin(contacts.find(keys[i]));
    }
  }

  private void query(KdTree tree, float more) {
    tree.query(
        way.minX() - more, way.minY() - more, way.maxX() + more, way.maxY() + more, onCandidate);
  }

  private boolean candidate(int part) {
    int body = parts.body[part];
    if (parts.sensor[part] == parts.sensor[moverPart]
        || body == flight.body
        || !pairs.mayTouch(moverPart, part)) {
      return true;
    }
    target.of(body);
    other.setEmpty();
    other.add(part, target.first);
    if (target.split < 1) {
      other.add(part, target.second);
    }
    if (other.box().overlaps(way.box())) {
      long key = key(part, body);
      if (!isKnown(key) && crosses(part) && !overlapsNow(part, body)) {
        keys = count == keys.length ? Arrays.copyOf(keys, 2 * count) : keys;
        keys[count++] = key;
      }
    }
    return true;
  }

  private long key(int part, int body) {
    int mover = flight.body;
    int own = moverPart - bodies.firstPart[mover];
    int their = part - bodies.firstPart[body];
    return mover < body
        ? ContactKey.of(mover, own, body, their)
        : ContactKey.of(body, their, mover, own);
  }

  /** Returns whether the parts overlapped when the step began, which has been told. */
  private boolean isKnown(long key) {
    int row = contacts.find(key);
    return row >= 0 && (contacts.flags[row] & ContactTable.TOUCHING) != 0;
  }

  /** Returns whether the parts meet during the step, each on its own way. */
  private boolean crosses(int part) {
    cuts[1] = Math.min(flight.split, target.split);
    cuts[2] = Math.max(flight.split, target.split);
    cuts[STRETCHES] = 1;
    for (int i = 0; i < STRETCHES; i++) {
      if (cuts[i] < cuts[i + 1] && meets(part, cuts[i], cuts[i + 1])) {
        return true;
      }
    }
    return false;
  }

  private boolean meets(int part, float start, float end) {
    stretch(flight.beginning(), flight.second, flight.split, start, end, own);
    stretch(target.first, target.second, target.split, start, end, theirs);
    return timeOfImpact.find(
            parts.convex[moverPart], own, parts.convex[part], theirs, TimeOfImpact.MIN_TARGET)
        != TimeOfImpact.State.SEPARATED;
  }

  /** Cuts a stretch out of a motion that was stopped at a split, or never, and not in between. */
  private static void stretch(
      Sweep first, Sweep second, float split, float start, float end, Sweep out) {
    if (end <= split) {
      out.part(first, start / split, end / split);
    } else {
      out.part(second, (start - split) / (1 - split), (end - split) / (1 - split));
    }
  }

  /** Returns whether the parts overlap at the end of the step, as the next one will find. */
  private boolean overlapsNow(int part, int body) {
    place(flight.body, from);
    place(body, to);
    collider.collide(parts.convex[moverPart], from, parts.convex[part], to, 0, 0, manifold);
    return manifold.count > 0;
  }

  private void place(int body, Transform pose) {
    pose.set(bodies.x[body], bodies.y[body], bodies.cos[body], bodies.sin[body]);
  }
}

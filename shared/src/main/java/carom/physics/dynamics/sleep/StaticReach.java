package carom.physics.dynamics.sleep;

import carom.physics.broadphase.index.IntVisitor;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.pairs.PairFinder;
import carom.physics.dynamics.store.IntList;
import carom.physics.math.Aabb;
import carom.physics.settings.Settings;

/** Finds the bodies that sleep within reach of a static body, which came, moved or changed. */
final class StaticReach {
  private final Settings settings;
  private final BodyStore bodies;
  private final ShapeTable parts;
  private final PairFinder pairs;
  private final Aabb around = new Aabb();
  private final Aabb box = new Aabb();
  private final IntVisitor onOverlap = this::overlap;

  // The search at present.
  private int searchPart;
  private IntList found;

  StaticReach(Settings settings, BodyStore bodies, ShapeTable parts, PairFinder pairs) {
    this.settings = settings;
    this.bodies = bodies;
    this.parts = parts;
    this.pairs = pairs;
  }

  /** Appends the sleeping bodies that a static body may touch, some perhaps twice. */
  void listSleepers(int body, IntList to) {
    found = to;
    pairs.insertPending();
    int first = bodies.firstPart[body];
    for (int part = first; part < first + bodies.partCount[body]; part++) {
      searchPart = part;
      float reach = settings.speculativeDistance();
      pairs.tightBox(part, around);
      around.set(
          around.minX - reach, around.minY - reach, around.maxX + reach, around.maxY + reach);
      pairs.resting().query(around.minX, around.minY, around.maxX, around.maxY, onOverlap);
    }
  }

  /** Compares the box itself, because the fat one depends on the past. */
  private boolean overlap(int part) {
    if (bodies.asleep(parts.body[part]) && pairs.mayTouch(part, searchPart)) {
      pairs.tightBox(part, box);
      if (box.overlaps(around)) {
        found.add(parts.body[part]);
      }
    }
    return true;
  }
}

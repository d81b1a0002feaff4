package carom.physics.dynamics;

import carom.physics.broadphase.IntVisitor;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.pairs.PairFinder;
import carom.physics.dynamics.store.IntList;
import carom.physics.math.Aabb;
import carom.physics.settings.Settings;

/**
 * Finds the bodies that sleep within reach of a static body, which came, moved or changed, and of a
 * kinematic one that moves fast.
 */
final class StaticReach {
  private final Settings settings;
  private final BodyStore bodies;
  private final ShapeTable parts;
  private final PairFinder pairs;
  private final Aabb around = new Aabb();
  private final Aabb box = new Aabb();
  private final IntVisitor onOverlap = this::overlap;
  private final IntVisitor onBullet = this::bullet;

  // The search at present.
  private int searchPart;
  private IntList found;

  StaticReach(Settings settings, BodyStore bodies, ShapeTable parts, PairFinder pairs) {
    this.settings = settings;
    this.bodies = bodies;
    this.parts = parts;
    this.pairs = pairs;
  }

  /** Appends the sleeping bodies that a body may touch, some perhaps twice. */
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

  /**
   * Appends the sleeping bullets that a kinematic body may pass over within a step of dt seconds.
   */
  void listBullets(int body, float dt, IntList to) {
    float wayX = dt * bodies.vx[body];
    float wayY = dt * bodies.vy[body];
    float turned = bodies.reach[body] * Math.min(2, dt * Math.abs(bodies.w[body]));
    boolean seen = Math.abs(wayX) + Math.abs(wayY) + turned <= settings.speculativeDistance();
    if (seen || !settings.continuous()) {
      return;
    }
    found = to;
    pairs.insertPending();
    int first = bodies.firstPart[body];
    for (int part = first; part < first + bodies.partCount[body]; part++) {
      searchPart = part;
      pairs.tightBox(part, around);
      around.set(
          around.minX + Math.min(wayX, 0) - turned,
          around.minY + Math.min(wayY, 0) - turned,
          around.maxX + Math.max(wayX, 0) + turned,
          around.maxY + Math.max(wayY, 0) + turned);
      pairs.resting().query(around.minX, around.minY, around.maxX, around.maxY, onBullet);
    }
  }

  private boolean bullet(int part) {
    return !bodies.bullet(parts.body[part])
        || parts.sensor[part]
        || parts.sensor[searchPart]
        || overlap(part);
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

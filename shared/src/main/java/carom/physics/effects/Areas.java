package carom.physics.effects;

import carom.physics.World;
import carom.physics.dynamics.body.Checks;
import carom.physics.math.Aabb;

/** Checks and actions common to all areas. */
final class Areas {
  private Areas() {}

  static void check(Aabb area) {
    if (area.isEmpty()) {
      throw new IllegalArgumentException("area=" + area + " is empty, needs min <= max");
    }
    Checks.coordinate("minX", area.minX);
    Checks.coordinate("minY", area.minY);
    Checks.coordinate("maxX", area.maxX);
    Checks.coordinate("maxY", area.maxY);
  }

  static void wake(Nearby nearby, World<?> world, Aabb area) {
    nearby.find(world, area);
    for (int i = 0; i < nearby.count(); i++) {
      nearby.get(i).wake();
    }
    nearby.clear();
  }
}

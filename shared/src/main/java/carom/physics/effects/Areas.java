package carom.physics.effects;

import carom.physics.World;
import carom.physics.math.Aabb;
import carom.physics.math.Limits;

/** What all areas have in common. */
final class Areas {
  private Areas() {}

  static void check(Aabb area) {
    if (area.isEmpty()) {
      throw new IllegalArgumentException("area=" + area + " is empty, needs min <= max");
    }
    Limits.coordinate("minX", area.minX);
    Limits.coordinate("minY", area.minY);
    Limits.coordinate("maxX", area.maxX);
    Limits.coordinate("maxY", area.maxY);
  }

  static void wake(Nearby nearby, World<?> world, Aabb area) {
    nearby.find(world, area);
    for (int i = 0; i < nearby.count(); i++) {
      nearby.get(i).wake();
    }
    nearby.clear();
  }
}

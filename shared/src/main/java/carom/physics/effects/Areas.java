package carom.physics.effects;

import carom.physics.World;
import carom.physics.math.Aabb;
import carom.physics.math.Limits;
import carom.physics.math.Transform;

/** Checks and actions common to all areas. */
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

  /** Computes the box around an area in a frame. */
  static void reach(Aabb area, Transform frame, Aabb out) {
    out.setEmpty();
    out.add(frame.worldX(area.minX, area.minY), frame.worldY(area.minX, area.minY));
    out.add(frame.worldX(area.maxX, area.minY), frame.worldY(area.maxX, area.minY));
    out.add(frame.worldX(area.maxX, area.maxY), frame.worldY(area.maxX, area.maxY));
    out.add(frame.worldX(area.minX, area.maxY), frame.worldY(area.minX, area.maxY));
  }

  static void wake(Nearby nearby, World<?> world, Aabb area) {
    nearby.find(world, area);
    for (int i = 0; i < nearby.count(); i++) {
      nearby.get(i).wake();
    }
    nearby.clear();
  }
}

package carom.game.cars;

import static carom.game.cars.CarsFields.BRIDGE;
import static carom.game.cars.CarsFields.BROKEN;
import static carom.game.cars.CarsFields.CRATE;
import static carom.game.cars.CarsFields.CRATE_WAIT;
import static carom.game.cars.CarsFields.MENDS;
import static carom.game.cars.CarsFields.PLACE_OF;

import carom.sim.Match;
import carom.sim.Rules;
import carom.sim.entity.Entity;
import carom.sim.entity.EntityContactVisitor;
import carom.sim.entity.Player;
import carom.sim.level.Level;

/** Crates that break, on both sides; bridges and crates that are built again, the server's. */
final class Roadworks {
  private static final float MEND_SECONDS = 5;
  private static final float BRIDGE_ROOM = 22; // m around it in which nobody is
  private static final float CRATE_ROOM = 8;

  /** Impulse of a car that breaks a crate, N s. */
  private static final float CRASH = 0.4f;

  private final Track track;
  private final EntityContactVisitor touch = this::touch;
  private float blow; // scratch

  Roadworks(Track track) {
    this.track = track;
  }

  /** Breaks the crates that cars ran into. */
  void rules(Rules r) {
    for (Entity e : r.entities()) {
      if (e.archetype() == track.crate) {
        blow = 0;
        e.forEachContact(touch);
        if (blow > CRASH) {
          r.set(CRATE_WAIT, e.get(PLACE_OF), r.ticks(MEND_SECONDS));
          r.emit(track.crash).at(e.x(), e.y()).of(e).strength(blow);
          e.despawn();
        }
      }
    }
  }

  private void touch(Entity other, float normalX, float normalY, float impulse) {
    if (other.isOwned()) {
      blow += impulse;
    }
  }

  /** Builds what is broken or not there yet, where nobody is near. */
  void beforeStep(Match m) {
    for (int i = 0; i < track.crates.size(); i++) {
      Level.Spawn spot = track.crates.get(i);
      if (m.get(CRATE, i) == null
          && m.get(CRATE_WAIT, i) == 0
          && isLonely(m, spot.x(), spot.y(), CRATE_ROOM)) {
        Entity crate = m.spawn(track.crate, spot.x(), spot.y());
        crate.set(PLACE_OF, i);
        m.set(CRATE, i, crate);
      }
    }
    for (int i = 0; i < track.bridges.size(); i++) {
      Level.Zone zone = track.bridges.get(i);
      Entity bridge = m.get(BRIDGE, i);
      if (bridge == null) {
        m.set(BRIDGE, i, m.spawn(track.span(i), zone.minX(), zone.maxY(), 0, null));
      } else if (!m.get(BROKEN, i) && isBroken(bridge, zone)) {
        m.set(BROKEN, i, true);
        m.set(MENDS, i, m.ticks(MEND_SECONDS));
      } else if (m.get(BROKEN, i)
          && m.get(MENDS, i) == 0
          && isLonely(m, (zone.minX() + zone.maxX()) / 2, zone.maxY(), BRIDGE_ROOM)) {
        bridge.despawn();
        m.set(BROKEN, i, false);
      }
    }
  }

  private static boolean isLonely(Match m, float x, float y, float room) {
    for (Player p : m.players()) {
      Entity car = p.entity();
      if (car != null && Math.abs(car.x() - x) < room && Math.abs(car.y() - y) < room) {
        return false;
      }
    }
    return true;
  }

  private static boolean isBroken(Entity bridge, Level.Zone zone) {
    for (int i = 0; i <= Track.planks(zone); i++) {
      if (bridge.joint(Track.hinge(i)) == null) {
        return true;
      }
    }
    return false;
  }
}

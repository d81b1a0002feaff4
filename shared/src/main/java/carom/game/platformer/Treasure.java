package carom.game.platformer;

import static carom.game.platformer.PlatformerFields.COIN;
import static carom.game.platformer.PlatformerFields.COIN_WAIT;
import static carom.game.platformer.PlatformerFields.FLAG;
import static carom.game.platformer.PlatformerFields.FLAG_PLACE;
import static carom.game.platformer.PlatformerFields.FLAG_WAIT;
import static carom.sim.event.Audience.ALL;

import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.level.Level;

/** Coins and the flag: where they are, who gets them, when they come back; the server's. */
final class Treasure {
  private static final float COIN_SECONDS = 10;
  private static final float FLAG_SECONDS = 4;

  private final Course course;

  Treasure(Course course) {
    this.course = course;
  }

  /** Puts everything there at the start of a match. */
  void begin(SimulationHost s) {
    for (int i = 0; i < course.coins.size(); i++) {
      placeCoin(s, i);
    }
    placeFlag(s);
  }

  /** Brings back what was collected long enough ago. */
  void bringBack(SimulationHost s) {
    for (int i = 0; i < course.coins.size(); i++) {
      if (s.get(COIN, i) == null && s.get(COIN_WAIT, i) == 0) {
        placeCoin(s, i);
      }
    }
    if (s.get(FLAG) == null && s.get(FLAG_WAIT) == 0) {
      placeFlag(s);
    }
  }

  /** Gives a player what it has touched; returns its points, 0 if that is worth nothing. */
  int collect(SimulationHost s, HostPlayer p, HostEntity touched) {
    float x = touched.body().x();
    float y = touched.body().y();
    if (touched.archetype() == course.coin) {
      int place = placeOf(s, touched);
      s.emit(course.coinEvent).at(x, y).of(p.body()).by(p).data(place);
      s.despawn(touched);
      s.set(COIN_WAIT, place, s.ticks(COIN_SECONDS));
      return 1;
    }
    if (touched.archetype() == course.flag) {
      s.emit(course.flagEvent).at(x, y).of(p.body()).by(p).to(ALL);
      s.despawn(touched);
      s.set(FLAG_WAIT, s.ticks(FLAG_SECONDS));
      s.notice(p.name() + " got the flag: +" + PlatformerGame.FLAG_POINTS);
      return PlatformerGame.FLAG_POINTS;
    }
    return 0;
  }

  private static int placeOf(SimulationHost s, HostEntity coin) {
    int place = 0;
    while (s.get(COIN, place) != coin) {
      place++;
    }
    return place;
  }

  private void placeCoin(SimulationHost s, int i) {
    Level.Spawn spot = course.coins.get(i);
    s.set(COIN, i, s.spawn(course.coin, spot.x(), spot.y(), 0, null));
  }

  /** Puts the flag at another place than last time. */
  private void placeFlag(SimulationHost s) {
    int places = course.flags.size();
    if (places > 1) {
      int further = 1 + s.random().nextInt(places - 1);
      s.set(FLAG_PLACE, (s.get(FLAG_PLACE) + further) % places);
    }
    Level.Spawn spot = course.flags.get(s.get(FLAG_PLACE));
    s.set(FLAG, s.spawn(course.flag, spot.x(), spot.y(), 0, null));
  }
}

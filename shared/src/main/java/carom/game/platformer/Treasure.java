package carom.game.platformer;

import static carom.game.platformer.PlatformerFields.COIN;
import static carom.game.platformer.PlatformerFields.COIN_WAIT;
import static carom.game.platformer.PlatformerFields.FLAG;
import static carom.game.platformer.PlatformerFields.FLAG_PLACE;
import static carom.game.platformer.PlatformerFields.FLAG_WAIT;
import static carom.sim.event.Audience.ALL;

import carom.sim.Match;
import carom.sim.entity.Entity;
import carom.sim.entity.Player;
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
  void begin(Match m) {
    for (int i = 0; i < course.coins.size(); i++) {
      placeCoin(m, i);
    }
    placeFlag(m);
  }

  /** Brings back what was collected long enough ago. */
  void bringBack(Match m) {
    for (int i = 0; i < course.coins.size(); i++) {
      if (m.get(COIN, i) == null && m.get(COIN_WAIT, i) == 0) {
        placeCoin(m, i);
      }
    }
    if (m.get(FLAG) == null && m.get(FLAG_WAIT) == 0) {
      placeFlag(m);
    }
  }

  /** Gives a player what it has touched; returns its points, 0 if that is worth nothing. */
  int collect(Match m, Player p, Entity touched) {
    float x = touched.x();
    float y = touched.y();
    if (touched.archetype() == course.coin) {
      int place = placeOf(m, touched);
      m.emit(course.coinEvent).at(x, y).of(p.entity()).by(p).data(place);
      touched.despawn();
      m.set(COIN_WAIT, place, m.ticks(COIN_SECONDS));
      return 1;
    }
    if (touched.archetype() == course.flag) {
      m.emit(course.flagEvent).at(x, y).of(p.entity()).by(p).to(ALL);
      touched.despawn();
      m.set(FLAG_WAIT, m.ticks(FLAG_SECONDS));
      m.notice(m.name(p) + " got the flag: +" + PlatformerGame.FLAG_POINTS);
      return PlatformerGame.FLAG_POINTS;
    }
    return 0;
  }

  private static int placeOf(Match m, Entity coin) {
    int place = 0;
    while (m.get(COIN, place) != coin) {
      place++;
    }
    return place;
  }

  private void placeCoin(Match m, int i) {
    Level.Spawn spot = course.coins.get(i);
    m.set(COIN, i, m.spawn(course.coin, spot.x(), spot.y(), 0, null));
  }

  /** Puts the flag at another place than last time. */
  private void placeFlag(Match m) {
    int places = course.flags.size();
    if (places == 0) {
      return;
    }
    if (places > 1) {
      int further = 1 + m.random().nextInt(places - 1);
      m.set(FLAG_PLACE, (m.get(FLAG_PLACE) + further) % places);
    }
    Level.Spawn spot = course.flags.get(m.get(FLAG_PLACE));
    m.set(FLAG, m.spawn(course.flag, spot.x(), spot.y(), 0, null));
  }
}

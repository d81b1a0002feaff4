package carom.game.playground;

import static carom.game.playground.PlaygroundFields.BASKETS;
import static carom.game.playground.PlaygroundFields.CONTEST;
import static carom.game.playground.PlaygroundFields.GRABS;
import static carom.game.playground.PlaygroundFields.HELD;
import static carom.game.playground.PlaygroundFields.HOLDER;
import static carom.game.playground.PlaygroundFields.KEEPER;
import static carom.game.playground.PlaygroundFields.SAFE;
import static carom.game.playground.PlaygroundFields.STAR;
import static carom.game.playground.PlaygroundFields.STAR_SECONDS;
import static carom.game.playground.PlaygroundFields.STAR_TICKS;
import static carom.game.playground.PlaygroundFields.TOWER;

import carom.game.playground.PlaygroundFields.Contest;
import carom.sim.Match;
import carom.sim.MatchClock;
import carom.sim.entity.Entity;
import carom.sim.entity.Player;
import carom.sim.level.Level;

/** The contests that take turns in a match; the server's. A point is a point in all of them. */
final class Contests {
  private static final float SAFE_SECONDS = 2;
  private static final int LOOK_TICKS = 15; // from look to look at towers
  private static final float STILL = 0.15f; // m/s

  private final Yard yard;

  Contests(Yard yard) {
    this.yard = yard;
  }

  /** Goes on to the contest of the time, and counts. */
  void afterStep(Match m) {
    Contest now = due(m);
    if (now != m.get(CONTEST)) {
      begin(m, now);
    }
    if (now == Contest.TOWER && m.tick() % LOOK_TICKS == 0) {
      for (Player p : m.players()) {
        measure(m, p);
      }
    } else if (now == Contest.STAR) {
      keep(m);
    }
  }

  private static Contest due(Match m) {
    if (!MatchClock.isPlaying(m)) {
      return Contest.FREE;
    }
    int left = MatchClock.ticksLeft(m) / m.ticks(PlaygroundGame.CONTEST_SECONDS);
    return left >= 2 ? Contest.BASKETS : left == 1 ? Contest.TOWER : Contest.STAR;
  }

  private void begin(Match m, Contest now) {
    m.set(CONTEST, now);
    m.set(KEEPER, null);
    if (m.get(STAR) != null) {
      m.get(STAR).despawn();
    }
    switch (now) {
      case BASKETS -> m.notice("Baskets: bring loose things home, a point each");
      case TOWER -> m.notice("Tower: pile your own things up on the site, a point a metre");
      case STAR -> {
        m.set(STAR, m.spawn(yard.star, yard.starPlace.x(), yard.starPlace.y()));
        m.notice("Star: hold it, a point a second");
      }
      case FREE -> {}
    }
  }

  /** Takes a thing that has come into a basket, and lets it out of a chute. */
  void entered(Match m, Entity e) {
    if (e.isOwned() || !yard.isLoose(e) || e.archetype() == yard.star) {
      return;
    }
    Player p = e.get(HOLDER);
    if (p != null) {
      m.emit(yard.basket).at(e.x(), e.y()).by(p);
      if (m.get(CONTEST) == Contest.BASKETS) {
        p.add(BASKETS, 1);
        m.addScore(p, 1);
      }
    }
    Level.Spawn chute = yard.chutes.get(m.random().nextInt(yard.chutes.size()));
    e.teleport(chute.x(), chute.y(), 0);
    e.setVelocity(m.random().between(-3, 3), 0);
    e.set(HOLDER, null);
  }

  /** Gives a point for each metre by which a player's tower has grown. */
  private void measure(Match m, Player p) {
    float best = 0;
    for (int i = 0; i < p.spawnedCount(); i++) {
      Entity e = p.spawned(i);
      float speed = Math.abs(e.velocityX()) + Math.abs(e.velocityY());
      if (speed < STILL
          && yard.site.contains(e.x(), e.y())
          && !yard.isBalloon(e)
          && !isHeld(m, e)) {
        best = Math.max(best, e.y() + yard.half(e) - yard.site.minY());
      }
    }
    int grown = Math.min(TOWER.max(), (int) (best + 0.1f)) - p.get(TOWER);
    if (grown > 0) {
      p.add(TOWER, grown);
      m.addScore(p, grown);
      m.emit(yard.metre)
          .at(yard.site.minX() / 2 + yard.site.maxX() / 2, yard.site.minY() + best)
          .by(p);
    }
  }

  private static boolean isHeld(Match m, Entity e) {
    for (Player p : m.players()) {
      if (p.get(HELD) == e) {
        return true;
      }
    }
    return false;
  }

  /** Gives the star to who grabbed it last, and a point for each second. */
  private void keep(Match m) {
    Entity star = m.get(STAR);
    Player keeper = m.get(KEEPER);
    if (keeper != null && (star == null || keeper.get(HELD) != star)) {
      keeper = null;
    }
    for (Player p : m.players()) {
      if (p != keeper && star != null && p.get(HELD) == star) {
        if (keeper != null) {
          keeper.set(HELD, null);
          keeper.set(GRABS, false);
        }
        keeper = p;
        m.set(SAFE, m.ticks(SAFE_SECONDS));
        m.emit(yard.taken).at(star.x(), star.y()).of(star).by(p);
      }
    }
    if (keeper != m.get(KEEPER)) {
      m.set(KEEPER, keeper);
    }
    if (keeper != null) {
      keeper.add(STAR_TICKS, 1);
      if (keeper.get(STAR_TICKS) >= m.tickRate()) {
        keeper.set(STAR_TICKS, 0);
        keeper.add(STAR_SECONDS, 1);
        m.addScore(keeper, 1);
        m.emit(yard.second).at(star.x(), star.y()).by(keeper);
      }
    }
  }
}

package carom.game.platformer;

import static carom.game.platformer.PlatformerFields.RESPAWN;
import static carom.game.platformer.PlatformerFields.RESPAWN_PLACE;

import carom.sim.Match;
import carom.sim.entity.Entity;
import carom.sim.entity.Player;
import carom.sim.level.Level;

/** Players who join, fall and come back, and crates that fall; the server's. */
final class Respawns {
  private static final float RESPAWN_SECONDS = 1;

  private final Course course;

  Respawns(Course course) {
    this.course = course;
  }

  /** Gives a player who joins a body. */
  void join(Match m, Player p) {
    giveBody(m, p, p.id() % course.places.size());
  }

  /** Gives players who have waited long enough a body. */
  void bringBack(Match m) {
    for (Player p : m.players()) {
      if (!p.isAlive() && p.get(RESPAWN) == 0) {
        giveBody(m, p, p.get(RESPAWN_PLACE));
      }
    }
  }

  /** Takes players who have fallen out of the game for a while. */
  void loseFallen(Match m) {
    for (Player p : m.players()) {
      if (!p.isAlive() || !course.isLost(p.entity())) {
        continue;
      }
      Entity body = p.entity();
      int place = course.nearestPlace(body.x(), body.y());
      m.emit(course.fallEvent).at(body.x(), body.y()).by(p);
      p.entity().despawn();
      p.set(RESPAWN, m.ticks(RESPAWN_SECONDS));
      p.set(RESPAWN_PLACE, place);
    }
  }

  /** Puts bodies of the level that have fallen out back home. */
  void returnCrates(Match m) {
    for (int id = 0; id < m.level().bodies().size(); id++) {
      Entity body = m.entity(id);
      if (body.isDynamic() && course.isLost(body)) {
        Level.Placement home = m.level().bodies().get(id);
        body.teleport(home.x(), home.y(), home.angle());
        body.setVelocity(0, 0);
        body.setAngularVelocity(0);
      }
    }
  }

  /** Gives a player a body at a spawn, above any player who stands there already. */
  private void giveBody(Match m, Player p, int place) {
    Level.Spawn spot = course.places.get(place);
    p.resetFields();
    float y = spot.y();
    for (int i = 0; i < 5 && !isFree(m, spot.x(), y); i++) {
      y += PlatformerGame.PLAYER_HEIGHT + 0.1f;
    }
    m.spawn(course.player(p.id()), spot.x(), y, 0, p);
  }

  private static boolean isFree(Match m, float x, float y) {
    for (Player p : m.players()) {
      if (p.isAlive()
          && Math.abs(p.entity().x() - x) < PlatformerGame.PLAYER_WIDTH
          && Math.abs(p.entity().y() - y) < PlatformerGame.PLAYER_HEIGHT) {
        return false;
      }
    }
    return true;
  }
}

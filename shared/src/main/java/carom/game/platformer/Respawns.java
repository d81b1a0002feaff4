package carom.game.platformer;

import static carom.game.platformer.PlatformerFields.CHECKED;
import static carom.game.platformer.PlatformerFields.CHECK_X;
import static carom.game.platformer.PlatformerFields.CHECK_Y;
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

  /** Notes where a player comes back from now on. */
  void checkpoint(Match m, Player p, float x, float y) {
    if (p.get(CHECKED) && p.get(CHECK_X) == x && p.get(CHECK_Y) == y) {
      return;
    }
    p.set(CHECKED, true);
    p.set(CHECK_X, x);
    p.set(CHECK_Y, y);
    m.emit(course.checkpointEvent).at(x, y).by(p);
  }

  /** Puts a player who has come to the goal back to the start. */
  void returnToStart(Match m, Player p) {
    float x = (course.start.minX() + course.start.maxX()) / 2;
    int place = course.nearestPlace(x, course.start.minY());
    p.entity().despawn();
    p.set(CHECKED, false);
    giveBody(m, p, place);
  }

  private void comeBack(Match m, Player p) {
    Foes.spare(m, p);
    if (!p.get(CHECKED)) {
      giveBody(m, p, p.get(RESPAWN_PLACE));
      return;
    }
    giveBody(m, p, p.get(CHECK_X), p.get(CHECK_Y));
  }

  /** Takes a player who has fallen out of the game for a while, and gives it another body then. */
  void afterStep(Match m, Player p) {
    if (!p.isAlive()) {
      if (p.get(RESPAWN) == 0) {
        comeBack(m, p);
      }
    } else if (course.isLost(p.entity())) {
      Entity body = p.entity();
      int place = course.nearestPlace(body.x(), body.y());
      m.emit(course.fallEvent).at(body.x(), body.y()).by(p);
      body.despawn();
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
    giveBody(m, p, spot.x(), spot.y());
  }

  private void giveBody(Match m, Player p, float x, float lowest) {
    Runners.reset(p);
    float y = lowest;
    for (int i = 0; i < 5 && !isFree(m, x, y); i++) {
      y += PlatformerGame.PLAYER_HEIGHT + 0.1f;
    }
    m.spawn(course.player(p.id()), x, y, 0, p);
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

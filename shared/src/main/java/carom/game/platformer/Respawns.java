package carom.game.platformer;

import static carom.game.platformer.PlatformerFields.RESPAWN;
import static carom.game.platformer.PlatformerFields.RESPAWN_PLACE;

import carom.physics.Body;
import carom.physics.BodyType;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.level.Level;

/** Players who join, fall and come back, and crates that fall; the server's. */
final class Respawns {
  private static final float RESPAWN_SECONDS = 1;

  private final Course course;

  Respawns(Course course) {
    this.course = course;
  }

  /** Gives a player who joins a body. */
  void join(SimulationHost s, HostPlayer p) {
    giveBody(s, p, p.id() % course.places.size());
  }

  /** Gives players who have waited long enough a body. */
  void bringBack(SimulationHost s) {
    for (int id = 0; id < s.playerCapacity(); id++) {
      HostPlayer p = s.player(id);
      if (p != null && p.body() == null && p.get(RESPAWN) == 0) {
        giveBody(s, p, p.get(RESPAWN_PLACE));
      }
    }
  }

  /** Takes players who have fallen out of the game for a while. */
  void loseFallen(SimulationHost s) {
    for (int id = 0; id < s.playerCapacity(); id++) {
      HostPlayer p = s.player(id);
      if (p == null || p.body() == null || !course.isLost(p.body().body())) {
        continue;
      }
      Body<HostEntity> body = p.body().body();
      int place = course.nearestPlace(body.x(), body.y());
      s.emit(course.fallEvent).at(body.x(), body.y()).by(p);
      s.despawn(p.body());
      p.set(RESPAWN, s.ticks(RESPAWN_SECONDS));
      p.set(RESPAWN_PLACE, place);
    }
  }

  /** Puts bodies of the level that have fallen out back home. */
  void returnCrates(SimulationHost s) {
    for (int id = 0; id < s.level().bodies().size(); id++) {
      Body<HostEntity> body = s.entity(id).body();
      if (body.type() == BodyType.DYNAMIC && course.isLost(body)) {
        Level.Placement home = s.level().bodies().get(id);
        s.entity(id).teleport(home.x(), home.y(), home.angle());
        body.setVelocity(0, 0);
        body.setAngularVelocity(0);
      }
    }
  }

  /** Gives a player a body at a spawn, above any player who stands there already. */
  private void giveBody(SimulationHost s, HostPlayer p, int place) {
    Level.Spawn spot = course.places.get(place);
    p.resetFields();
    float y = spot.y();
    for (int i = 0; i < 5 && !isFree(s, spot.x(), y); i++) {
      y += PlatformerGame.PLAYER_HEIGHT + 0.1f;
    }
    s.spawn(course.player(p.id()), spot.x(), y, 0, p);
  }

  private static boolean isFree(SimulationHost s, float x, float y) {
    for (int id = 0; id < s.playerCapacity(); id++) {
      HostPlayer p = s.player(id);
      if (p != null
          && p.body() != null
          && Math.abs(p.body().body().x() - x) < PlatformerGame.PLAYER_WIDTH
          && Math.abs(p.body().body().y() - y) < PlatformerGame.PLAYER_HEIGHT) {
        return false;
      }
    }
    return true;
  }
}

package carom.game.arena;

import carom.physics.Body;
import carom.physics.BodyType;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.level.Level;

/** The players' discs and teams: where discs appear, and what brings them and crates back. */
final class Discs {
  /** Radius, m. */
  static final float RADIUS = 0.6f;

  private final Pitch pitch;

  Discs(Pitch pitch) {
    this.pitch = pitch;
  }

  /** Gives a player the disc of its new team, and tells all players. */
  void changeTeam(SimulationHost s, HostPlayer p) {
    give(s, p);
    s.notice(p.name() + " now plays for " + Pitch.TEAM_NAMES[p.team()]);
  }

  /**
   * Moves the newest players of the larger team to the other one, until the sizes differ by one at
   * most.
   */
  void balance(SimulationHost s) {
    for (int id = s.playerCapacity() - 1; id >= 0; id--) {
      int more = s.teamSize(1) - s.teamSize(2);
      HostPlayer p = s.player(id);
      if (p != null && ((more > 1 && p.team() == 1) || (more < -1 && p.team() == 2))) {
        p.team(Pitch.TEAMS + 1 - p.team());
        changeTeam(s, p);
      }
    }
  }

  /** Brings back players and crates that left the field, and crates that block a goal. */
  void bringBack(SimulationHost s) {
    Level.Bounds bounds = s.level().bounds();
    for (int id = 0; id < s.playerCapacity(); id++) {
      HostPlayer p = s.player(id);
      if (p != null && p.body() != null) {
        Body<HostEntity> body = p.body().body();
        if (!bounds.contains(body.x(), body.y())) {
          give(s, p);
        }
      }
    }
    for (int id = 0; id < s.level().bodies().size(); id++) {
      Body<HostEntity> body = s.entity(id).body();
      if (!bounds.contains(body.x(), body.y()) || pitch.isInGoal(body.x(), body.y())) {
        sendHome(s, id);
      }
    }
  }

  private static void sendHome(SimulationHost s, int id) {
    Body<HostEntity> body = s.entity(id).body();
    if (body.type() == BodyType.DYNAMIC) {
      Level.Placement p = s.level().bodies().get(id);
      s.entity(id).teleport(p.x(), p.y(), p.angle());
      body.setVelocity(0, 0);
      body.setAngularVelocity(0);
    }
  }

  /** Gives a player a new body at a free place of the team's home. */
  void give(SimulationHost s, HostPlayer p) {
    if (p.body() != null) {
      s.despawn(p.body());
    }
    p.resetFields();
    Level.Zone home = pitch.homes[p.team()];
    float cell = 2.2f * RADIUS;
    int columns = Math.max(1, (int) ((home.maxX() - home.minX()) / cell));
    int rows = Math.max(1, (int) ((home.maxY() - home.minY()) / cell));
    int start = s.random().nextInt(columns * rows);
    float x = 0;
    float y = 0;
    for (int i = 0; i < columns * rows; i++) {
      int place = (start + i) % (columns * rows);
      int row = place / columns;
      x = home.minX() + (place % columns + 0.5f) * cell;
      y = home.minY() + (row + 0.5f) * cell;
      if (isFree(s, x, y)) {
        break;
      }
    }
    s.spawn(pitch.discs[p.team()], x, y, p.team() == 1 ? 0 : (float) Math.PI, p);
  }

  private static boolean isFree(SimulationHost s, float x, float y) {
    float distance = RADIUS + 0.7f;
    for (int id = 0; id < s.entityCapacity(); id++) {
      HostEntity e = s.entity(id);
      if (e != null && !e.archetype().sensor()) {
        float dx = e.body().x() - x;
        float dy = e.body().y() - y;
        if (dx * dx + dy * dy < distance * distance) {
          return false;
        }
      }
    }
    return true;
  }
}

package carom.game.arena;

import carom.sim.Match;
import carom.sim.entity.Entity;
import carom.sim.entity.Player;
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
  void changeTeam(Match m, Player p) {
    give(m, p);
    m.notice(m.name(p) + " now plays for " + Pitch.TEAM_NAMES[m.team(p)]);
  }

  /**
   * Moves the newest players of the larger team to the other one, until the sizes differ by one at
   * most.
   */
  void balance(Match m) {
    while (Math.abs(m.teamSize(1) - m.teamSize(2)) > 1) {
      int larger = m.teamSize(1) > m.teamSize(2) ? 1 : 2;
      Player newest = null;
      for (Player p : m.players()) {
        newest = m.team(p) == larger ? p : newest;
      }
      m.team(newest, Pitch.TEAMS + 1 - larger);
      changeTeam(m, newest);
    }
  }

  /** Brings back players and crates that left the field, and crates that block a goal. */
  void bringBack(Match m) {
    Level.Bounds bounds = m.level().bounds();
    for (Player p : m.players()) {
      if (p.isAlive() && !bounds.contains(p.entity().x(), p.entity().y())) {
        give(m, p);
      }
    }
    for (int id = 0; id < m.level().bodies().size(); id++) {
      Entity body = m.entity(id);
      if (!bounds.contains(body.x(), body.y()) || pitch.isInGoal(body.x(), body.y())) {
        sendHome(m, id);
      }
    }
  }

  private static void sendHome(Match m, int id) {
    Entity body = m.entity(id);
    if (body.isDynamic()) {
      Level.Placement p = m.level().bodies().get(id);
      body.teleport(p.x(), p.y(), p.angle());
      body.setVelocity(0, 0);
      body.setAngularVelocity(0);
    }
  }

  /** Gives a player a new body at a free place of the team's home. */
  void give(Match m, Player p) {
    if (p.entity() != null) {
      p.entity().despawn();
    }
    p.resetFields();
    Level.Zone home = pitch.homes[m.team(p)];
    float cell = 2.2f * RADIUS;
    int columns = Math.max(1, (int) ((home.maxX() - home.minX()) / cell));
    int rows = Math.max(1, (int) ((home.maxY() - home.minY()) / cell));
    int start = m.random().nextInt(columns * rows);
    float x = 0;
    float y = 0;
    for (int i = 0; i < columns * rows; i++) {
      int place = (start + i) % (columns * rows);
      int row = place / columns;
      x = home.minX() + (place % columns + 0.5f) * cell;
      y = home.minY() + (row + 0.5f) * cell;
      if (isFree(m, x, y)) {
        break;
      }
    }
    m.spawn(pitch.discs[m.team(p)], x, y, m.team(p) == 1 ? 0 : (float) Math.PI, p);
  }

  private static boolean isFree(Match m, float x, float y) {
    float distance = RADIUS + 0.7f;
    for (Entity e : m.entities()) {
      if (!e.archetype().sensor()) {
        float dx = e.x() - x;
        float dy = e.y() - y;
        if (dx * dx + dy * dy < distance * distance) {
          return false;
        }
      }
    }
    return true;
  }
}

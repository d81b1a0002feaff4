package carom.game.shooter;

import static carom.game.shooter.ShooterFields.AMMO;
import static carom.game.shooter.ShooterFields.BLAMED;
import static carom.game.shooter.ShooterFields.BROKEN;
import static carom.game.shooter.ShooterFields.DAMAGE;
import static carom.game.shooter.ShooterFields.FADES;
import static carom.game.shooter.ShooterFields.HEALS;
import static carom.game.shooter.ShooterFields.HIT_BY;
import static carom.game.shooter.ShooterFields.LIVES;
import static carom.game.shooter.ShooterFields.OUT;
import static carom.game.shooter.ShooterFields.RAGDOLL;
import static carom.game.shooter.ShooterFields.SAFE;
import static carom.game.shooter.ShooterFields.SUDDEN;
import static carom.game.shooter.ShooterFields.WEAPON;

import carom.sim.Match;
import carom.sim.MatchClock;
import carom.sim.entity.Entity;
import carom.sim.entity.Player;
import carom.sim.level.Level;

/** Players who begin, are knocked out and come back, and what is left of them; the server's. */
final class Lives {
  private static final float OUT_SECONDS = 2;
  private static final float SAFE_SECONDS = 1.5f;
  private static final float RAGDOLL_SECONDS = 2.5f;

  /** Damage that a medkit takes away. */
  private static final int MEDKIT = 60;

  private final Stage stage;

  Lives(Stage stage) {
    this.stage = stage;
  }

  /** Gives a player who joins a body; one who comes late has one life. */
  void join(Match m, Player p) {
    if (MatchClock.isPlaying(m)) {
      p.set(LIVES, m.get(SUDDEN) ? 0 : 1);
    }
    if (p.get(LIVES) > 0) {
      giveBody(m, p, place(m, p));
    }
  }

  /** Begins the match for a player, from its own place. */
  void begin(Match m, Player p) {
    if (p.isAlive()) {
      p.entity().despawn();
    }
    forget(p);
    p.resetFields();
    m.score(p, 0);
    giveBody(m, p, stage.places.get(p.id() % stage.places.size()));
  }

  /** Brings back players who were out for long enough, and takes ragdolls away. */
  void bringBack(Match m) {
    for (Player p : m.players()) {
      if (!p.isAlive() && p.get(LIVES) > 0 && p.get(OUT) == 0) {
        giveBody(m, p, place(m, p));
      }
      if (p.get(FADES) == 0) {
        forget(p);
      }
    }
  }

  /** Takes away what is left of a player. */
  void forget(Player p) {
    Entity ragdoll = p.get(RAGDOLL);
    if (ragdoll != null) {
      ragdoll.despawn();
    }
  }

  private void giveBody(Match m, Player p, Level.Spawn spot) {
    p.set(DAMAGE, 0);
    p.set(BLAMED, 0);
    p.set(WEAPON, Weapon.PISTOL);
    p.set(AMMO, 0);
    p.set(SAFE, m.ticks(SAFE_SECONDS));
    m.spawn(stage.player(p.id()), spot.x(), spot.y(), 0, p);
  }

  /** Returns the place that is furthest from the others; in sudden death the highest one. */
  private Level.Spawn place(Match m, Player p) {
    Level.Spawn best = null;
    float most = Float.NEGATIVE_INFINITY;
    for (Level.Spawn spot : stage.places) {
      float room = m.get(SUDDEN) ? spot.y() : distance(m, p, spot);
      if (room > most) {
        most = room;
        best = spot;
      }
    }
    return best;
  }

  private static float distance(Match m, Player p, Level.Spawn spot) {
    float nearest = 1_000 + m.random().nextFloat();
    for (Player other : m.players()) {
      if (other != p && other.isAlive()) {
        float dx = other.entity().x() - spot.x();
        float dy = other.entity().y() - spot.y();
        nearest = Math.min(nearest, (float) Math.sqrt(dx * dx + dy * dy));
      }
    }
    return nearest;
  }

  /** Takes players out who have fallen or can bear no more, and takes away what fell or broke. */
  void afterStep(Match m) {
    for (Entity e : m.entities()) {
      if (e.get(BROKEN)) {
        m.emit(stage.crash).at(e.x(), e.y());
        e.despawn();
      } else if (e.isDynamic() && !e.isOwned() && stage.isLost(e)) {
        e.despawn();
      }
    }
    for (Player p : m.players()) {
      if (p.get(HEALS)) {
        p.add(DAMAGE, -MEDKIT);
        p.set(HEALS, false);
      }
      if (p.isAlive() && (p.get(DAMAGE) == DAMAGE.max() || stage.isLost(p.entity()))) {
        knockOut(m, p);
      }
    }
  }

  private void knockOut(Match m, Player p) {
    Entity body = p.entity();
    Player by = p.get(BLAMED) > 0 ? p.get(HIT_BY) : null;
    m.emit(stage.knockOut).at(body.x(), body.y()).of(body).by(p);
    tumble(m, p, body);
    body.despawn();
    p.set(OUT, m.ticks(OUT_SECONDS));
    if (!MatchClock.isPlaying(m)) {
      return;
    }
    if (by != null) {
      m.addScore(by, 1);
    }
    p.add(LIVES, m.get(SUDDEN) ? -ShooterGame.LIVES : -1);
    String end = p.get(LIVES) > 0 ? "" : ", for good";
    m.notice(
        by == null ? m.name(p) + " fell" + end : m.name(by) + " knocked out " + m.name(p) + end);
  }

  private void tumble(Match m, Player p, Entity body) {
    forget(p);
    Entity torso = m.spawn(stage.ragdoll(p.id()), body.x(), body.y(), 0, null);
    for (int i = 0; i < Stage.PARTS.length; i++) {
      Entity part = torso.part(Stage.PARTS[i]);
      part.setVelocity(body.velocityX(), body.velocityY() + 2);
      part.setAngularVelocity(i % 2 == 0 ? 9 : -9);
    }
    p.set(RAGDOLL, torso);
    p.set(FADES, m.ticks(RAGDOLL_SECONDS));
  }
}

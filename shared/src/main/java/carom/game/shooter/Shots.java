package carom.game.shooter;

import static carom.game.shooter.ShooterFields.AMMO;
import static carom.game.shooter.ShooterFields.BLAMED;
import static carom.game.shooter.ShooterFields.BROKEN;
import static carom.game.shooter.ShooterFields.COVER;
import static carom.game.shooter.ShooterFields.DAMAGE;
import static carom.game.shooter.ShooterFields.FIRED_BY;
import static carom.game.shooter.ShooterFields.FUEL;
import static carom.game.shooter.ShooterFields.HIT_BY;
import static carom.game.shooter.ShooterFields.RELOAD;
import static carom.game.shooter.ShooterFields.SAFE;
import static carom.game.shooter.ShooterFields.WEAPON;

import carom.physics.math.Trig;
import carom.sim.Match;
import carom.sim.MatchClock;
import carom.sim.Simulation;
import carom.sim.entity.Entity;
import carom.sim.entity.EntityContactVisitor;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.outbox.Event;
import java.util.function.Predicate;

/**
 * Shots: how they begin and end, in both roles, and what they do to others, the server's. As in
 * {@code RocketGame}, both ask {@link #isSpent}, one tick apart, which depends on nothing but the
 * state between two ticks.
 */
final class Shots {
  private static final float MUZZLE = 0.7f;
  private static final float LIFT = 0.3f; // of a blow, upwards
  private static final float BLAME_SECONDS = 4;

  /** Damage that breaks cover as strong as can be. */
  private static final float COVER_STRENGTH = 60;

  private static final float OWN_BLAST = 0.4f; // damage of an own blast

  private final Stage stage;
  private final EntityContactVisitor touch = this::touch;
  private final Predicate<Entity> push = this::push;

  // Scratch: hold nothing between two calls.
  private Entity flying;
  private Entity touched;
  private Match match;
  private Player shooter;

  Shots(Stage stage) {
    this.stage = stage;
  }

  /** Ends a player's shots that are spent, and fires as the player commands. */
  void input(Simulation s, Player p, Input in) {
    for (int i = p.spawnedCount() - 1; i >= 0; i--) {
      Entity shot = p.spawned(i);
      if (isSpent(shot, 0)) {
        boolean hurts = touched != null && isFighter(touched);
        Event end =
            s.emit(isRocket(shot) ? stage.boom : hurts ? stage.hit : stage.spark)
                .at(shot.x(), shot.y())
                .of(shot)
                .by(p)
                .strength(shot.get(FIRED_BY).damage);
        if (hurts) {
          end.of(touched).with(shot);
        }
        shot.despawn();
      }
    }
    if (in.held(Input.ACTION) && p.get(RELOAD) == 0 && !p.isFull()) {
      fire(s, p, in.aim());
    }
  }

  private void fire(Simulation s, Player p, float aim) {
    Weapon weapon = p.get(WEAPON);
    Entity body = p.entity();
    for (int i = 0; i < weapon.shots && !p.isFull(); i++) {
      float angle = aim + weapon.spread * miss(s.tick(), i, weapon.shots);
      float wayX = Trig.cos(angle);
      float wayY = Trig.sin(angle);
      Entity shot =
          p.spawn(
              weapon.blasts() ? stage.rocket : stage.bullet,
              body.x() + MUZZLE * wayX,
              body.y() + MUZZLE * wayY,
              angle);
      shot.setVelocity(weapon.speed * wayX, weapon.speed * wayY);
      shot.set(FIRED_BY, weapon);
      shot.set(FUEL, s.ticks(weapon.flight));
    }
    float x = Trig.cos(aim);
    float y = Trig.sin(aim);
    float recoil = -weapon.recoil * body.mass();
    body.applyImpulse(recoil * x, recoil * y);
    s.emit(stage.shot)
        .at(body.x() + MUZZLE * x, body.y() + MUZZLE * y)
        .of(body)
        .by(p)
        .strength(weapon.damage * weapon.shots);
    p.set(RELOAD, s.ticks(weapon.seconds));
    if (weapon.ammo > 0) {
      p.add(AMMO, -1);
      if (p.get(AMMO) == 0) {
        p.set(WEAPON, Weapon.PISTOL);
      }
    }
  }

  /** Returns by how much of its spread a shot misses, -1..1: a fan, or another each tick. */
  private static float miss(int tick, int shot, int shots) {
    return shots > 1 ? 2f * shot / (shots - 1) - 1 : ((tick * 37 & 15) - 7.5f) / 7.5f;
  }

  private boolean isRocket(Entity shot) {
    return shot.archetype() == stage.rocket;
  }

  /**
   * Returns whether a shot ends in a tick's input, and finds what it touched.
   *
   * @param ticksUntil ticks until that tick's input: 0 in it, 1 in the tick before
   */
  private boolean isSpent(Entity shot, int ticksUntil) {
    touched = null;
    flying = shot;
    shot.forEachContact(touch);
    return touched != null || shot.get(FUEL) <= ticksUntil || stage.isLost(shot);
  }

  private void touch(Entity other, float normalX, float normalY, float impulse) {
    if (touched == null && impulse > 0 && !other.isOfSameOwner(flying)) {
      touched = other;
    }
  }

  /** Applies what the shots of a player do that end in the next input. */
  void afterStep(Match m, Player p) {
    boolean isOut = !p.isAlive(); // then no input goes on with its shots
    for (int i = p.spawnedCount() - 1; i >= 0; i--) {
      Entity shot = p.spawned(i);
      if (isSpent(shot, 1)) {
        Weapon weapon = shot.get(FIRED_BY);
        if (weapon.blasts()) {
          blast(m, p, shot);
        } else if (touched != null) {
          knock(m, p, touched, weapon, 1, shot.cos(), shot.sin());
        }
      }
      if (isOut) {
        shot.despawn();
      }
    }
  }

  private void blast(Match m, Player p, Entity shot) {
    match = m;
    shooter = p;
    flying = shot;
    float x = shot.x();
    float y = shot.y();
    float reach = Weapon.BLAST_RADIUS;
    m.forEachInBox(x - reach, y - reach, x + reach, y + reach, push);
  }

  private boolean push(Entity e) {
    float dx = e.centerX() - flying.x();
    float dy = e.centerY() - flying.y();
    float distance = Math.max(0.1f, (float) Math.sqrt(dx * dx + dy * dy));
    float share = 1.2f * (1 - distance / Weapon.BLAST_RADIUS); // full a little around the middle
    if (share > 0 && e.isDynamic() && !stage.isShot(e)) {
      Weapon weapon = flying.get(FIRED_BY);
      knock(match, shooter, e, weapon, Math.min(1, share), dx / distance, dy / distance);
    }
    return true;
  }

  private static boolean isFighter(Entity e) {
    return e.isOwned() && e.owner().entity() == e;
  }

  /** Knocks a body, the harder the more damage a player has, and harms it. */
  private void knock(
      Match m, Player by, Entity e, Weapon weapon, float share, float wayX, float wayY) {
    float speed = weapon.kick * share;
    if (isFighter(e)) {
      Player victim = e.owner();
      if (victim.get(SAFE) > 0) {
        return;
      }
      float harm = victim == by ? OWN_BLAST : 1;
      victim.add(DAMAGE, Math.round(weapon.damage * share * harm));
      speed *= 0.5f + victim.get(DAMAGE) / 100f;
      if (victim != by) {
        victim.set(HIT_BY, by);
        victim.set(BLAMED, m.ticks(BLAME_SECONDS));
      }
    } else if (e.get(COVER) > 0 && MatchClock.isPlaying(m)) {
      e.add(COVER, -weapon.damage * share / COVER_STRENGTH);
      e.set(BROKEN, e.get(COVER) == 0);
    }
    if (e.isDynamic()) {
      e.applyImpulse(speed * e.mass() * wayX, speed * e.mass() * (wayY + LIFT));
    }
  }
}

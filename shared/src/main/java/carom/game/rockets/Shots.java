package carom.game.rockets;

import static carom.game.rockets.RocketFields.AMMO;
import static carom.game.rockets.RocketFields.FIRED_BY;
import static carom.game.rockets.RocketFields.FUEL;
import static carom.game.rockets.RocketFields.HEALTH;
import static carom.game.rockets.RocketFields.RELOAD;
import static carom.game.rockets.RocketFields.SETS_OFF;
import static carom.game.rockets.RocketFields.SHIELDED;
import static carom.game.rockets.RocketFields.WEAPON;

import carom.physics.math.Trig;
import carom.sim.Match;
import carom.sim.Simulation;
import carom.sim.entity.Entity;
import carom.sim.entity.EntityContactVisitor;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import java.util.function.Predicate;

/**
 * Shots: how they begin, fly and end, in both roles, and what their blasts do to others, the
 * server's. {@code input} fires shots and removes those that are spent, so a player sees both at
 * once. What the blast does is for {@code afterStep}, a moment before: both ask {@link #isSpent},
 * which depends on nothing but the state between two ticks.
 */
final class Shots {
  private static final float MUZZLE = 0.75f;
  private static final float MINE_DISTANCE = 1.1f;
  private static final float THRUST = 22; // of a torpedo, m/s^2
  private static final float TORPEDO_SPEED = 32; // the most, m/s

  /** Share of a blast that comes through a shield, and of its push. */
  private static final float SHIELD_HARM = 0.15f;

  private static final float SHIELD_KICK = 0.4f;
  private static final float ROCK_KICK = 0.25f; // rocks are heavy

  private final Sky sky;
  private final Rocks rocks;
  private final float rocketSeconds;
  private final EntityContactVisitor touch = this::touch;
  private final Predicate<Entity> push = this::push;

  // Scratch: hold nothing between two calls.
  private Match match;
  private Player shooter;
  private Entity flying;
  private boolean touches;

  /**
   * Creates the shots of a match.
   *
   * @param rocketSeconds time from rocket to rocket
   */
  Shots(Sky sky, Rocks rocks, float rocketSeconds) {
    this.sky = sky;
    this.rocks = rocks;
    this.rocketSeconds = rocketSeconds;
  }

  /** Ends a player's shots that are spent, and fires as the player commands. */
  void input(Simulation s, Player p, Input in) {
    for (int i = p.spawnedCount() - 1; i >= 0; i--) {
      Entity fired = p.spawned(i);
      if (isSpent(p, fired, 0)) {
        boolean isBolt = fired.get(FIRED_BY) == Weapon.SCATTER;
        s.emit(isBolt ? sky.spark : sky.boom).at(fired.x(), fired.y()).of(fired).by(p);
        fired.despawn();
      }
    }
    p.set(SETS_OFF, in.held(Input.SECOND));
    boolean mayFire = p.get(RELOAD) == 0 && !p.get(SHIELDED) && !p.isFull();
    if (in.held(Input.ACTION) && mayFire) {
      fire(s, p, in.aim());
    }
  }

  /** Speeds a torpedo up, the way it flies. */
  void forces(Entity e) {
    if (e.archetype() == sky.shots[Weapon.TORPEDO.ordinal()]) {
      float speed =
          (float) Math.sqrt(e.velocityX() * e.velocityX() + e.velocityY() * e.velocityY());
      float force = speed < TORPEDO_SPEED ? THRUST * e.mass() / Math.max(0.1f, speed) : 0;
      e.applyForce(force * e.velocityX(), force * e.velocityY());
    }
  }

  private void fire(Simulation s, Player p, float aim) {
    Weapon weapon = p.get(WEAPON);
    Entity body = p.entity();
    for (int i = 0; i < weapon.shots && !p.isFull(); i++) {
      float miss = weapon.shots > 1 ? 2f * i / (weapon.shots - 1) - 1 : 0;
      float wayX = Trig.cos(aim + weapon.spread * miss);
      float wayY = Trig.sin(aim + weapon.spread * miss);
      float from = weapon == Weapon.MINES ? -MINE_DISTANCE : MUZZLE;
      float speed = weapon == Weapon.MINES ? -weapon.speed : weapon.speed;
      Entity fired =
          p.spawn(sky.shots[weapon.ordinal()], body.x() + from * wayX, body.y() + from * wayY, 0);
      fired.setVelocity(speed * wayX, speed * wayY);
      fired.set(FIRED_BY, weapon);
      fired.set(FUEL, s.ticks(weapon.flight));
    }
    float x = Trig.cos(aim);
    float y = Trig.sin(aim);
    body.applyImpulse(-weapon.recoil * body.mass() * x, -weapon.recoil * body.mass() * y);
    s.emit(sky.shot).at(body.x() + MUZZLE * x, body.y() + MUZZLE * y).by(p);
    p.set(RELOAD, s.ticks(weapon == Weapon.ROCKET ? rocketSeconds : weapon.seconds));
    if (weapon.ammo > 0) {
      p.add(AMMO, -1);
      if (p.get(AMMO) == 0) {
        p.set(WEAPON, Weapon.ROCKET);
      }
    }
  }

  /**
   * Returns whether a shot goes off in a tick's input.
   *
   * @param ticksUntil ticks until that tick's input: 0 in it, 1 in the tick before
   */
  private boolean isSpent(Player p, Entity fired, int ticksUntil) {
    touches = false;
    flying = fired;
    fired.forEachContact(touch);
    return touches || p.get(SETS_OFF) || fired.get(FUEL) <= ticksUntil;
  }

  /** Notes what a shot touches; a mine may lie at a wall. */
  private void touch(Entity other, float normalX, float normalY, float impulse) {
    boolean ignores = flying.get(FIRED_BY) == Weapon.MINES && !other.isDynamic();
    touches |= !ignores && !other.isOfSameOwner(flying);
  }

  /** Applies what the shots of a player do that go off in the next input. */
  void afterStep(Match m, Player p) {
    boolean isOut = !p.isAlive(); // then no input goes on with its shots
    for (int i = p.spawnedCount() - 1; i >= 0; i--) {
      Entity fired = p.spawned(i);
      if (isOut || isSpent(p, fired, 1)) {
        blast(m, p, fired);
      }
      if (isOut) {
        fired.despawn();
      }
    }
  }

  private void blast(Match m, Player p, Entity fired) {
    match = m;
    shooter = p;
    flying = fired;
    float x = fired.x();
    float y = fired.y();
    float reach = fired.get(FIRED_BY).radius;
    m.forEachInBox(x - reach, y - reach, x + reach, y + reach, push);
  }

  private boolean push(Entity e) {
    Weapon weapon = flying.get(FIRED_BY);
    float dx = e.centerX() - flying.x();
    float dy = e.centerY() - flying.y();
    float distance = (float) Math.sqrt(dx * dx + dy * dy);
    boolean isRock = sky.rock(e) >= 0;
    float gap = isRock ? Math.max(0, distance - Sky.radius(sky.rock(e)) + 0.5f) : distance;
    float share = 1 - gap / weapon.radius;
    if (!e.isDynamic() || share <= 0 || sky.isShot(e)) {
      return true;
    }
    float kick = weapon.kick * share;
    if (isRock) {
      rocks.damage(e, weapon.damage * share);
      kick *= ROCK_KICK;
    } else if (e.isOwned() && e.owner() != shooter) {
      kick *= harm(e, weapon, share);
    }
    float scale = kick * e.mass() / Math.max(0.1f, distance);
    e.applyImpulse(scale * dx, scale * dy);
    return true;
  }

  /** Takes health from a player who is hit; returns the share of the push that it gets. */
  private float harm(Entity ship, Weapon weapon, float share) {
    Player victim = ship.owner();
    boolean isShielded = victim.get(SHIELDED);
    if (victim.get(HEALTH) == 0) {
      return 1; // another blast of this tick was the last one
    }
    if (isShielded) {
      match.emit(sky.blocked).at(ship.x(), ship.y()).of(ship).by(victim);
    }
    victim.add(HEALTH, -Math.round(weapon.damage * share * (isShielded ? SHIELD_HARM : 1)));
    if (victim.get(HEALTH) == 0) {
      victim.set(RocketFields.WRECKED_BY, shooter);
      victim.set(RocketFields.WRECKED_WITH, weapon);
    }
    return isShielded ? SHIELD_KICK : 1;
  }
}

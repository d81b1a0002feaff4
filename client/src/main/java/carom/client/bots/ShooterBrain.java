package carom.client.bots;

import carom.client.view.ClientView.Drawn;
import carom.game.shooter.ShooterFields;
import carom.game.shooter.Weapon;
import carom.sim.entity.Input;
import carom.sim.level.Level;
import java.util.List;

/**
 * Plays {@code shooter}: jumps from foothold to foothold, fetches weapons, keeps a distance, aims
 * at where the enemy will be, and looks for a medkit, or room, once it is hurt.
 */
public final class ShooterBrain extends GradedBrain {
  private static final List<String> WEAPONS = List.of("shotgun", "rifle", "launcher");
  private static final float FEET = 0.7f; // below the middle, m
  private static final int HURT = 55;

  /** Distance within which it flees from an enemy when it is hurt, m. */
  private static final float RETREAT = 8;

  /** Gravity of a rocket, m/s^2: a share of the level's. */
  private static final float ROCKET_GRAVITY = 0.35f;

  private static final float ON_CRATES = 6;
  private static final int JUMP_TICKS = 10;
  private static final int PATIENCE_TICKS = 150;
  private static final int DETOUR_TICKS = 40;

  private Footholds footholds;
  private Level level;
  private int next = -1; // foothold that it jumps to
  private float lastVelocityY;
  private int steady;
  private int jumpedAt;
  private boolean jumps;
  private float markX;
  private float markY;
  private int markTick;
  private int side = 1;
  private int seenFor;
  private float miss;
  private boolean holdsFire;

  /** Creates a bot of a strength that its random numbers choose, for the service loader. */
  public ShooterBrain() {
    this(null);
  }

  /** Creates a bot of a strength, null for one by chance. */
  public ShooterBrain(Strength strength) {
    super("shooter", strength);
  }

  @Override
  void play(Senses s, Strength strength, Input out) {
    if (level != s.view().level()) {
      level = s.view().level();
      footholds = new Footholds(s.view());
    }
    if (changesMind(s, 25)) {
      float error = strength.of(0.3f, 0.13f, 0.03f); // rad
      side = s.random().nextInt(2) == 0 ? 1 : -1;
      miss = s.random().between(-error, error);
      holdsFire = s.random().nextFloat() > strength.of(0.35f, 0.65f, 1);
    }
    Drawn enemy = enemy(s);
    if (enemy != null) {
      shoot(s, strength, enemy, out);
    }
    if (footholds.count() > 0) {
      go(s, goal(s, strength, enemy), out);
    }
    lastVelocityY = s.own().velocityY();
  }

  /** Returns the nearest enemy, or null. */
  private static Drawn enemy(Senses s) {
    Drawn best = null;
    for (int i = 0; i < s.view().entityCount(); i++) {
      Drawn other = s.view().entity(i);
      boolean isPlayer = other.archetype().name().startsWith("player.");
      if (isPlayer && other.id() != s.own().id()) {
        best = best == null || s.distance(other) < s.distance(best) ? other : best;
      }
    }
    return best;
  }

  private void shoot(Senses s, Strength strength, Drawn enemy, Input out) {
    Weapon weapon = s.player().get(ShooterFields.WEAPON);
    float late = RocketBrain.lateness(s.view(), enemy);
    float dx = enemy.x() - s.own().x();
    float dy = enemy.y() - s.own().y();
    float distance = (float) Math.hypot(dx, dy);
    if (strength != Strength.WEAK) {
      float lead = late + distance / weapon.speed;
      dx += lead * enemy.velocityX();
      dy +=
          weapon.blasts()
              ? -0.5f
              : 0.4f * lead * enemy.velocityY(); // it will fall, and at its feet
    }
    if (weapon.blasts()) {
      float flight = distance / weapon.speed;
      dy -= ROCKET_GRAVITY * level.gravityY() * flight * flight / 2;
    }
    boolean inSight = !s.view().isSolid(s.own().x(), s.own().y(), dx, dy);
    seenFor = inSight ? seenFor + 1 : 0;
    boolean inReach = distance < 0.9f * weapon.speed * weapon.flight;
    boolean safe = !weapon.blasts() || distance > Weapon.BLAST_RADIUS;
    out.aim((float) Math.atan2(dy, dx) + miss);
    out.hold(Input.ACTION, !holdsFire && seenFor > strength.of(40, 20, 5) && inReach && safe);
  }

  /** Returns the foothold to go to. */
  private int goal(Senses s, Strength strength, Drawn enemy) {
    Drawn own = s.own();
    if (s.view().match().get(ShooterFields.SUDDEN)) {
      return footholds.highest(own.x() + 2 * side);
    }
    if (strength != Strength.WEAK) {
      boolean isHurt = s.player().get(ShooterFields.DAMAGE) > HURT;
      Drawn wanted = isHurt ? s.nearest("medkit") : null;
      if (!isHurt && s.player().get(ShooterFields.AMMO) == 0) {
        wanted = nearestWeapon(s);
      }
      if (wanted != null) {
        return footholds.nearest(wanted.x(), wanted.y() - 0.4f);
      }
      if (isHurt && enemy != null && s.distance(enemy) < RETREAT) {
        return furthest(enemy);
      }
    }
    if (enemy == null) {
      return footholds.nearest(8 * side, own.y());
    }
    float distance = strength == Strength.WEAK ? 3 : 6;
    return footholds.nearest(enemy.x() + side * distance, enemy.y() - FEET);
  }

  private static Drawn nearestWeapon(Senses s) {
    Drawn best = null;
    for (String name : WEAPONS) {
      Drawn box = s.nearest(name);
      if (box != null && (best == null || s.distance(box) < s.distance(best))) {
        best = box;
      }
    }
    return best;
  }

  /** Returns the place to begin at that is furthest from an enemy. */
  private int furthest(Drawn enemy) {
    Level.Spawn best = null;
    double most = -1;
    for (Level.Spawn spot : level.spawns("player")) {
      double far = Math.hypot(spot.x() - enemy.x(), spot.y() - enemy.y());
      if (far > most) {
        most = far;
        best = spot;
      }
    }
    return best == null ? 0 : footholds.nearest(best.x(), best.y() - FEET);
  }

  /** Walks or jumps on towards a foothold, and back to the nearest one out of the air. */
  private void go(Senses s, int goal, Input out) {
    Drawn own = s.own();
    float feet = own.y() - FEET;
    int here = footholds.nearest(own.x(), feet);
    steady = Math.abs(own.velocityY() - lastVelocityY) < 0.2f ? steady + 1 : 0;
    boolean stands = steady > 2 && s.tick() - jumpedAt > JUMP_TICKS; // the picture may lag
    float above = feet - footholds.y(here); // of ground, or on a crate that stands on it
    boolean isThere =
        Math.abs(footholds.x(here) - own.x()) < 0.9f && above > -0.5f && above < ON_CRATES;
    if (stands && isThere) {
      next = footholds.next(here, goal);
    } else if (stands || next < 0 || next >= footholds.count() || isLost(feet)) {
      next = here; // on a moving stage, or thrown off
    }
    float dx = footholds.x(next) - own.x();
    float rise = footholds.y(next) - feet;
    out.move(Math.abs(dx) < 0.2f ? 0 : Math.max(-1, Math.min(1, 1.5f * dx)), 0);
    boolean walks = isThere && Math.abs(dx) < 1.8f && Math.abs(rise) < 0.7f;
    if (isStuck(s)) {
      out.move(side, 0);
      walks = false;
    }
    boolean below = rise < -0.7f && Math.abs(dx) < 1.6f;
    boolean falls = own.velocityY() < 1 && rise > (Math.abs(dx) > 1.5f ? -1 : 0.2f); // short
    boolean jump = stands ? !walks && !below : falls;
    int since = Math.abs(s.tick() - jumpedAt);
    if (jump && since > JUMP_TICKS && !jumps) { // a jump is a press, and the second another
      jumpedAt = s.tick();
      since = 0;
    }
    jumps = since < JUMP_TICKS || (jumps && own.velocityY() > 0 && rise > -0.3f);
    out.hold(Input.JUMP, jumps);
    out.hold(Input.DOWN, below && stands);
  }

  /** Returns whether it has hardly moved for a while, so that it should jump away for a moment. */
  private boolean isStuck(Senses s) {
    int since = s.tick() - markTick;
    boolean moved = Math.hypot(s.own().x() - markX, s.own().y() - markY) > 2;
    if (moved || since < 0 || since > PATIENCE_TICKS + DETOUR_TICKS) {
      markX = s.own().x();
      markY = s.own().y();
      markTick = s.tick();
      return false;
    }
    return since > PATIENCE_TICKS;
  }

  /** Returns whether it falls below where it wanted to go. */
  private boolean isLost(float feet) {
    return feet < footholds.y(next) - 5;
  }
}

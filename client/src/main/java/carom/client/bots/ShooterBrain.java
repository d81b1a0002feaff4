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

  private final Hopper hopper = new Hopper(4.3f, 7, true);
  private Footholds footholds;
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
    footholds = hopper.footholds(s);
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
      hopper.go(s, goal(s, strength, enemy), side, out);
    }
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
      dy -= ROCKET_GRAVITY * s.view().level().gravityY() * flight * flight / 2;
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
        return furthest(s, enemy);
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
  private int furthest(Senses s, Drawn enemy) {
    Level.Spawn best = null;
    double most = -1;
    for (Level.Spawn spot : s.view().level().spawns("player")) {
      double far = Math.hypot(spot.x() - enemy.x(), spot.y() - enemy.y());
      if (far > most) {
        most = far;
        best = spot;
      }
    }
    return best == null ? 0 : footholds.nearest(best.x(), best.y() - FEET);
  }
}

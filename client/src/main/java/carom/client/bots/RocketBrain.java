package carom.client.bots;

import carom.client.view.ClientView;
import carom.client.view.ClientView.Drawn;
import carom.game.rockets.RocketFields;
import carom.game.rockets.RocketGame;
import carom.game.rockets.Weapon;
import carom.sim.entity.Input;
import java.util.Set;

/**
 * Plays {@code rockets}: shoots at where the nearest enemy in sight will be when the shot is there,
 * sets off what flies past one, circles at a distance, fetches what lies about, steps aside of
 * shots or holds up its shield, and breaks rocks while nobody is in sight.
 */
public final class RocketBrain extends GradedBrain {
  /** Distance that it keeps from the enemy, metres. */
  private static final float DISTANCE = 8;

  /** Most time of flight that it leads a shot by, seconds. */
  private static final float MOST_LEAD = 1.5f;

  /** Distance at which a rocket that flies past hurts enough to be set off, metres. */
  private static final float NEAR_MISS = 1.7f;

  private static final float DODGE_METRES = 2.2f;

  /** Distance at which a shot that comes is as good as here, metres. */
  private static final float SHIELD_METRES = 3;

  /** Distance to which it goes for what lies about, metres. */
  private static final float FETCH_METRES = 16;

  private static final float ROCK_METRES = 14;
  private static final int HURT = 60;

  /** Distance of an enemy that may run into a mine, metres. */
  private static final float MINE_METRES = 10;

  private static final Set<String> SHOTS = Set.of("rocket", "bolt", "torpedo", "mine");

  private static final Set<String> FLYING = Set.of("rocket", "torpedo");

  /** Mean speed of a torpedo on its way, m/s. */
  private static final float TORPEDO_SPEED = 15;

  private final Steering steering = new Steering();
  private int side = 1;
  private float miss;
  private boolean holdsFire;
  private int seenFor;

  /** Creates a bot of a strength that its random numbers choose, for the service loader. */
  public RocketBrain() {
    this(null);
  }

  /** Creates a bot of a strength, null for one by chance. */
  public RocketBrain(Strength strength) {
    super("rockets", strength);
  }

  @Override
  void play(Senses s, Strength strength, Input out) {
    if (changesMind(s, 40)) {
      float error = strength.of(0.35f, 0.14f, 0.03f);
      side = s.random().nextInt(2) == 0 ? 1 : -1;
      miss = s.random().between(-error, error);
      holdsFire = s.random().nextFloat() > strength.of(0.5f, 0.75f, 1);
    }
    out.hold(Input.SECOND, strength != Strength.WEAK && passesAnEnemy(s));
    Drawn enemy = enemy(s);
    boolean inSight = enemy != null && isInSight(s, enemy.x(), enemy.y());
    seenFor = inSight ? seenFor + 1 : 0;
    Drawn rock = inSight ? null : rock(s);
    if (inSight || rock != null) {
      shoot(s, strength, inSight ? enemy : rock, out);
    }
    Drawn shot = strength == Strength.WEAK ? null : shotThatComes(s, strength.of(0, 0.4f, 0.7f));
    if (shot != null && s.distance(shot) < SHIELD_METRES) {
      out.hold(RocketGame.SHIELD, true);
    }
    Drawn wanted = strength == Strength.WEAK ? null : wanted(s);
    if (shot != null) {
      stepAside(s, shot, out);
    } else if (wanted != null) {
      steering.go(s, wanted.x(), wanted.y(), 0, out);
    } else if (enemy == null) {
      steering.go(s, rock == null ? 0 : rock.x(), rock == null ? 0 : rock.y(), 6, out);
    } else {
      circle(s, enemy, inSight, out);
    }
  }

  /** Returns the nearest enemy in sight, else the nearest one, or null. */
  private static Drawn enemy(Senses s) {
    Drawn best = null;
    float least = Float.MAX_VALUE;
    for (int i = 0; i < s.view().entityCount(); i++) {
      Drawn other = s.view().entity(i);
      if (isEnemy(s, other)) {
        float distance = s.distance(other);
        float cost = isInSight(s, other.x(), other.y()) ? distance : distance + 1_000;
        if (cost < least) {
          least = cost;
          best = other;
        }
      }
    }
    return best;
  }

  private static boolean isEnemy(Senses s, Drawn other) {
    return other.id() != s.own().id() && other.archetype().name().equals("player");
  }

  private static boolean isInSight(Senses s, float x, float y) {
    return !s.isWall(x - s.own().x(), y - s.own().y());
  }

  /** Returns the nearest rock in sight, or null. */
  private static Drawn rock(Senses s) {
    Drawn best = null;
    float least = ROCK_METRES;
    for (int i = 0; i < s.view().entityCount(); i++) {
      Drawn other = s.view().entity(i);
      if (other.archetype().name().startsWith("rock.")
          && s.distance(other) < least
          && isInSight(s, other.x(), other.y())) {
        least = s.distance(other);
        best = other;
      }
    }
    return best;
  }

  /** Returns what it would like to have and is near, or null. */
  private static Drawn wanted(Senses s) {
    Drawn best = null;
    if (s.player().get(RocketFields.HEALTH) < HURT) {
      best = s.nearest("repair");
    } else if (s.player().get(RocketFields.AMMO) == 0) {
      for (String weapon : new String[] {"scatter", "torpedoes", "mines"}) {
        Drawn box = s.nearest(weapon);
        best = box != null && (best == null || s.distance(box) < s.distance(best)) ? box : best;
      }
    }
    return best != null && s.distance(best) < FETCH_METRES ? best : null;
  }

  private void shoot(Senses s, Strength strength, Drawn target, Input out) {
    Weapon weapon = s.player().get(RocketFields.WEAPON);
    float late = strength == Strength.WEAK ? 0 : lateness(s.view(), target);
    float x = target.x() + late * target.velocityX() - s.own().x();
    float y = target.y() + late * target.velocityY() - s.own().y();
    float distance = (float) Math.hypot(x, y);
    if (weapon == Weapon.MINES) { // they go the other way
      boolean follows = distance < MINE_METRES;
      out.aim((float) Math.atan2(-y, -x));
      out.hold(Input.ACTION, follows && !holdsFire);
      return;
    }
    float speed = weapon == Weapon.TORPEDO ? TORPEDO_SPEED : weapon.speed;
    float flight = flightSeconds(x, y, target.velocityX(), target.velocityY(), speed);
    float lead = strength.of(0, 0.8f, 1) * flight;
    float aimX = x + lead * target.velocityX();
    float aimY = y + lead * target.velocityY();
    if (s.isWall(aimX, aimY)) { // the enemy will have stopped at the wall
      aimX = x;
      aimY = y;
    }
    boolean inReach = distance < speed * weapon.flight;
    boolean sees = seenFor > strength.of(35, 15, 3) || !isEnemy(s, target);
    out.aim((float) Math.atan2(aimY, aimX) + miss);
    out.hold(Input.ACTION, inReach && sees && !holdsFire && !s.isWall(aimX, aimY));
  }

  /** Returns how old the picture of a body is, seconds: what isn't predicted is in the past. */
  static float lateness(ClientView view, Drawn drawn) {
    double ticks = Math.max(0, view.tick() - view.renderTick());
    return (float) ((1 - drawn.predicted()) * ticks / view.tickRate());
  }

  /**
   * Returns the time after which a shot meets a body: the t of {@code |p + v t| = speed t}.
   *
   * @param x the body's place, seen from the muzzle, metres
   * @param y the body's place, seen from the muzzle, metres
   * @param vx the body's velocity, m/s
   * @param vy the body's velocity, m/s
   * @param speed of the shot, m/s
   * @return seconds, 0 to {@value #MOST_LEAD}
   */
  static float flightSeconds(float x, float y, float vx, float vy, float speed) {
    float a = speed * speed - vx * vx - vy * vy;
    float half = x * vx + y * vy;
    if (a <= 1) {
      return MOST_LEAD; // as fast as the shot
    }
    double root = Math.sqrt((double) half * half + (double) a * (x * x + y * y));
    return (float) Math.min(MOST_LEAD, (half + root) / a);
  }

  /** Returns whether an own rocket is as near to an enemy as it will come, without a hit. */
  private static boolean passesAnEnemy(Senses s) {
    for (int i = 0; i < s.view().entityCount(); i++) {
      Drawn rocket = s.view().entity(i);
      if (!FLYING.contains(rocket.archetype().name()) || rocket.ownerId() != s.view().playerId()) {
        continue;
      }
      for (int k = 0; k < s.view().entityCount(); k++) {
        Drawn other = s.view().entity(k);
        float dx = other.x() - rocket.x();
        float dy = other.y() - rocket.y();
        float away =
            dx * (other.velocityX() - rocket.velocityX())
                + dy * (other.velocityY() - rocket.velocityY());
        if (isEnemy(s, other) && away > 0 && dx * dx + dy * dy < NEAR_MISS * NEAR_MISS) {
          return true;
        }
      }
    }
    return false;
  }

  /** Returns the nearest shot of others that comes close within some time, or null. */
  private static Drawn shotThatComes(Senses s, float seconds) {
    Drawn best = null;
    for (int i = 0; i < s.view().entityCount(); i++) {
      Drawn shot = s.view().entity(i);
      if (!SHOTS.contains(shot.archetype().name()) || shot.ownerId() == s.view().playerId()) {
        continue;
      }
      float dx = s.own().x() - shot.x();
      float dy = s.own().y() - shot.y();
      float speed = (float) Math.hypot(shot.velocityX(), shot.velocityY());
      float ahead = (dx * shot.velocityX() + dy * shot.velocityY()) / Math.max(0.1f, speed);
      boolean comes =
          ahead > 0 && ahead < seconds * speed && Math.abs(aside(s, shot)) < DODGE_METRES;
      boolean isMine = speed < 3 && s.distance(shot) < SHIELD_METRES;
      if ((comes || isMine)
          && isInSight(s, shot.x(), shot.y())
          && (best == null || s.distance(shot) < s.distance(best))) {
        best = shot;
      }
    }
    return best;
  }

  /** Returns how far to the left of a shot's way it is, metres. */
  private static float aside(Senses s, Drawn shot) {
    float speed = Math.max(0.1f, (float) Math.hypot(shot.velocityX(), shot.velocityY()));
    float dx = s.own().x() - shot.x();
    float dy = s.own().y() - shot.y();
    return (shot.velocityX() * dy - shot.velocityY() * dx) / speed;
  }

  /** Leaves a shot's way, or a mine's neighbourhood. */
  private void stepAside(Senses s, Drawn shot, Input out) {
    float speed = (float) Math.hypot(shot.velocityX(), shot.velocityY());
    float to = aside(s, shot) >= 0 ? 1 : -1;
    float wayX = -shot.velocityY() * to / speed;
    float wayY = shot.velocityX() * to / speed;
    if (speed < 3) {
      float distance = Math.max(0.01f, s.distance(shot));
      wayX = (s.own().x() - shot.x()) / distance;
      wayY = (s.own().y() - shot.y()) / distance;
    }
    steering.walk(s, wayX, wayY, 1, out);
  }

  /** Circles around an enemy in sight at a distance; comes nearer to one behind a wall. */
  private void circle(Senses s, Drawn enemy, boolean inSight, Input out) {
    float distance = Math.max(0.01f, s.distance(enemy));
    float wayX = (enemy.x() - s.own().x()) / distance;
    float wayY = (enemy.y() - s.own().y()) / distance;
    float nearer = 1;
    float around = 0;
    if (inSight) {
      nearer = Math.max(-1, Math.min(1, (distance - DISTANCE) / 3));
      around = side * (1 - 0.6f * Math.abs(nearer));
    }
    float x = nearer * wayX - around * wayY;
    float y = nearer * wayY + around * wayX;
    float length = Math.max(0.01f, (float) Math.hypot(x, y));
    steering.walk(s, x / length, y / length, 1, out);
  }
}

package carom.client.bots;

import carom.client.view.ClientView;
import carom.client.view.ClientView.Drawn;
import carom.sim.entity.Input;

/**
 * Plays {@code rockets}: shoots at where the nearest enemy in sight will be when the rocket is
 * there, sets off what flies past one, circles at a distance, and steps aside of rockets.
 */
final class RocketBrain implements BotBrain {
  /** Speed of a rocket, m/s, as {@code RocketGame.ROCKET_SPEED}. */
  static final float ROCKET_SPEED = 20;

  /** Distance that it keeps from the enemy, metres. */
  private static final float DISTANCE = 8;

  /** Most time of flight that it leads a shot by, seconds. */
  private static final float MOST_LEAD = 1.5f;

  /** Distance at which a rocket that flies past hurts enough to be set off, metres. */
  private static final float NEAR_MISS = 1.7f;

  /** Time ahead in which a rocket that comes makes it step aside, seconds. */
  private static final float DODGE_SECONDS = 0.7f;

  private static final float DODGE_METRES = 2.2f;
  private static final int MOST_CIRCLE_TICKS = 200;

  private final Steering steering = new Steering();
  private int side = 1;
  private int turnAt;

  @Override
  public String game() {
    return "rockets";
  }

  @Override
  public void decide(Senses s, Input out) {
    if (s.tick() >= turnAt || turnAt - s.tick() > MOST_CIRCLE_TICKS) {
      turnAt = s.tick() + 60 + s.random().nextInt(MOST_CIRCLE_TICKS - 60);
      side = s.random().nextInt(2) == 0 ? 1 : -1;
    }
    out.hold(Input.SECOND, passesAnEnemy(s));
    Drawn enemy = enemy(s);
    if (enemy == null) {
      steering.go(s, 0, 0, 2, out);
      return;
    }
    shoot(s, enemy, out);
    if (!dodge(s, out)) {
      circle(s, enemy, out);
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

  private static void shoot(Senses s, Drawn enemy, Input out) {
    float late = lateness(s.view(), enemy);
    float x = enemy.x() + late * enemy.velocityX() - s.own().x();
    float y = enemy.y() + late * enemy.velocityY() - s.own().y();
    float flight = flightSeconds(x, y, enemy.velocityX(), enemy.velocityY());
    float aimX = x + flight * enemy.velocityX();
    float aimY = y + flight * enemy.velocityY();
    if (s.isWall(aimX, aimY)) { // the enemy will have stopped at the wall
      aimX = x;
      aimY = y;
    }
    out.aim((float) Math.atan2(aimY, aimX));
    out.hold(Input.ACTION, !s.isWall(aimX, aimY));
  }

  /** Returns how old the picture of a body is, seconds: what isn't predicted is in the past. */
  static float lateness(ClientView view, Drawn drawn) {
    double ticks = Math.max(0, view.tick() - view.renderTick());
    return (float) ((1 - drawn.predicted()) * ticks / view.tickRate());
  }

  /**
   * Returns the time after which a rocket meets a body: the t of {@code |p + v t| = speed t}.
   *
   * @param x the body's place, seen from the muzzle, metres
   * @param y the body's place, seen from the muzzle, metres
   * @param vx the body's velocity, m/s
   * @param vy the body's velocity, m/s
   * @return seconds, 0 to {@value #MOST_LEAD}
   */
  static float flightSeconds(float x, float y, float vx, float vy) {
    float a = ROCKET_SPEED * ROCKET_SPEED - vx * vx - vy * vy;
    float half = x * vx + y * vy;
    if (a <= 1) {
      return MOST_LEAD; // as fast as a rocket
    }
    double root = Math.sqrt((double) half * half + (double) a * (x * x + y * y));
    return (float) Math.min(MOST_LEAD, (half + root) / a);
  }

  /** Returns whether an own rocket is as near to an enemy as it will come, without a hit. */
  private static boolean passesAnEnemy(Senses s) {
    for (int i = 0; i < s.view().entityCount(); i++) {
      Drawn rocket = s.view().entity(i);
      if (!isRocket(rocket) || rocket.ownerId() != s.view().playerId()) {
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

  private static boolean isRocket(Drawn drawn) {
    return drawn.archetype().name().equals("rocket");
  }

  /** Steps aside of a rocket that comes close; returns whether one does. */
  private boolean dodge(Senses s, Input out) {
    for (int i = 0; i < s.view().entityCount(); i++) {
      Drawn rocket = s.view().entity(i);
      if (!isRocket(rocket) || rocket.ownerId() == s.view().playerId()) {
        continue;
      }
      float dx = s.own().x() - rocket.x();
      float dy = s.own().y() - rocket.y();
      float wayX = rocket.velocityX() / ROCKET_SPEED;
      float wayY = rocket.velocityY() / ROCKET_SPEED;
      float ahead = dx * wayX + dy * wayY;
      float aside = wayX * dy - wayY * dx;
      if (ahead > 0
          && ahead < DODGE_SECONDS * ROCKET_SPEED
          && Math.abs(aside) < DODGE_METRES
          && isInSight(s, rocket.x(), rocket.y())) {
        float to = aside >= 0 ? 1 : -1;
        steering.walk(s, -wayY * to, wayX * to, 1, out);
        return true;
      }
    }
    return false;
  }

  /** Circles around an enemy in sight at a distance; comes nearer to one behind a wall. */
  private void circle(Senses s, Drawn enemy, Input out) {
    float distance = Math.max(0.01f, s.distance(enemy));
    float wayX = (enemy.x() - s.own().x()) / distance;
    float wayY = (enemy.y() - s.own().y()) / distance;
    float nearer = 1;
    float around = 0;
    if (isInSight(s, enemy.x(), enemy.y())) {
      nearer = Math.max(-1, Math.min(1, (distance - DISTANCE) / 3));
      around = side * (1 - 0.6f * Math.abs(nearer));
    }
    float x = nearer * wayX - around * wayY;
    float y = nearer * wayY + around * wayX;
    float length = Math.max(0.01f, (float) Math.hypot(x, y));
    steering.walk(s, x / length, y / length, 1, out);
  }
}

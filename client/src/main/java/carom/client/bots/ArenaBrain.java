package carom.client.bots;

import carom.client.view.ClientView.Drawn;
import carom.game.arena.ArenaGame;
import carom.sim.entity.Input;
import carom.sim.level.Appearance.Look;
import carom.sim.level.Level;
import java.util.List;

/**
 * Plays the arena: the nearest two of a side push a ball towards the other side's goal, one stands
 * in front of the own goal, and the others go after a rival each, but not into corners. It pushes a
 * ball only along ways that are free, and from where it can stand, so that a ball in a corner is
 * brought out along the wall. All but the weak boost on long ways and bend balls towards the goal;
 * the strong see to balls near their own goal first.
 */
final class ArenaBrain extends GradedBrain {
  /** Most bots of a side that go for the same ball. */
  private static final int CHASERS = 2;

  /** Directions in which a push is considered. */
  private static final int DIRECTIONS = 16;

  /** Distance from the ball's centre to where a push begins, metres. */
  private static final float BEHIND = 1.3f;

  /** Space that a bot needs behind the ball, and the ball in front of it, metres. */
  private static final float ROOM_BEHIND = 1.7f;

  private static final float ROOM_AHEAD = 3;

  /** Distance from the own goal at which the keeper stands, metres. */
  private static final float KEEP = 3.5f;

  /** Distance from two walls within which a disc counts as in a corner, metres. */
  private static final float CORNER = 4;

  /** Distance at which a bot without a rival is near enough to where it waits, metres. */
  private static final float OPEN = 3;

  private static final float JOLT_RANGE = 10;
  private static final float DASH_RANGE = 3;

  /** Distance to the ball beyond which a bot boosts, and below which it spins, metres. */
  private static final float BOOST_RANGE = 4;

  private static final float SPIN_RANGE = 2.2f;

  private final Steering steering = new Steering();
  private boolean dawdles;
  private boolean jolted;
  private boolean dashed;
  private float pushX;
  private float pushY;

  /** Creates a bot of a strength, null for one by chance. */
  ArenaBrain(Strength strength) {
    super("arena", strength);
  }

  @Override
  void play(Senses s, Strength strength, Input out) {
    if (changesMind(s, 30)) {
      dawdles = s.random().nextFloat() < strength.of(0.5f, 0.2f, 0);
    }
    Level.Zone theirs = goal(s, false);
    Level.Zone ours = goal(s, true);
    Drawn ball = ballToChase(s, strength == Strength.STRONG ? ours : null);
    if (ball != null && theirs != null) {
      push(s, ball, theirs, out);
      boost(s, ball, strength, out);
      bend(s, ball, theirs, strength, out);
    } else if (ours != null && isKeeper(s, ours)) {
      keep(s, ours, out);
    } else {
      hunt(s, out);
    }
    if (dawdles || strength == Strength.WEAK) { // the weak neither dash nor jolt
      out.hold(Input.SECOND, false);
      out.hold(Input.ACTION, false);
    }
    float pace = dawdles ? 0.4f : strength.of(0.8f, 0.9f, 1);
    out.move(pace * out.moveX(), pace * out.moveY());
    jolted = out.held(Input.SECOND);
    dashed = out.held(Input.ACTION);
  }

  /** Returns the own goal or that of another side, or null. A disc's tag is its side. */
  private static Level.Zone goal(Senses s, boolean own) {
    List<Level.Zone> zones = s.view().level().zones();
    for (int i = 0; i < zones.size(); i++) {
      Level.Zone zone = zones.get(i);
      if (zone.name().equals("goal") && (zone.team() == s.own().archetype().tag()) == own) {
        return zone;
      }
    }
    return null;
  }

  private static float middleX(Level.Zone zone) {
    return (zone.minX() + zone.maxX()) / 2;
  }

  private static float middleY(Level.Zone zone) {
    return (zone.minY() + zone.maxY()) / 2;
  }

  /**
   * Returns the nearest ball with fewer than {@link #CHASERS} closer bots of the side, or null. In
   * a corner one is enough: two would be in each other's way.
   *
   * @param guarded a goal to which the ball should be near, too, or null
   */
  private static Drawn ballToChase(Senses s, Level.Zone guarded) {
    Drawn best = null;
    double least = Double.MAX_VALUE;
    for (int i = 0; i < s.view().entityCount(); i++) {
      Drawn ball = s.view().entity(i);
      float distance = s.distance(ball);
      double value =
          guarded == null
              ? distance
              : distance + Math.hypot(ball.x() - middleX(guarded), ball.y() - middleY(guarded)) / 2;
      if (ball.archetype().appearance().look() == Look.BALL
          && value < least
          && closerMates(s, ball.x(), ball.y(), distance) < (isInCorner(s, ball) ? 1 : CHASERS)) {
        least = value;
        best = ball;
      }
    }
    return best;
  }

  /** Returns how many bots of the side are closer to a place than a distance. */
  private static int closerMates(Senses s, float x, float y, float distance) {
    int count = 0;
    for (int i = 0; i < s.view().entityCount(); i++) {
      Drawn mate = s.view().entity(i);
      if (mate.id() != s.own().id()
          && isDisc(mate)
          && mate.archetype().tag() == s.own().archetype().tag()
          && Math.hypot(mate.x() - x, mate.y() - y) < distance) {
        count++;
      }
    }
    return count;
  }

  private static boolean isDisc(Drawn drawn) {
    return drawn.archetype().appearance().look() == Look.PLAYER;
  }

  private void push(Senses s, Drawn ball, Level.Zone goal, Input out) {
    chooseWay(s, ball, middleX(goal) - ball.x(), middleY(goal) - ball.y());
    float fromX = s.own().x() - ball.x();
    float fromY = s.own().y() - ball.y();
    float along = fromX * pushX + fromY * pushY;
    float across = fromY * pushX - fromX * pushY;
    boolean isBehind = along < -0.3f && Math.abs(across) < -0.6f * along;
    if (isBehind) {
      steering.go(s, ball.x() + 0.5f * pushX, ball.y() + 0.5f * pushY, 0, out);
    } else {
      // Round the ball, on the side where the bot is already.
      float side = along < 0 ? 0 : across >= 0 ? 1.2f : -1.2f;
      float x = ball.x() - BEHIND * pushX - side * pushY;
      float y = ball.y() - BEHIND * pushY + side * pushX;
      steering.go(s, x, y, 0, out);
    }
    float distance = s.distance(ball);
    out.aim(s.direction(ball));
    out.hold(Input.ACTION, isBehind && distance < DASH_RANGE && !dashed);
    out.hold(
        Input.SECOND, isBehind && distance < JOLT_RANGE && !jolted && !s.isWall(-fromX, -fromY));
  }

  private void boost(Senses s, Drawn ball, Strength strength, Input out) {
    out.hold(
        ArenaGame.BOOSTS, strength != Strength.WEAK && !dawdles && s.distance(ball) > BOOST_RANGE);
  }

  /** Spins so that the ball curves towards the goal, where it would fly past it. */
  private static void bend(Senses s, Drawn ball, Level.Zone goal, Strength strength, Input out) {
    float shotX = ball.x() - s.own().x();
    float shotY = ball.y() - s.own().y();
    float toX = middleX(goal) - ball.x();
    float toY = middleY(goal) - ball.y();
    float side = shotX * toY - shotY * toX;
    float length = (float) (Math.hypot(shotX, shotY) * Math.hypot(toX, toY));
    boolean spins =
        strength != Strength.WEAK
            && s.distance(ball) < SPIN_RANGE
            && shotX * toX + shotY * toY > 0
            && Math.abs(side) > strength.of(1, 0.3f, 0.12f) * length; // sine of the miss
    out.hold(ArenaGame.SPINS_LEFT, spins && side > 0);
    out.hold(ArenaGame.SPINS_RIGHT, spins && side < 0);
  }

  /**
   * Chooses the direction of a push: as near to the wanted one as possible, with room for the bot
   * behind the ball and for the ball in front of it.
   */
  private void chooseWay(Senses s, Drawn ball, float toX, float toY) {
    double length = Math.max(0.01, Math.hypot(toX, toY));
    double wanted = Math.atan2(toY, toX);
    double best = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < DIRECTIONS; i++) {
      double angle = wanted + 2 * Math.PI * i / DIRECTIONS;
      float x = (float) Math.cos(angle);
      float y = (float) Math.sin(angle);
      double value = (x * toX + y * toY) / length;
      float ahead = (float) Math.min(ROOM_AHEAD, length);
      value -= isWall(s, ball, -ROOM_BEHIND * x, -ROOM_BEHIND * y) ? 3 : 0;
      value -= isWall(s, ball, ahead * x, ahead * y) ? 1.5 : 0;
      if (value > best) {
        best = value;
        pushX = x;
        pushY = y;
      }
    }
  }

  private static boolean isWall(Senses s, Drawn from, float dx, float dy) {
    return s.view().isWall(from.x(), from.y(), dx, dy);
  }

  private static boolean isKeeper(Senses s, Level.Zone ours) {
    float x = middleX(ours);
    float y = middleY(ours);
    return closerMates(s, x, y, (float) Math.hypot(s.own().x() - x, s.own().y() - y)) == 0;
  }

  /** Stands between the own goal and the ball that is nearest to it. */
  private void keep(Senses s, Level.Zone ours, Input out) {
    float x = middleX(ours);
    float y = middleY(ours);
    Drawn threat = nearestTo(s, x, y, Look.BALL);
    float dx = threat == null ? -x : threat.x() - x;
    float dy = threat == null ? -y : threat.y() - y;
    float scale = KEEP / Math.max(KEEP, (float) Math.hypot(dx, dy));
    steering.go(s, x + scale * dx, y + scale * dy, 1, out);
    if (threat != null) {
      out.aim(s.direction(threat));
      out.hold(Input.SECOND, s.distance(threat) < JOLT_RANGE && !jolted);
    }
  }

  /**
   * Goes after the nearest rival that no mate is closer to and that isn't in a corner, and rams it.
   * Without one it waits in the open.
   */
  private void hunt(Senses s, Input out) {
    Drawn rival = null;
    float least = Float.MAX_VALUE;
    for (int i = 0; i < s.view().entityCount(); i++) {
      Drawn other = s.view().entity(i);
      boolean isRival = isDisc(other) && other.archetype().tag() != s.own().archetype().tag();
      float distance = s.distance(other);
      if (isRival
          && distance < least
          && !isInCorner(s, other)
          && closerMates(s, other.x(), other.y(), distance) == 0) {
        least = distance;
        rival = other;
      }
    }
    if (rival == null) {
      float x = s.own().x() / 2; // towards the middle, each from its own side
      steering.go(s, x, s.own().y() / 2, OPEN, out);
      return;
    }
    steering.go(s, rival.x(), rival.y(), 0, out);
    out.aim(s.direction(rival));
    out.hold(Input.ACTION, least < DASH_RANGE && !dashed);
  }

  private static boolean isInCorner(Senses s, Drawn other) {
    boolean besideX = isWall(s, other, CORNER, 0) || isWall(s, other, -CORNER, 0);
    return besideX && (isWall(s, other, 0, CORNER) || isWall(s, other, 0, -CORNER));
  }

  private static Drawn nearestTo(Senses s, float x, float y, Look look) {
    Drawn best = null;
    double least = Double.MAX_VALUE;
    for (int i = 0; i < s.view().entityCount(); i++) {
      Drawn drawn = s.view().entity(i);
      double distance = Math.hypot(drawn.x() - x, drawn.y() - y);
      if (drawn.archetype().appearance().look() == look && distance < least) {
        least = distance;
        best = drawn;
      }
    }
    return best;
  }
}

package carom.client.bots;

import carom.client.InputSource;
import carom.client.view.ClientView;
import carom.game.GameJars;
import carom.physics.math.SimRandom;
import carom.sim.entity.Input;
import carom.sim.level.Appearance.Look;
import carom.sim.level.Level;
import java.util.List;
import java.util.Set;

/**
 * A bot that plays from what is on the screen, like a distracted child.
 *
 * <p>If the game brings a {@link BotBrain}, that one plays. Otherwise, in a level without gravity
 * the bot pushes a ball towards the other side's goal, or waits in front of its own. With gravity
 * it runs, jumps and collects coins. It decides several times a second, each bot at its own ticks,
 * and holds the same keys in between. In games that aren't Carom's own it also tries all keys.
 *
 * <p>A {@linkplain #skilled skilled} bot plays arena and platformer better. Tests and figures keep
 * to the others, so that what they measure stays comparable.
 */
public final class Bot implements InputSource {
  private static final int THINK_TICKS = 7;
  private static final int LONGEST_MOOD_TICKS = 160;

  /** Most bots of a side that chase the same ball; more would stand in each other's way. */
  private static final int CHASERS = 3;

  /** Games whose rules this bot knows. */
  private static final Set<String> KNOWN = Set.of("arena", "platformer");

  /** Every button that {@link Input} has. */
  private static final int[] BUTTONS = {
    Input.JUMP, Input.ACTION, Input.SECOND, Input.UP, Input.DOWN
  };

  /** A bot that tries all keys holds each one down in one of so many decisions. */
  private static final int PRESSED_ONE_IN = 6;

  /** Distance between bots that wait, metres. */
  private static final float SPREAD_METRES = 5;

  private final SimRandom random;

  /** Chooses the keys to try, apart from {@link #random}: what a bot does otherwise stays so. */
  private final SimRandom fingers;

  private final boolean roams;
  private final boolean skilled;
  private final Strength strength; // or null
  private final Senses senses;
  private BotBrain brain;

  /** True if the brain is the caller's, not the game's. */
  private final boolean isGiven;

  /** The jars that the brain was looked for in. */
  private ClassLoader jars;

  /** Brain of a skilled bot in Carom's own games; asked as seldom as the bot decides. */
  private BotBrain skill;

  private String brainGame;
  private final Input held = new Input();
  private int thinkAt;
  private int changeMindAt;
  private float wanderX;
  private float wanderY;
  private boolean bold;
  private float lastX;
  private int stuck;

  /**
   * Creates a bot.
   *
   * @param seed equal seeds that see equal pictures play the same
   */
  public Bot(long seed) {
    this(seed, false, false, null, null);
  }

  /**
   * Creates a bot.
   *
   * @param seed equal seeds that see equal pictures play the same
   * @param roams whether it walks about all over the level instead of playing: a crowd that plays
   *     flocks around few balls
   */
  public Bot(long seed, boolean roams) {
    this(seed, roams, false, null, null);
  }

  private Bot(long seed, boolean roams, boolean skilled, Strength strength, BotBrain given) {
    this.roams = roams;
    isGiven = given != null;
    brain = given;
    brainGame = given == null ? "" : given.game();
    this.skilled = skilled;
    this.strength = strength;
    random = new SimRandom(seed * 0x9e3779b97f4a7c15L + 1);
    fingers = new SimRandom(seed * 0xd1342543de82ef95L + 1);
    senses = new Senses(fingers);
    thinkAt = random.nextInt(THINK_TICKS);
  }

  /**
   * Creates a bot that a brain plays.
   *
   * @param seed of the brain's random numbers
   * @param brain this bot's alone
   */
  public Bot(long seed, BotBrain brain) {
    this(seed, false, false, null, brain);
  }

  /**
   * Returns a bot that plays as well as it can: company for people.
   *
   * @param seed equal seeds that see equal pictures play the same
   */
  public static Bot skilled(long seed) {
    return skilled(seed, null);
  }

  /**
   * Returns a bot that plays as well as a strength says, where its brain knows strengths.
   *
   * @param seed equal seeds that see equal pictures play the same
   * @param strength null for one by chance
   */
  public static Bot skilled(long seed, Strength strength) {
    return new Bot(seed, false, true, strength, null);
  }

  @Override
  public void sample(ClientView view, int tick, Input out) {
    if (!roams && !view.game().equals(brainGame)) {
      brainGame = view.game();
      brain = find();
    } else if (!roams && !isGiven && jars != GameJars.loader()) {
      BotBrain fresh = find();
      brain = fresh == null ? brain : fresh; // one that can't be loaded is told, and the old stays
    }
    if (brain != null) {
      if (senses.look(view, tick)) {
        brain.decide(senses, out);
      }
      return;
    }
    if (isDue(thinkAt, tick, THINK_TICKS)) {
      thinkAt = tick + THINK_TICKS;
      held.clear();
      if (isDue(changeMindAt, tick, LONGEST_MOOD_TICKS)) {
        changeMindAt = tick + 40 + random.nextInt(LONGEST_MOOD_TICKS - 40);
        wanderX = 2 * random.nextFloat() - 1;
        wanderY = 2 * random.nextFloat() - 1;
        bold = random.nextInt(3) > 0;
      }
      if (roams) {
        roam();
      } else if (skill != null) {
        if (senses.look(view, tick)) {
          skill.decide(senses, held);
        }
      } else {
        play(view);
      }
    }
    out.set(held);
  }

  /** Returns the brain for the present game, or null. */
  private BotBrain find() {
    jars = GameJars.loader();
    BotBrain found = graded(BotBrains.create(brainGame));
    skill = skilled ? graded(BotBrains.shipped(brainGame)) : null;
    // A jump is a matter of ticks.
    return found == null && skill instanceof PlatformerBrain ? skill : found;
  }

  private BotBrain graded(BotBrain of) {
    if (of != null && strength != null) {
      of.strength(strength);
    }
    return of;
  }

  /** Returns whether a moment has come, or is of another match, whose ticks ran further. */
  private static boolean isDue(int at, int tick, int longestWait) {
    return tick >= at || at - tick > longestWait;
  }

  private void play(ClientView view) {
    ClientView.Drawn own = view.own(); // has the whole picture made: most of what a bot costs
    if (own == null || view.level() == null) {
      return;
    }
    if (view.level().gravityY() == 0) {
      pushBalls(view, own);
    } else {
      runAndJump(view, own);
    }
    if (!KNOWN.contains(view.game())) {
      tryKeys(view.level().gravityY() != 0);
    }
  }

  /** Holds some of the keys down, and with gravity also the stick up or down. */
  private void tryKeys(boolean sideView) {
    for (int button : BUTTONS) {
      if (fingers.nextInt(PRESSED_ONE_IN) == 0) {
        held.hold(button, true);
      }
    }
    if (sideView) {
      held.move(held.moveX(), wanderY);
      held.aim(fingers.between(-3, 3));
    }
  }

  /** Walks at random, which visits all places equally often; walls turn the bot back. */
  private void roam() {
    float length = Math.max(0.01f, length(wanderX, wanderY));
    held.move(wanderX / length, wanderY / length);
    tryKeys(false);
  }

  private void pushBalls(ClientView view, ClientView.Drawn own) {
    ClientView.Drawn ball = ballToChase(view, own);
    if (ball == null) {
      waitAtHome(view, own);
      return;
    }
    float goalX = 0;
    float goalY = 0;
    Level.Zone goal = goal(view, own, false);
    if (goal != null) {
      goalX = (goal.minX() + goal.maxX()) / 2;
      goalY = (goal.minY() + goal.maxY()) / 2;
    }
    float toGoalX = goalX - ball.x();
    float toGoalY = goalY - ball.y();
    float way = Math.max(0.01f, length(toGoalX, toGoalY));
    toGoalX /= way;
    toGoalY /= way;
    float fromBallX = own.x() - ball.x();
    float fromBallY = own.y() - ball.y();
    float along = fromBallX * toGoalX + fromBallY * toGoalY;
    if (along < -0.3f) {
      steer(own, ball.x() + toGoalX * 0.5f, ball.y() + toGoalY * 0.5f, true);
    } else {
      // On the wrong side: around the ball, on the side where we are already.
      float side = fromBallX * -toGoalY + fromBallY * toGoalX >= 0 ? 1.4f : -1.4f;
      steer(
          own,
          ball.x() - toGoalX * 1.2f - toGoalY * side,
          ball.y() - toGoalY * 1.2f + toGoalX * side,
          false);
    }
  }

  /** Returns the nearest ball with fewer than {@link #CHASERS} closer bots of the side, or null. */
  private static ClientView.Drawn ballToChase(ClientView view, ClientView.Drawn own) {
    ClientView.Drawn best = null;
    float bestDistance = Float.MAX_VALUE;
    for (int i = 0; i < view.entityCount(); i++) {
      ClientView.Drawn ball = view.entity(i);
      float distance = length(ball.x() - own.x(), ball.y() - own.y());
      if (ball.archetype().appearance().look() == Look.BALL
          && distance < bestDistance
          && closerMates(view, own, ball, distance) < CHASERS) {
        bestDistance = distance;
        best = ball;
      }
    }
    return best;
  }

  /** Returns how many bots of the side are closer to a ball, up to {@link #CHASERS}. */
  private static int closerMates(
      ClientView view, ClientView.Drawn own, ClientView.Drawn ball, float distance) {
    int count = 0;
    for (int i = 0; i < view.entityCount() && count < CHASERS; i++) {
      ClientView.Drawn mate = view.entity(i);
      if (mate != own
          && mate.archetype() == own.archetype()
          && length(ball.x() - mate.x(), ball.y() - mate.y()) < distance) {
        count++;
      }
    }
    return count;
  }

  /** Waits between the nearest ball and the own goal, or goes to a rival if there are none. */
  private void waitAtHome(ClientView view, ClientView.Drawn own) {
    ClientView.Drawn ball = nearest(view, own, Look.BALL);
    Level.Zone home = goal(view, own, true);
    if (ball == null || home == null) {
      ClientView.Drawn rival = nearest(view, own, Look.PLAYER);
      if (rival == null) {
        held.move(wanderX, wanderY);
      } else {
        steer(own, rival.x(), rival.y(), false);
      }
      return;
    }
    float homeX = (home.minX() + home.maxX()) / 2;
    float homeY = (home.minY() + home.maxY()) / 2;
    steer(
        own,
        (ball.x() + homeX) / 2 + SPREAD_METRES * wanderX,
        (ball.y() + homeY) / 2 + SPREAD_METRES * wanderY,
        false);
  }

  /** Returns the own goal or that of another side, or null. A disc's tag is its side. */
  private static Level.Zone goal(ClientView view, ClientView.Drawn own, boolean home) {
    List<Level.Zone> zones = view.level().zones();
    for (int i = 0; i < zones.size(); i++) {
      Level.Zone zone = zones.get(i);
      if (zone.name().equals("goal") && (zone.team() == own.archetype().tag()) == home) {
        return zone;
      }
    }
    return null;
  }

  private void steer(ClientView.Drawn own, float x, float y, boolean charge) {
    float dx = x - own.x() + 0.3f * wanderX;
    float dy = y - own.y() + 0.3f * wanderY;
    float distance = Math.max(0.01f, length(dx, dy));
    held.move(dx / distance, dy / distance);
    held.aim((float) Math.atan2(dy, dx));
    held.hold(Input.ACTION, charge && distance < 3 && random.nextInt(5) == 0);
    held.hold(Input.SECOND, charge && random.nextInt(8) == 0);
  }

  private void runAndJump(ClientView view, ClientView.Drawn own) {
    ClientView.Drawn coin = bold ? nearest(view, own, Look.COIN) : null;
    float direction = coin != null ? coin.x() - own.x() : wanderX;
    stuck = Math.abs(own.x() - lastX) < 0.05f ? stuck + 1 : 0;
    lastX = own.x();
    if (stuck > 10) {
      wanderX = -wanderX;
      bold = false;
      stuck = 0;
    }
    held.move(Math.signum(direction), 0);
    boolean above = coin != null && coin.y() > own.y() + 0.5f;
    held.hold(Input.JUMP, random.nextInt(above || stuck > 2 ? 2 : 8) == 0);
    held.hold(Input.DOWN, coin != null && coin.y() < own.y() - 2 && random.nextInt(6) == 0);
    held.hold(Input.ACTION, random.nextInt(25) == 0);
  }

  private static ClientView.Drawn nearest(ClientView view, ClientView.Drawn own, Look look) {
    ClientView.Drawn best = null;
    float bestDistance = Float.MAX_VALUE;
    for (int i = 0; i < view.entityCount(); i++) {
      ClientView.Drawn drawn = view.entity(i);
      if (drawn != own && drawn.archetype().appearance().look() == look) {
        float distance = length(drawn.x() - own.x(), drawn.y() - own.y());
        if (distance < bestDistance) {
          bestDistance = distance;
          best = drawn;
        }
      }
    }
    return best;
  }

  private static float length(float x, float y) {
    return (float) Math.sqrt(x * x + y * y);
  }
}

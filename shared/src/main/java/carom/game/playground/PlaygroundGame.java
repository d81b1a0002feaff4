package carom.game.playground;

import static carom.game.playground.PlaygroundFields.BASKETS;
import static carom.game.playground.PlaygroundFields.HELD;
import static carom.game.playground.PlaygroundFields.STAR_SECONDS;
import static carom.game.playground.PlaygroundFields.THINGS;
import static carom.game.playground.PlaygroundFields.TOWER;

import carom.sim.Game;
import carom.sim.Match;
import carom.sim.MatchClock;
import carom.sim.MatchPhase;
import carom.sim.SetUp;
import carom.sim.Simulation;
import carom.sim.entity.Contact;
import carom.sim.entity.Entity;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.field.Field;
import carom.sim.field.Gauge;
import carom.sim.level.Level;
import java.util.List;

/**
 * A sandbox for 16 players with contests. A player flies a robot, whose beam grabs whatever moves,
 * carries it, turns it and throws it. Players make things, at most {@value #MAX_THINGS} each, and
 * join them by welds, hinges, ropes and motors.
 *
 * <p>Alone, a player plays for as long as it likes. With two, a match of three contests of {@value
 * #CONTEST_SECONDS} s each begins: loose things are brought into baskets, a point each; own things
 * are piled up on a site, a point a metre; and a star is kept from the others, a point a second.
 * The player with most points in all wins.
 *
 * <p>{@link Input#ACTION} grabs while it is held, {@link Input#SECOND} throws, {@link Input#UP} and
 * {@link Input#DOWN} turn what is held, {@link Input#JUMP} drives motors; the other bits are the
 * constants of this class. All of it but joints is in {@code input}, so a player sees it at once.
 * Joints, points and the star are the server's.
 *
 * <p>A level needs spawns {@code player}, {@code chute}, where things come out again that went into
 * a basket, and one {@code star}; a sensor {@code basket}, and one zone {@code site}.
 *
 * <pre>
 *   PlaygroundGame       the order of a tick, and who wins
 *     PlaygroundFields   the state that is saved, hashed and sent
 *     Yard               kinds of entities and events, the level's places
 *     Hands              flying, grabbing, throwing, making, driving
 *     Builders           joints that players make
 *     Contests           what counts
 * </pre>
 */
public final class PlaygroundGame implements Game {
  /** Cuts all joints of what is held. */
  public static final int CUT = 1 << 5;

  /** Makes a box; the five bits above a ball, a plank, a wheel, a balloon and a weight. */
  public static final int MAKE = 1 << 6;

  /** Welds what is held to what it touches at the point where it is held. */
  public static final int WELD = 1 << 12;

  /** Hangs what is held on what it touches, by a hinge. */
  public static final int HINGE = 1 << 13;

  /** Shoots a rope along the aim from what is held. */
  public static final int ROPE = 1 << 14;

  /** Joins as {@link #HINGE}, with a motor that {@link Input#JUMP} drives. */
  public static final int MOTOR = 1 << 15;

  /** Most things of a player; the oldest gives way to one too many. */
  public static final int MAX_THINGS = 24;

  /** Length of a contest, seconds. */
  public static final float CONTEST_SECONDS = 60;

  /** Length of a beam that looks for something to grab, metres. */
  public static final float BEAM = 6;

  /** Flying speed, m/s. */
  public static final float SPEED = 11;

  /** Radius of a robot, metres. */
  public static final float RADIUS = 0.5f;

  private static final MatchClock CLOCK =
      MatchClock.playing(3 * CONTEST_SECONDS).warmUp(2).countdown(3);

  private Yard yard;
  private Hands hands;
  private Builders builders;
  private Contests contests;

  /** Creates the game, for the service loader. */
  public PlaygroundGame() {}

  @Override
  public String name() {
    return "playground";
  }

  @Override
  public String defaultLevel() {
    return "sandbox";
  }

  @Override
  public String description() {
    return "grab, throw and build: baskets, towers and a star, most points win";
  }

  @Override
  public List<Field<?>> fields() {
    return PlaygroundFields.all();
  }

  @Override
  public List<Gauge> gauges() {
    return List.of(
        Gauge.number("baskets", BASKETS),
        Gauge.number("tower m", TOWER),
        Gauge.number("star s", STAR_SECONDS),
        Gauge.number("things", THINGS));
  }

  @Override
  public MatchClock clock() {
    return CLOCK;
  }

  @Override
  public void setUp(SetUp s) {
    yard = new Yard(s);
    hands = new Hands(yard);
    builders = new Builders(yard);
    contests = new Contests(yard);
  }

  @Override
  public void join(Match m, Player p) {
    Level.Spawn spot = yard.players.get(p.id() % yard.players.size());
    m.spawn(yard.robot, spot.x(), spot.y(), 0, p);
  }

  @Override
  public void beforeStep(Match m) {
    builders.beforeStep(m);
  }

  @Override
  public void input(Simulation s, Player p, Input in) {
    hands.input(s, p, in);
  }

  /** Lets a robot pass through what it holds. */
  @Override
  public boolean collision(Simulation s, Contact c) {
    return !holds(c.self(), c.other()) && !holds(c.other(), c.self()) && c.holdsOneWay();
  }

  private boolean holds(Entity robot, Entity e) {
    return yard.isRobot(robot) && robot.isOwned() && robot.owner().get(HELD) == e;
  }

  @Override
  public void entered(Match m, Entity sensor, Entity visitor) {
    if (Yard.isBasket(sensor)) {
      contests.entered(m, visitor);
    }
  }

  @Override
  public void afterStep(Match m) {
    contests.afterStep(m);
    if (m.tick() % m.tickRate() == 0) {
      yard.bringBack(m);
    }
  }

  @Override
  public void phase(Match m, MatchPhase now) {
    if (now == MatchPhase.PLAYING) {
      for (Player p : m.players()) { // what was practised is forgotten
        for (int i = p.spawnedCount() - 1; i >= 0; i--) {
          p.spawned(i).despawn();
        }
        p.resetFields();
        m.score(p, 0);
      }
    } else if (now == MatchPhase.OVER) {
      Player best = m.leader();
      CLOCK.decide(m, best, 0);
      m.notice(best == null ? "A draw!" : result(m, best));
    }
  }

  private static String result(Match m, Player best) {
    Player second = null;
    for (Player p : m.players()) {
      second = p != best && (second == null || m.score(p) > m.score(second)) ? p : second;
    }
    String lead =
        second == null
            ? ""
            : ", " + (m.score(best) - m.score(second)) + " ahead of " + m.name(second);
    return m.name(best)
        + " wins with "
        + m.score(best)
        + ": baskets "
        + best.get(BASKETS)
        + ", tower "
        + best.get(TOWER)
        + " m, star "
        + best.get(STAR_SECONDS)
        + " s"
        + lead;
  }
}

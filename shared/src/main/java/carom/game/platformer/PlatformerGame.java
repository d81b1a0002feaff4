package carom.game.platformer;

import carom.physics.WorldDef;
import carom.sim.Game;
import carom.sim.Match;
import carom.sim.MatchClock;
import carom.sim.MatchPhase;
import carom.sim.Rules;
import carom.sim.SetUp;
import carom.sim.Simulation;
import carom.sim.entity.Contact;
import carom.sim.entity.Entity;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.field.Field;
import carom.sim.level.Level;
import java.util.List;
import java.util.function.Consumer;

/**
 * The platformer, seen from the side: run, jump, collect coins, be first at the flag, beat the best
 * time from the start to the goal. The flag is worth {@value #FLAG_POINTS} coins and then moves to
 * another place; so is a run, which ends at the start. The first player with {@value
 * #POINTS_TO_WIN} points wins, or the one that leads after {@value #MATCH_SECONDS} s; then the
 * room's next match begins.
 *
 * <p>Foes patrol or chase. A player who lands on one beats it, and is thrown up; a player who runs
 * into one is thrown back and loses {@value #HURT_POINTS} points.
 *
 * <p>Jumping forgives. It still works shortly after leaving an edge (coyote time), it already
 * counts shortly before landing (jump buffer), and releasing the button early makes a small jump.
 * Players move relative to the body they stand on, so moving platforms carry them. Down drops
 * through one-way platforms.
 *
 * <p>Players are dynamic bodies, not {@link carom.physics.mover.Mover}s: they stand on each other,
 * push crates and are pushed, and clients predict that with the engine's own solver. A mover in
 * {@link Runners} would see the level's geometry only.
 *
 * <p>A level needs spawns {@code player}, where players also come back, and spawns {@code coin} and
 * {@code flag}; zones {@code start} and {@code goal} make a course, in place of flags or beside
 * them, and each zone {@code walker} or {@code hunter} has a foe. A player who falls below the
 * bounds is back a second later: at the last checkpoint that a trigger of the level gave, or
 * without one at the nearest spawn.
 *
 * <p>This class says what happens in which order; its parts say how.
 *
 * <pre>
 *   PlatformerGame       the order of a tick, points, the winner
 *     PlatformerFields   the state that is saved, hashed and sent
 *     Course             kinds of entities and events, the level's places
 *     Runners            running, jumping, dropping through platforms
 *     Foes               foes that patrol and chase
 *     Treasure           coins and the flag
 *     Runs               times from the start to the goal, and the path of the best
 *     Respawns           players who join, fall and come back; crates that fall
 * </pre>
 */
public final class PlatformerGame implements Game {
  /** Number of points that win a match. */
  public static final int POINTS_TO_WIN = 60;

  /** Longest match, seconds. */
  public static final float MATCH_SECONDS = 600;

  /** Number of points for the flag. A coin is 1 point. */
  public static final int FLAG_POINTS = 10;

  /** Number of points for a run from the start to the goal. */
  public static final int RUN_POINTS = 10;

  /** Number of points for a foe. */
  public static final int FOE_POINTS = 2;

  /** Number of points that a player loses to a foe. Nobody has less than 0. */
  public static final int HURT_POINTS = 3;

  /** Running speed, m/s. */
  public static final float SPEED = 8;

  /** Speed at the start of a jump, m/s. */
  public static final float JUMP_SPEED = 13;

  /** Width of a player, metres. */
  public static final float PLAYER_WIDTH = 0.8f;

  /** Height of a player, metres. The body's origin is in the middle. */
  public static final float PLAYER_HEIGHT = 1.4f;

  /** Fastest fall, m/s. */
  static final float MAX_FALL = 18;

  private static final MatchClock CLOCK = MatchClock.playing(MATCH_SECONDS);

  private Course course;
  private Runners runners;
  private Foes foes;
  private Runs runs;
  private Treasure treasure;
  private Respawns respawns;

  /** Creates the game, for the service loader. */
  public PlatformerGame() {}

  @Override
  public String name() {
    return "platformer";
  }

  @Override
  public String defaultLevel() {
    return "platformer";
  }

  @Override
  public String description() {
    return "run, jump and collect: a coin is 1 point, the flag is " + FLAG_POINTS;
  }

  @Override
  public WorldDef world(Level level) {
    // Seen a tick ahead, a fall at full speed ends on the ground and not 0.3 m inside it.
    return Game.super.world(level).withSpeculativeDistance(MAX_FALL / 60).withMaxPushSpeed(6);
  }

  @Override
  public List<Field<?>> fields() {
    return PlatformerFields.all();
  }

  @Override
  public MatchClock clock() {
    return CLOCK;
  }

  @Override
  public void setUp(SetUp s) {
    course = new Course(s);
    runners = new Runners(course);
    foes = new Foes(course);
    runs = new Runs(course);
    treasure = new Treasure(course);
    respawns = new Respawns(course);
  }

  @Override
  public void begin(Match m) {
    treasure.begin(m);
  }

  @Override
  public void join(Match m, Player p) {
    runs.join(p);
    respawns.join(m, p);
  }

  @Override
  public void beforeStep(Match m) {
    treasure.bringBack(m);
    if (m.tick() % Foes.LOOK_TICKS == 0) {
      foes.bringBack(m);
      foes.look(m);
    }
  }

  @Override
  public void input(Simulation s, Player p, Input in) {
    runs.begin(s, p);
    foes.meet(s, p, in);
    if (!Foes.isStunned(s, p)) {
      runners.move(s, p, in);
    }
  }

  @Override
  public Consumer<Rules> rules(Level level) {
    return Course.hasFoes(level) ? r -> foes.rules(r) : null;
  }

  @Override
  public void forces(Simulation s, Entity e) {
    if (course.isFoe(e)) {
      foes.walk(e);
    }
  }

  @Override
  public boolean collision(Simulation s, Contact c) {
    Entity self = c.self();
    Entity other = c.other();
    return !passes(self, other) && !passes(other, self) && c.holdsOneWay();
  }

  private boolean passes(Entity body, Entity other) {
    return Runners.drops(body, other) || foes.passes(body, other);
  }

  @Override
  public void entered(Match m, Entity sensor, Entity visitor) {
    Player p = visitor.owner();
    if (p == null || p.entity() != visitor || !MatchClock.isPlaying(m)) {
      return;
    }
    earn(m, p, treasure.collect(m, p, sensor));
  }

  private static void earn(Match m, Player p, int points) {
    if (!MatchClock.isPlaying(m)) {
      return;
    }
    m.score(p, Math.max(0, m.score(p) + points));
    if (m.score(p) >= POINTS_TO_WIN) {
      noteTime(m, p);
      CLOCK.finish(m, p);
    }
  }

  /** Notes the time in which a player has won, if it is its best. */
  private static void noteTime(Match m, Player p) {
    int ticks = m.ticks(MATCH_SECONDS) - MatchClock.ticksLeft(m);
    int ms = (int) (ticks * 1_000L / m.tickRate());
    int best = p.get(PlatformerFields.BEST_MS);
    p.set(PlatformerFields.BEST_MS, best == 0 ? ms : Math.min(best, ms));
  }

  @Override
  public void checkpoint(Match m, Player p, float x, float y) {
    respawns.checkpoint(m, p, x, y);
  }

  @Override
  public void afterStep(Match m) {
    for (Player p : m.players()) {
      settle(m, p);
      respawns.afterStep(m, p);
    }
    foes.clear(m);
    respawns.returnCrates(m);
  }

  /** Gives a player the points of its foes and of its run, which it follows. */
  private void settle(Match m, Player p) {
    runs.note(m, p);
    if (p.get(PlatformerFields.EARNED) != 0) {
      earn(m, p, p.get(PlatformerFields.EARNED));
      p.set(PlatformerFields.EARNED, 0);
    }
    if (MatchClock.isPlaying(m) && p.isAlive() && runs.isDone(p)) {
      runs.finish(m, p);
      respawns.returnToStart(m, p);
      earn(m, p, RUN_POINTS);
    }
  }

  /** Returns why a player has won. */
  private static String why(Match m, Player best) {
    Player second = null;
    for (Player p : m.players()) {
      second = p != best && (second == null || m.score(p) > m.score(second)) ? p : second;
    }
    String lead =
        second == null
            ? ""
            : ", " + (m.score(best) - m.score(second)) + " more than " + m.name(second);
    return m.score(best) >= POINTS_TO_WIN
        ? "first with " + m.score(best) + " points" + lead
        : "ahead when time was up: " + m.score(best) + " points" + lead;
  }

  @Override
  public void phase(Match m, MatchPhase now) {
    if (now == MatchPhase.OVER) {
      Player best = m.leader();
      CLOCK.decide(m, best, 0);
      if (best != null) {
        best.add(PlatformerFields.WINS, 1);
      }
      m.notice(best == null ? "A draw!" : m.name(best) + " wins, " + why(m, best));
    }
  }
}

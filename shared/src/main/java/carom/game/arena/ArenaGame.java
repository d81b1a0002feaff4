package carom.game.arena;

import static carom.game.arena.ArenaFields.BOOST;
import static carom.game.arena.ArenaFields.BURST;
import static carom.game.arena.ArenaFields.DASH;
import static carom.game.arena.ArenaFields.DASH_WAIT;
import static carom.game.arena.ArenaFields.DASH_X;
import static carom.game.arena.ArenaFields.DASH_Y;
import static carom.game.arena.ArenaFields.JOLTS;
import static carom.game.arena.ArenaFields.JOLT_WAIT;

import carom.physics.WorldDef;
import carom.physics.math.Trig;
import carom.sim.Game;
import carom.sim.Match;
import carom.sim.MatchClock;
import carom.sim.MatchPhase;
import carom.sim.SetUp;
import carom.sim.Simulation;
import carom.sim.Skill;
import carom.sim.entity.Contact;
import carom.sim.entity.Entity;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.event.Audience;
import carom.sim.field.Cooldown;
import carom.sim.field.Field;
import carom.sim.field.Gauge;
import carom.sim.level.Level;
import java.util.List;

/**
 * The arena, seen from above: two teams of discs, balls, two goals. A disc glides towards the
 * velocity its player asks for, F = k (v_goal - v), and dashes on {@link Input#ACTION}. {@link
 * #BOOSTS} makes it faster while its store lasts, {@link #SPINS_LEFT} and {@link #SPINS_RIGHT} turn
 * it, so that the ball it touches curves. On {@link Input#SECOND} it gives a jolt along its aim:
 * the first ball, disc or crate within {@value #JOLT_RANGE} m is pushed away, as judged by what the
 * player saw. A ball in the other team's goal counts for the team and for the player who touched it
 * last. The first team with {@value #GOALS_TO_WIN} goals wins, or the one that leads after {@value
 * #MATCH_SECONDS} s; then the room's next match begins. A player who is alone practises: goals
 * light lamps, but are forgotten when a second player comes and the match begins. There is one ball
 * for every {@value #PLAYERS_PER_BALL} players, beside the level's heavy ones.
 *
 * <p>A level needs zones {@code goal} and {@code home} for the teams 1 and 2 (the goal's team
 * defends it), and spawns {@code ball}. Each spawn {@code heavy ball} has a ball that weighs as
 * much as three discs, and so moves them. Zones {@code lamps} for both teams get a lamp for each
 * goal scored.
 *
 * <p>This class says what happens in which order; its parts say how.
 *
 * <pre>
 *   ArenaGame       input, and the order of a tick
 *     ArenaFields   the state that is saved, hashed and sent
 *     Pitch         kinds of entities and events, the level's zones
 *     Discs         players' bodies and teams
 *     Balls         kick-off, touches, what is stuck
 *     Goals         scores, lamps, the winner
 *     Jolts         pushes from afar, and their sparks
 *     Spin          discs that turn balls, and balls that curve
 * </pre>
 */
public final class ArenaGame implements Game {
  /** The button that makes a disc faster, of {@link Input#buttons()}. */
  public static final int BOOSTS = 1 << 5;

  /** The button by which a ball that the disc touches curves to the left. */
  public static final int SPINS_LEFT = 1 << 6;

  /** The button by which a ball that the disc touches curves to the right. */
  public static final int SPINS_RIGHT = 1 << 7;

  /** Number of goals that win a match. */
  public static final int GOALS_TO_WIN = 5;

  /** Longest match, seconds. */
  public static final float MATCH_SECONDS = 300;

  /** Number of players per ball. */
  public static final int PLAYERS_PER_BALL = 12;

  /** Speed of a disc without a dash, m/s. */
  public static final float SPEED = 7.5f;

  /** Speed of a disc that boosts, m/s. */
  public static final float BOOST_SPEED = 12;

  /** Time for which a full store of boost lasts, seconds. */
  public static final float BOOST_SECONDS = 1;

  /** Time in which an empty store is full again, seconds. */
  public static final float BOOST_FILL_SECONDS = 5;

  /** Number of steps in which a store of boost is spent and filled. */
  static final int BOOST_STEPS = 20;

  /** Speed of a dash, m/s. */
  public static final float DASH_SPEED = 17;

  /** Time from dash to dash, seconds. */
  public static final float DASH_COOLDOWN = 1.1f;

  /** Reach of a jolt from the disc's centre, metres. */
  public static final float JOLT_RANGE = 12;

  /** Time from jolt to jolt, seconds. */
  public static final float JOLT_COOLDOWN = 1.5f;

  /** Least speed at which balls and discs hit for an event, m/s. */
  private static final float MIN_HIT_SPEED = 3;

  /** Impulse of a jolt, N s. A ball leaves with 11 m/s. */
  public static final float JOLT_IMPULSE = 6;

  private static final float DASH_SECONDS = 0.16f;
  private static final float STEER = 10; // k / mass, 1/s: most of the goal velocity in 0.1 s
  private static final float DASH_STEER = 30;
  private static final float INTERMISSION_SECONDS = 6;

  /** The phases of a match. */
  static final MatchClock CLOCK =
      MatchClock.playing(MATCH_SECONDS).warmUp(Pitch.TEAMS).over(INTERMISSION_SECONDS);

  private Pitch pitch;
  private Discs discs;
  private Goals goals;
  private Balls balls;
  private Jolts jolts;
  private final Spin spin = new Spin();

  /** Creates the game, for the service loader. */
  public ArenaGame() {}

  @Override
  public String name() {
    return "arena";
  }

  @Override
  public String defaultLevel() {
    return "arena";
  }

  @Override
  public String description() {
    return "push the balls into the other side's goal";
  }

  @Override
  public List<Cooldown> cooldowns() {
    return List.of(
        new Cooldown("dash", DASH_WAIT, DASH_COOLDOWN),
        new Cooldown("jolt", JOLT_WAIT, JOLT_COOLDOWN));
  }

  @Override
  public List<Field<?>> fields() {
    return ArenaFields.all();
  }

  @Override
  public boolean looksBack() {
    return true;
  }

  @Override
  public WorldDef world(Level level) {
    // Seen half a tick ahead, a hard shot ends at the wall and not inside it.
    return Game.super.world(level).withSpeculativeDistance(Balls.MAX_SPEED / 120);
  }

  @Override
  public void setUp(SetUp s) {
    pitch = new Pitch(s);
    discs = new Discs(pitch);
    goals = new Goals(pitch, discs);
    balls = new Balls(pitch, goals);
    jolts = new Jolts(pitch);
  }

  @Override
  public void begin(Match m) {
    goals.setLamps(m);
  }

  @Override
  public List<String> teams() {
    return List.of(Pitch.TEAM_NAMES[1], Pitch.TEAM_NAMES[2]);
  }

  @Override
  public int teamRgb(int team) {
    return Pitch.TEAM_COLORS[team];
  }

  @Override
  public List<Gauge> gauges() {
    return List.of(Gauge.teamScore(ArenaFields.GOALS));
  }

  @Override
  public Skill skill() {
    return Skill.of(ArenaFields.RATING).within(100).widening(40);
  }

  @Override
  public void join(Match m, Player p) {
    m.team(p, m.teamSize(1) <= m.teamSize(2) ? 1 : 2);
    discs.give(m, p);
  }

  @Override
  public void teamChanged(Match m, Player p) {
    discs.changeTeam(m, p);
  }

  @Override
  public void input(Simulation s, Player p, Input in) {
    Entity body = p.entity();
    float x = in.moveX();
    float y = in.moveY();
    float length = (float) Math.sqrt(x * x + y * y);
    if (length > 1) {
      x /= length;
      y /= length;
    }
    boolean jolts = in.pressed(Input.SECOND) && p.get(JOLT_WAIT) == 0;
    if (jolts) {
      p.set(JOLT_WAIT, s.ticks(JOLT_COOLDOWN));
      s.emit(pitch.jolt).at(body.x(), body.y()).of(p.entity()).by(p);
    }
    boolean dashes = in.pressed(Input.ACTION) && p.get(DASH_WAIT) == 0;
    if (dashes) {
      p.set(DASH, s.ticks(DASH_SECONDS));
      p.set(DASH_WAIT, s.ticks(DASH_COOLDOWN));
      boolean steered = length > 0.3f;
      float scale = Math.min(1, length);
      p.set(DASH_X, steered ? x / scale : Trig.cos(in.aim()));
      p.set(DASH_Y, steered ? y / scale : Trig.sin(in.aim()));
      s.emit(pitch.dash).at(body.x(), body.y()).of(p.entity()).by(p);
    }
    p.set(JOLTS, jolts);
    float speed = boosts(s, p, in, length > 0.3f) ? BOOST_SPEED : SPEED;
    if (p.get(DASH) > 0) {
      float dashX = p.get(DASH_X) * DASH_SPEED;
      float dashY = p.get(DASH_Y) * DASH_SPEED;
      body.seekVelocity(dashX, dashY, DASH_STEER);
    } else {
      body.seekVelocity(x * speed, y * speed, STEER);
    }
    if (in.held(SPINS_LEFT) != in.held(SPINS_RIGHT)) {
      body.setAngularVelocity(in.held(SPINS_LEFT) ? -Spin.DISC : Spin.DISC);
    } else {
      face(body, x, y, length);
    }
  }

  /** Burns or fills a player's store of boost, a step at a time; returns whether it boosts. */
  private boolean boosts(Simulation s, Player p, Input in, boolean moves) {
    float step = 1f / BOOST_STEPS;
    if (p.get(BURST) == 0 && moves && in.held(BOOSTS) && p.get(BOOST) > 0) {
      p.add(BOOST, -step);
      p.set(BURST, s.ticks(BOOST_SECONDS * step));
      s.emit(pitch.boost).at(p.entity().x(), p.entity().y()).of(p.entity()).by(p);
    } else if (!in.held(BOOSTS) && s.tick() % s.ticks(BOOST_FILL_SECONDS * step) == 0) {
      p.add(BOOST, step);
    }
    return p.get(BURST) > 0;
  }

  /** Turns a disc towards its movement. This is for the eye only: discs don't roll. */
  private static void face(Entity body, float x, float y, float length) {
    if (length < 0.1f) {
      body.setAngularVelocity(0);
      return;
    }
    float cross = body.cos() * y - body.sin() * x;
    float dot = body.cos() * x + body.sin() * y;
    float turn = dot < 0 && Math.abs(cross) < 0.5f ? (cross < 0 ? -0.5f : 0.5f) : cross;
    body.setAngularVelocity(14 * turn);
  }

  @Override
  public void forces(Simulation s, Entity e) {
    if (pitch.isBall(e)) {
      spin.forces(e);
    }
  }

  @Override
  public boolean collision(Simulation s, Contact c) {
    spin.collision(c);
    return c.holdsOneWay();
  }

  @Override
  public void hit(Simulation s, Contact c) {
    Entity a = c.self();
    Entity b = c.other();
    if (c.hitSpeed() < MIN_HIT_SPEED || !(isHeard(a) || isHeard(b))) {
      return;
    }
    s.emit(pitch.hit).at(c.hitX(), c.hitY()).of(a).with(b).strength(c.impulse());
  }

  /**
   * Returns whether hits of an entity emit events: those of balls and discs do, those among crates
   * don't.
   */
  private boolean isHeard(Entity e) {
    return pitch.isBall(e) || e.isOwned();
  }

  @Override
  public Audience audience(Match m, Entity e) {
    return pitch.isBall(e) ? Audience.ALL : Audience.NEAR; // all know where to run
  }

  @Override
  public void beforeStep(Match m) {
    if (!isOver(m)) {
      balls.kickOffMissing(m);
    }
  }

  /** Returns whether a match is over and the next one hasn't begun. */
  static boolean isOver(Match m) {
    return MatchClock.phase(m) == MatchPhase.OVER;
  }

  @Override
  public void afterStep(Match m) {
    for (Player p : m.players()) {
      if (p.isAlive() && p.get(JOLTS)) {
        jolts.give(m, p);
      }
    }
    Jolts.fadeSparks(m);
    balls.follow(m);
    discs.bringBack(m);
  }

  @Override
  public MatchClock clock() {
    return CLOCK;
  }

  @Override
  public void phase(Match m, MatchPhase now) {
    if (now == MatchPhase.PLAYING) {
      goals.clear(m);
      Balls.removeAll(m);
      Balls.clearWaits(m);
    } else if (now == MatchPhase.OVER) {
      goals.decide(m);
      Balls.removeAll(m);
    }
  }
}

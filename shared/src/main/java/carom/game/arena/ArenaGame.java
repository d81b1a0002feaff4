package carom.game.arena;

import static carom.sim.event.Audience.ALL;
import static carom.sim.event.Audience.NOBODY;
import static carom.sim.field.Scope.ENTITY;
import static carom.sim.field.Scope.MATCH;

import carom.physics.Body;
import carom.physics.BodyContactVisitor;
import carom.physics.BodyType;
import carom.physics.Collision;
import carom.physics.Material;
import carom.physics.QueryFilter;
import carom.physics.QueryHit;
import carom.physics.WorldDef;
import carom.physics.geometry.Circle;
import carom.physics.math.Trig;
import carom.sim.Game;
import carom.sim.MatchClock;
import carom.sim.Role;
import carom.sim.Simulation;
import carom.sim.entity.Entity;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.event.EventKind;
import carom.sim.event.Sound;
import carom.sim.field.Cooldown;
import carom.sim.field.Count;
import carom.sim.field.Countdown;
import carom.sim.field.EntityRef;
import carom.sim.field.Field;
import carom.sim.field.Flag;
import carom.sim.field.PlayerRef;
import carom.sim.field.Real;
import carom.sim.level.Appearance;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import carom.sim.match.MatchPhase;
import java.util.List;

/**
 * The arena, seen from above: two teams of discs, balls, two goals. A disc glides towards the
 * velocity its player asks for, F = k (v_goal - v), and dashes on {@link Input#ACTION}. On {@link
 * Input#SECOND} it gives a jolt along its aim: the first ball, disc or crate within {@value
 * #JOLT_RANGE} m is pushed away, as judged by what the player saw. A ball in the other team's goal
 * counts for the team and for the player who touched it last. The first team with {@value
 * #GOALS_TO_WIN} goals wins, or the one that leads after {@value #MATCH_SECONDS} s; then the room's
 * next match begins. A player who is alone practises: goals light lamps, but are forgotten when a
 * second player comes and the match begins. There is one ball for every {@value #PLAYERS_PER_BALL}
 * players.
 *
 * <p>A level needs zones {@code goal} and {@code home} for the teams 1 and 2 (the goal's team
 * defends it), and spawns {@code ball}. Zones {@code lamps} for both teams get a lamp for each goal
 * scored.
 *
 * <p><b>Length.</b> The class is an example to copy: all rules of a game stand in one place, in the
 * order in which a tick uses them.
 */
public final class ArenaGame implements Game {
  /** Number of goals that win a match. */
  public static final int GOALS_TO_WIN = 5;

  /** Longest match, seconds. */
  public static final float MATCH_SECONDS = 300;

  /** Number of players per ball. */
  public static final int PLAYERS_PER_BALL = 12;

  /** Speed of a disc without a dash, m/s. */
  public static final float SPEED = 7.5f;

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

  /** Impulse of the loudest hit, a dash into a ball, N s. */
  private static final float LOUD_HIT = 12;

  /** Impulse of a jolt, N s. A ball leaves with 11 m/s. */
  public static final float JOLT_IMPULSE = 6;

  private static final float SPARK_SECONDS = 0.2f;
  private static final float DASH_SECONDS = 0.16f;
  private static final float STEER = 10; // k / mass, 1/s: most of the goal velocity in 0.1 s
  private static final float DASH_STEER = 30;
  private static final float PLAYER_RADIUS = 0.6f;
  private static final float BALL_RADIUS = 0.7f;
  private static final float BALL_MAX_SPEED = 32;
  private static final float KICK_OFF_SECONDS = 2;
  private static final float INTERMISSION_SECONDS = 6;
  private static final float STUCK_SECONDS = 4;
  private static final float STUCK_RADIUS = 1.5f;
  private static final int MAX_BALLS = 4;
  private static final int TEAMS = 2;
  private static final String[] TEAM_NAMES = {"", "Red", "Blue"};
  private static final int[] TEAM_COLORS = {0, 0xff5d5d, 0x4da3ff};

  private static final int MAX_SPARKS = 16;

  private static final MatchClock CLOCK =
      MatchClock.playing(MATCH_SECONDS).warmUp(TEAMS).over(INTERMISSION_SECONDS);

  // Of a player. Input writes them, so that clients predict dashes and jolts.
  private static final Countdown DASH = Field.countdown("dash"); // while it lasts
  private static final Countdown DASH_WAIT = Field.countdown("dashWait"); // until the next one
  private static final Real DASH_X = Field.real("dashX"); // where it goes
  private static final Real DASH_Y = Field.real("dashY");
  private static final Flag DASH_HELD = Field.flag("dashHeld"); // the button, a tick ago
  private static final Flag JOLTS = Field.flag("jolts"); // gives a jolt in this tick
  private static final Countdown JOLT_WAIT = Field.countdown("joltWait");
  private static final Flag JOLT_HELD = Field.flag("joltHeld");

  // Of the match. Goals have the team as index.
  private static final Count GOALS =
      Field.count("goals", 0, GOALS_TO_WIN).of(MATCH).to(ALL).times(TEAMS + 1);
  private static final EntityRef BALL = Field.entity("ball").of(MATCH).to(ALL).times(MAX_BALLS);
  private static final Countdown BALL_WAIT =
      Field.countdown("ballWait").of(MATCH).to(NOBODY).times(MAX_BALLS);
  private static final EntityRef LAMP =
      Field.entity("lamp").of(MATCH).to(NOBODY).times(TEAMS * GOALS_TO_WIN);
  private static final EntityRef SPARK =
      Field.entity("spark").of(MATCH).to(NOBODY).times(MAX_SPARKS);

  // Of a ball: who touched it, and for how long it has stayed around one place.
  private static final PlayerRef TOUCHED = Field.player("touched").of(ENTITY).to(NOBODY);
  private static final PlayerRef TOUCHED_BEFORE =
      Field.player("touchedBefore").of(ENTITY).to(NOBODY);
  private static final Real PLACE_X = Field.real("placeX").of(ENTITY).to(NOBODY);
  private static final Real PLACE_Y = Field.real("placeY").of(ENTITY).to(NOBODY);
  private static final Countdown UNTIL_STUCK = Field.countdown("untilStuck").of(ENTITY).to(NOBODY);

  // Of a spark.
  private static final Countdown GLOW = Field.countdown("glow").of(ENTITY).to(NOBODY);

  private final Archetype[] discs = new Archetype[TEAMS + 1];
  private final Archetype[] lamps = new Archetype[TEAMS + 1];
  private final Level.Zone[] homes = new Level.Zone[TEAMS + 1];
  private final BodyContactVisitor<Entity> touch = this::touched;
  private final QueryHit<Entity> hit = new QueryHit<>();
  private final QueryFilter<Entity> inTheWay = this::isInTheWay;
  private Simulation simulation;
  private Body<Entity> jolter;
  private Archetype spark;
  private Archetype ball;
  private EventKind hitEvent;
  private EventKind dashEvent;
  private EventKind joltEvent;
  private EventKind joltHitEvent;
  private EventKind goalEvent;
  private List<Level.Zone> goals = List.of();
  private List<Level.Spawn> kickOffs = List.of();
  private Player lastTouch;

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
    return "push the balls into the other side's goal: Space dashes, E jolts from afar";
  }

  @Override
  public List<Cooldown> cooldowns() {
    return List.of(
        new Cooldown("dash", DASH_WAIT, DASH_COOLDOWN),
        new Cooldown("jolt", JOLT_WAIT, JOLT_COOLDOWN));
  }

  @Override
  public List<Field<?>> fields() {
    return List.of(
        DASH,
        DASH_WAIT,
        DASH_X,
        DASH_Y,
        DASH_HELD,
        JOLTS,
        JOLT_WAIT,
        JOLT_HELD,
        GOALS,
        BALL,
        BALL_WAIT,
        LAMP,
        SPARK,
        TOUCHED,
        TOUCHED_BEFORE,
        PLACE_X,
        PLACE_Y,
        UNTIL_STUCK,
        GLOW);
  }

  @Override
  public boolean looksBack() {
    return true;
  }

  @Override
  public WorldDef world(Level level) {
    // Seen half a tick ahead, a hard shot ends at the wall and not inside it.
    return Game.super.world(level).withSpeculativeDistance(BALL_MAX_SPEED / 120);
  }

  @Override
  public void setUp(Simulation s) {
    simulation = s;
    Material skin = new Material(1, 0.3f, 0.4f);
    for (int team = 1; team <= TEAMS; team++) {
      discs[team] =
          s.archetypes()
              .add(
                  new ArchetypeDef("player." + TEAM_NAMES[team])
                      .shape(new Circle(PLAYER_RADIUS), skin)
                      .fixedRotation(true)
                      .tag(team)
                      .appearance(Appearance.of(TEAM_COLORS[team], Appearance.Look.PLAYER)));
    }
    for (int team = 0; team <= TEAMS; team++) {
      lamps[team] =
          s.archetypes()
              .add(
                  new ArchetypeDef("lamp." + TEAM_NAMES[team])
                      .type(BodyType.STATIC)
                      .shape(new Circle(0.3f), skin)
                      .sensor(true)
                      .appearance(
                          Appearance.of(
                              team == 0 ? 0x1d2733 : TEAM_COLORS[team], Appearance.Look.LAMP)));
    }
    ball =
        s.archetypes()
            .add(
                new ArchetypeDef("ball")
                    .shape(new Circle(BALL_RADIUS), new Material(0.35f, 0.3f, 0.7f))
                    .linearDamping(0.45f)
                    .angularDamping(0.8f)
                    .appearance(Appearance.of(0xffe08a, Appearance.Look.BALL)));
    spark =
        s.archetypes()
            .add(
                new ArchetypeDef("spark")
                    .type(BodyType.STATIC)
                    .shape(new Circle(0.25f), skin)
                    .sensor(true)
                    .appearance(Appearance.of(0xfff6c8, Appearance.Look.LAMP)));
    hitEvent = s.eventKinds().add("hit", 0xffffff, 0, "", Sound.KNOCK, LOUD_HIT); // sparks show it
    dashEvent = s.eventKinds().add("dash", 0x9ad1ff, 1.2f, "", Sound.WHOOSH, 0);
    joltEvent = s.eventKinds().add("jolt", 0xfff6c8, 1.5f, "", Sound.ZAP, 0);
    joltHitEvent = s.eventKinds().add("jolt hit", 0xfff6c8, 2, "", Sound.KNOCK, JOLT_IMPULSE);
    goalEvent = s.eventKinds().add("goal", 0xffe08a, 6, "GOAL", Sound.FANFARE, 0);
    goals = s.level().zones("goal");
    kickOffs = s.level().spawns("ball");
    for (Level.Zone home : s.level().zones("home")) {
      if (home.team() >= 1 && home.team() <= TEAMS) {
        homes[home.team()] = home;
      }
    }
    require(s, goals.size() >= TEAMS, "zones named \"goal\" of teams 1 and 2");
    require(s, !kickOffs.isEmpty(), "a spawn named \"ball\"");
    require(s, homes[1] != null && homes[2] != null, "zones named \"home\" of teams 1 and 2");
    if (s.role() == Role.AUTHORITY) {
      setLamps(s);
    }
  }

  private static void require(Simulation s, boolean met, String what) {
    if (!met) {
      throw new IllegalArgumentException(
          "level \"" + s.level().name() + "\" can't be played as arena: it needs " + what);
    }
  }

  @Override
  public List<String> teams() {
    return List.of(TEAM_NAMES[1], TEAM_NAMES[2]);
  }

  @Override
  public void join(Simulation s, Player p) {
    p.team(s.teamSize(1) <= s.teamSize(2) ? 1 : 2);
    giveBody(s, p);
  }

  @Override
  public void teamChanged(Simulation s, Player p) {
    giveBody(s, p);
    s.notice(p.name() + " now plays for " + TEAM_NAMES[p.team()]);
  }

  @Override
  public void input(Simulation s, Player p, Input in) {
    Body<Entity> body = p.body().body();
    float x = in.moveX();
    float y = in.moveY();
    float length = (float) Math.sqrt(x * x + y * y);
    if (length > 1) {
      x /= length;
      y /= length;
    }
    boolean jolts = in.held(Input.SECOND) && !p.get(JOLT_HELD) && p.get(JOLT_WAIT) == 0;
    if (jolts) {
      p.set(JOLT_WAIT, s.ticks(JOLT_COOLDOWN));
      s.emit(joltEvent).at(body.x(), body.y()).of(p.body()).by(p);
    }
    boolean dashes = in.held(Input.ACTION) && !p.get(DASH_HELD) && p.get(DASH_WAIT) == 0;
    if (dashes) {
      p.set(DASH, s.ticks(DASH_SECONDS));
      p.set(DASH_WAIT, s.ticks(DASH_COOLDOWN));
      boolean steered = length > 0.3f;
      float scale = Math.min(1, length);
      p.set(DASH_X, steered ? x / scale : Trig.cos(in.aim()));
      p.set(DASH_Y, steered ? y / scale : Trig.sin(in.aim()));
      s.emit(dashEvent).at(body.x(), body.y()).of(p.body()).by(p);
    }
    p.set(JOLTS, jolts);
    p.set(JOLT_HELD, in.held(Input.SECOND));
    p.set(DASH_HELD, in.held(Input.ACTION));
    if (p.get(DASH) > 0) {
      float dashX = p.get(DASH_X) * DASH_SPEED;
      float dashY = p.get(DASH_Y) * DASH_SPEED;
      body.seekVelocity(dashX, dashY, DASH_STEER * body.mass());
    } else {
      body.seekVelocity(x * SPEED, y * SPEED, STEER * body.mass());
    }
    face(body, x, y, length);
  }

  /** Turns a disc towards its movement. This is for the eye only: discs don't roll. */
  private static void face(Body<Entity> body, float x, float y, float length) {
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
  public void hit(Simulation s, Collision<Entity> c) {
    Entity a = c.self().user();
    Entity b = c.other().user();
    if (c.hitSpeed() < MIN_HIT_SPEED || !(isHeard(a) || isHeard(b))) {
      return;
    }
    s.emit(hitEvent).at(c.hitX(), c.hitY()).of(a).with(b).strength(c.impulse());
  }

  /**
   * Returns whether hits of an entity emit events: those of balls and discs do, those among crates
   * don't.
   */
  private boolean isHeard(Entity e) {
    return e.archetype() == ball || e.ownerId() != Entity.NO_OWNER;
  }

  @Override
  public void beforeStep(Simulation s) {
    if (isOver(s)) {
      return;
    }
    int wanted = Math.min(MAX_BALLS, 1 + s.playerCount() / PLAYERS_PER_BALL);
    for (int i = 0; i < wanted; i++) {
      if (s.get(BALL, i) == null && s.get(BALL_WAIT, i) == 0) {
        kickOff(s, i);
      }
    }
  }

  private static boolean isOver(Simulation s) {
    return MatchClock.phase(s) == MatchPhase.OVER;
  }

  @Override
  public void afterStep(Simulation s) {
    for (int id = 0; id < s.playerCapacity(); id++) {
      Player p = s.player(id);
      if (p != null && p.body() != null && p.get(JOLTS)) {
        jolt(s, p);
      }
    }
    fadeSparks(s);
    for (int i = 0; i < MAX_BALLS; i++) {
      if (s.get(BALL, i) != null) {
        followBall(s, i, s.get(BALL, i));
      }
    }
    bringBack(s);
  }

  /** Pushes the body that the player saw in front of it, where that body is now. */
  private void jolt(Simulation s, Player p) {
    jolter = p.body().body();
    float wayX = JOLT_RANGE * Trig.cos(p.input().aim());
    float wayY = JOLT_RANGE * Trig.sin(p.input().aim());
    boolean any = s.asSeenBy(p).rayClosest(jolter.x(), jolter.y(), wayX, wayY, inTheWay, hit);
    if (!any) {
      return;
    }
    Body<Entity> target = hit.body();
    if (target.type() == BodyType.DYNAMIC) {
      float scale = JOLT_IMPULSE / JOLT_RANGE;
      target.applyImpulse(wayX * scale, wayY * scale);
    }
    s.emit(joltHitEvent).at(hit.x(), hit.y()).of(target.user()).by(p).strength(JOLT_IMPULSE);
    showSpark(s, p, hit.x(), hit.y());
  }

  private boolean isInTheWay(Body<Entity> body, int shape) {
    return body != jolter && !body.sensor(shape);
  }

  /**
   * Shows all players where a jolt has hit, for a moment or until the player leaves. When there are
   * too many sparks, the oldest one goes.
   */
  private void showSpark(Simulation s, Player p, float x, float y) {
    int oldest = 0;
    for (int i = 0; i < MAX_SPARKS; i++) {
      oldest = glow(s, i) < glow(s, oldest) ? i : oldest;
    }
    if (s.get(SPARK, oldest) != null) {
      s.despawn(s.get(SPARK, oldest));
    }
    Entity shown = s.spawn(spark, x, y, 0, p);
    shown.set(GLOW, s.ticks(SPARK_SECONDS));
    s.set(SPARK, oldest, shown);
  }

  /** Returns the ticks that a spark still glows, 0 if there is none. */
  private static int glow(Simulation s, int i) {
    Entity shown = s.get(SPARK, i);
    return shown == null ? 0 : shown.get(GLOW);
  }

  private static void fadeSparks(Simulation s) {
    for (int i = 0; i < MAX_SPARKS; i++) {
      Entity shown = s.get(SPARK, i);
      if (shown != null && shown.get(GLOW) == 0) {
        s.despawn(shown);
      }
    }
  }

  private void followBall(Simulation s, int i, Entity e) {
    Body<Entity> body = e.body();
    lastTouch = null;
    body.forEachContact(touch);
    if (lastTouch != null && lastTouch != e.get(TOUCHED)) {
      e.set(TOUCHED_BEFORE, e.get(TOUCHED));
      e.set(TOUCHED, lastTouch);
    }
    float speed2 = body.velocityX() * body.velocityX() + body.velocityY() * body.velocityY();
    if (speed2 > BALL_MAX_SPEED * BALL_MAX_SPEED) {
      float scale = BALL_MAX_SPEED / (float) Math.sqrt(speed2);
      body.setVelocity(body.velocityX() * scale, body.velocityY() * scale);
    }
    for (int g = 0; g < goals.size() && !isOver(s); g++) {
      if (goals.get(g).contains(body.x(), body.y())) {
        score(s, i, e, goals.get(g).team());
        return;
      }
    }
    if (isStuck(s, i, e) || !s.level().bounds().contains(body.x(), body.y())) {
      removeBall(s, i, e);
      s.notice("The ball is back in the middle");
    }
  }

  /** Returns whether a ball has stayed around one place for long since it was first played. */
  private boolean isStuck(Simulation s, int i, Entity e) {
    Body<Entity> body = e.body();
    Level.Spawn spot = kickOffs.get(i % kickOffs.size());
    float dx = body.x() - e.get(PLACE_X);
    float dy = body.y() - e.get(PLACE_Y);
    boolean moved = dx * dx + dy * dy > STUCK_RADIUS * STUCK_RADIUS;
    boolean waits = body.x() == spot.x() && body.y() == spot.y();
    if (moved || waits) {
      e.set(PLACE_X, body.x());
      e.set(PLACE_Y, body.y());
      e.set(UNTIL_STUCK, s.ticks(STUCK_SECONDS));
    }
    return e.get(UNTIL_STUCK) == 0;
  }

  private void touched(Body<Entity> other, float normalX, float normalY, float impulse) {
    Player owner = simulation.owner(other.user());
    if (owner != null) {
      lastTouch = owner;
    }
  }

  private void score(Simulation s, int i, Entity e, int defender) {
    int team = TEAMS + 1 - defender;
    s.add(GOALS, team, 1);
    Player last = e.get(TOUCHED);
    Player before = e.get(TOUCHED_BEFORE);
    String who = "";
    Player scorer = last;
    if (last != null && last.team() == team) {
      last.score(last.score() + 1);
      who = ": " + last.name();
    } else if (before != null && before.team() == team) {
      before.score(before.score() + 1);
      scorer = before;
      who = ": " + before.name();
    } else if (last != null) {
      who = ", own goal by " + last.name();
    }
    s.emit(goalEvent).at(e.body().x(), e.body().y()).of(e).by(scorer).data(team).to(ALL);
    String standing = s.get(GOALS, 1) + " : " + s.get(GOALS, 2);
    s.notice("Goal for " + TEAM_NAMES[team] + who + " (" + standing + ")");
    removeBall(s, i, e);
    setLamps(s);
    if (s.get(GOALS, team) < GOALS_TO_WIN) {
      balance(s);
    } else if (MatchClock.isPlaying(s)) {
      CLOCK.finish(s, team);
    } else {
      clearScores(s);
    }
  }

  private void clearScores(Simulation s) {
    for (int team = 1; team <= TEAMS; team++) {
      s.set(GOALS, team, 0);
    }
    for (int id = 0; id < s.playerCapacity(); id++) {
      if (s.player(id) != null) {
        s.player(id).score(0);
      }
    }
    setLamps(s);
  }

  @Override
  public MatchClock clock() {
    return CLOCK;
  }

  @Override
  public void phase(Simulation s, MatchPhase now) {
    if (now == MatchPhase.PLAYING) {
      clearScores(s);
      removeBalls(s);
      for (int i = 0; i < MAX_BALLS; i++) {
        s.set(BALL_WAIT, i, 0);
      }
    } else if (now == MatchPhase.OVER) {
      int red = s.get(GOALS, 1);
      int blue = s.get(GOALS, 2);
      int winner = red == blue ? 0 : red > blue ? 1 : 2;
      CLOCK.decide(s, null, winner);
      s.notice(
          (winner == 0 ? "A draw, " : TEAM_NAMES[winner] + " wins ") + red + " : " + blue + "!");
      removeBalls(s);
    }
  }

  private static void removeBalls(Simulation s) {
    for (int i = 0; i < MAX_BALLS; i++) {
      if (s.get(BALL, i) != null) {
        removeBall(s, i, s.get(BALL, i));
      }
    }
  }

  private void kickOff(Simulation s, int i) {
    Level.Spawn spot = kickOffs.get(i % kickOffs.size());
    Entity e = s.spawn(ball, spot.x(), spot.y(), 0, null);
    e.set(UNTIL_STUCK, s.ticks(STUCK_SECONDS));
    s.set(BALL, i, e);
  }

  private static void removeBall(Simulation s, int i, Entity e) {
    s.despawn(e);
    s.set(BALL_WAIT, i, s.ticks(KICK_OFF_SECONDS));
  }

  /**
   * Moves the newest players of the larger team to the other one, until the sizes differ by one at
   * most.
   */
  private void balance(Simulation s) {
    for (int id = s.playerCapacity() - 1; id >= 0; id--) {
      int more = s.teamSize(1) - s.teamSize(2);
      Player p = s.player(id);
      if (p != null && ((more > 1 && p.team() == 1) || (more < -1 && p.team() == 2))) {
        p.team(TEAMS + 1 - p.team());
        teamChanged(s, p);
      }
    }
  }

  /** Brings back players and crates that left the field, and crates that block a goal. */
  private void bringBack(Simulation s) {
    Level.Bounds bounds = s.level().bounds();
    for (int id = 0; id < s.playerCapacity(); id++) {
      Player p = s.player(id);
      if (p != null && p.body() != null) {
        Body<Entity> body = p.body().body();
        if (!bounds.contains(body.x(), body.y())) {
          giveBody(s, p);
        }
      }
    }
    for (int id = 0; id < s.level().bodies().size(); id++) {
      Body<Entity> body = s.entity(id).body();
      boolean lost = !bounds.contains(body.x(), body.y());
      for (int g = 0; g < goals.size() && !lost; g++) {
        lost = goals.get(g).contains(body.x(), body.y());
      }
      if (lost) {
        sendHome(s, id);
      }
    }
  }

  private static void sendHome(Simulation s, int id) {
    Body<Entity> body = s.entity(id).body();
    if (body.type() == BodyType.DYNAMIC) {
      Level.Placement p = s.level().bodies().get(id);
      s.entity(id).teleport(p.x(), p.y(), p.angle());
      body.setVelocity(0, 0);
      body.setAngularVelocity(0);
    }
  }

  /** Gives a player a new body at a free place of the team's home. */
  private void giveBody(Simulation s, Player p) {
    if (p.body() != null) {
      s.despawn(p.body());
    }
    p.resetFields();
    Level.Zone home = homes[p.team()];
    float cell = 2.2f * PLAYER_RADIUS;
    int columns = Math.max(1, (int) ((home.maxX() - home.minX()) / cell));
    int rows = Math.max(1, (int) ((home.maxY() - home.minY()) / cell));
    int start = s.random().nextInt(columns * rows);
    float x = 0;
    float y = 0;
    for (int i = 0; i < columns * rows; i++) {
      int place = (start + i) % (columns * rows);
      int row = place / columns;
      x = home.minX() + (place % columns + 0.5f) * cell;
      y = home.minY() + (row + 0.5f) * cell;
      if (isFree(s, x, y)) {
        break;
      }
    }
    s.spawn(discs[p.team()], x, y, p.team() == 1 ? 0 : (float) Math.PI, p);
  }

  private static boolean isFree(Simulation s, float x, float y) {
    float distance = PLAYER_RADIUS + 0.7f;
    for (int id = 0; id < s.entityCapacity(); id++) {
      Entity e = s.entity(id);
      if (e != null && !e.archetype().sensor()) {
        float dx = e.body().x() - x;
        float dy = e.body().y() - y;
        if (dx * dx + dy * dy < distance * distance) {
          return false;
        }
      }
    }
    return true;
  }

  /** Places one lamp for each goal that wins, and lights one for each goal scored. */
  private void setLamps(Simulation s) {
    for (Level.Zone zone : s.level().zones("lamps")) {
      int team = zone.team();
      for (int i = 0; i < GOALS_TO_WIN && team >= 1 && team <= TEAMS; i++) {
        Archetype kind = lamps[s.get(GOALS, team) > i ? team : 0];
        int slot = (team - 1) * GOALS_TO_WIN + i;
        Entity lamp = s.get(LAMP, slot);
        if (lamp != null && lamp.archetype() != kind) {
          s.despawn(lamp);
          lamp = null;
        }
        if (lamp == null) {
          float x = zone.minX() + (zone.maxX() - zone.minX()) * (i + 0.5f) / GOALS_TO_WIN;
          lamp = s.spawn(kind, x, (zone.minY() + zone.maxY()) / 2, 0, null);
          s.set(LAMP, slot, lamp);
        }
      }
    }
  }
}

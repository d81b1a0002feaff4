package carom.server;

import carom.fixtures.PlainGame;
import carom.physics.Material;
import carom.physics.geometry.Circle;
import carom.sim.Match;
import carom.sim.SetUp;
import carom.sim.Simulation;
import carom.sim.entity.Entity;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.event.Audience;
import carom.sim.event.EventKind;
import carom.sim.field.Count;
import carom.sim.field.Field;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Random;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Supplier;

/** A game with balls without gravity, one of which each player steers. It fails on demand. */
final class TestGame extends PlainGame {
  static final float SPEED = 6;

  private static final String LEVEL =
      """
      {
        "name": "test",
        "game": "test",
        "gravity": [0, 0],
        "bounds": { "min": [-1000, -1000], "max": [1000, 1000] },
        "spawns": [ { "name": "player", "at": [0, 0] } ]
      }
      """;

  /** The first word of each player, 77 from the join on. */
  static final Count MARK = Field.count("mark", 0, 100);

  /** How often the player pressed the action. */
  static final Count ACTIONS = Field.count("actions", 0, 1 << 30);

  final int balls;
  boolean ballsMove = true;

  /** All balls begin around the first player's body, in touch with each other. */
  boolean crowded;

  /** Two teams that don't see each other; a player that acts emits an event. */
  boolean teamsHide;

  boolean relaysAhead = true;
  boolean keepsMore;

  /** What {@link #keepsMore} throws instead of an answer; null for nothing. */
  Supplier<Error> keepsMoreFails = () -> null;

  /**
   * Makes {@link #beforeStep} wait for as long as it is true, which leaves the processor to others.
   */
  volatile boolean hangs;

  /** Makes {@link #beforeStep} loop for as long as it is true, and take a processor. */
  volatile boolean loops;

  /** Makes {@link #setUp} wait for as long as it is true, which leaves the processor to others. */
  volatile boolean hangsInSetUp;

  /** Ends the match at the next tick. */
  volatile boolean over;

  int failEvery;
  boolean failInJoin;
  Runnable whileJoining = () -> {};
  int joins;
  int leaves;
  int inputs;
  private Archetype ball;
  EventKind shout;

  TestGame(int balls) {
    super("test");
    this.balls = balls;
  }

  /** Longer than one chunk when packed, so that loading takes several. */
  static Level level() {
    Random random = new Random(1);
    StringBuilder blank = new StringBuilder();
    for (int i = 0; i < 30_000; i++) {
      blank.append(" \n\t\r".charAt(random.nextInt(4)));
    }
    return parse(LEVEL + blank);
  }

  /** Fits one chunk. */
  static Level shortLevel() {
    return parse(LEVEL);
  }

  private static Level parse(String json) {
    try {
      return Level.parse("test.json", json.getBytes(StandardCharsets.UTF_8));
    } catch (LevelException e) {
      throw new AssertionError(e);
    }
  }

  @Override
  public void setUp(SetUp s) {
    while (hangsInSetUp) {
      LockSupport.parkNanos(1_000_000);
    }
    ball = s.archetype(new ArchetypeDef("ball").shape(new Circle(0.4f), new Material(1, 0, 1)));
    shout = s.event("shout", 0xffffff, 0, "");
  }

  @Override
  public void begin(Match s) {
    for (int i = 0; i < balls; i++) {
      float x = crowded ? -7 + 0.79f * (i % 20) : -500 + 2 * (i % 64);
      int row = i / (crowded ? 20 : 64);
      float y = crowded ? -27 + 0.79f * row : 10 + 2 * row;
      s.spawn(ball, x, y);
    }
  }

  @Override
  public List<Field<?>> fields() {
    return List.of(MARK, ACTIONS);
  }

  @Override
  public void join(Match s, Player p) {
    joins++;
    whileJoining.run();
    if (failInJoin) {
      throw new IllegalStateException("join fails on purpose");
    }
    if (teamsHide) {
      s.team(p, 1 + p.id() % 2);
    }
    s.spawn(ball, 3 * p.id(), -20, 0, p);
    p.set(MARK, 77);
  }

  @Override
  public void leave(Match s, Player p) {
    leaves++;
  }

  @Override
  public void input(Simulation s, Player p, Input in) {
    inputs++;
    p.entity().setVelocity(SPEED * in.moveX(), SPEED * in.moveY());
    if (in.held(Input.ACTION)) {
      p.add(ACTIONS, 1);
      if (teamsHide) {
        s.emit(shout).at(p.entity().x(), p.entity().y()).by(p);
      }
    }
  }

  @Override
  public boolean keepsMore() {
    Error error = keepsMoreFails.get();
    if (error != null) {
      throw error;
    }
    return keepsMore;
  }

  @Override
  public boolean relaysAhead() {
    return relaysAhead;
  }

  @Override
  public Audience audience(Match s, Entity e) {
    boolean isBody = e.owner() != null;
    return teamsHide && isBody ? Audience.TEAM : Audience.NEAR;
  }

  @Override
  public void beforeStep(Match s) {
    while (hangs) {
      LockSupport.parkNanos(1_000_000);
    }
    while (loops) {
      Thread.onSpinWait();
    }
    if (ballsMove) {
      for (int i = 0; i < balls; i++) {
        float way = (s.tick() / 60 + i) % 2 == 0 ? 1 : -1;
        s.entity(i).setVelocity(0, way * (1 + i % 7));
      }
    }
  }

  @Override
  public void afterStep(Match s) {
    if (over) {
      over = false;
      s.matchOver();
    }
    for (Player p : s.players()) {
      if (p.get(ACTIONS) != s.score(p)) {
        s.score(p, p.get(ACTIONS));
      }
    }
    if (failEvery > 0 && s.tick() % failEvery == 0) {
      throw new IllegalStateException("fails on purpose");
    }
  }
}

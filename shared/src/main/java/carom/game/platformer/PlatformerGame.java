package carom.game.platformer;

import static carom.sim.event.Audience.ALL;
import static carom.sim.event.Audience.NOBODY;
import static carom.sim.event.Audience.OWNER;
import static carom.sim.field.Scope.MATCH;

import carom.physics.Body;
import carom.physics.BodyContactVisitor;
import carom.physics.BodyType;
import carom.physics.Collision;
import carom.physics.Material;
import carom.physics.WorldDef;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Polygon;
import carom.sim.Game;
import carom.sim.Role;
import carom.sim.Simulation;
import carom.sim.entity.Entity;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.event.EventKind;
import carom.sim.event.Sound;
import carom.sim.field.Count;
import carom.sim.field.Countdown;
import carom.sim.field.EntityRef;
import carom.sim.field.Field;
import carom.sim.field.Flag;
import carom.sim.level.Appearance;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import carom.sim.match.MatchClock;
import carom.sim.match.MatchPhase;
import java.util.List;

/**
 * The platformer, seen from the side: run, jump, collect coins, be first at the flag. The flag is
 * worth {@value #FLAG_POINTS} coins and then moves to another place. The first player with {@value
 * #POINTS_TO_WIN} points wins, or the one that leads after {@value #MATCH_SECONDS} s; then the
 * room's next match begins.
 *
 * <p>Jumping forgives. It still works shortly after leaving an edge (coyote time), it already
 * counts shortly before landing (jump buffer), and releasing the button early makes a small jump.
 * Players move relative to the body they stand on, so moving platforms carry them. Down drops
 * through one-way platforms.
 *
 * <p>Players are dynamic bodies, not {@link carom.physics.mover.Mover}s: they stand on each other,
 * push crates and are pushed, and clients predict that with the engine's own solver. A mover in
 * {@link #input} would see the level's geometry only.
 *
 * <p>A level needs spawns {@code player}, where players also come back, and spawns {@code coin} and
 * {@code flag}. A player who falls below the bounds is back at the nearest spawn a second later.
 */
public final class PlatformerGame implements Game {
  /** Number of points that win a match. */
  public static final int POINTS_TO_WIN = 60;

  /** Longest match, seconds. */
  public static final float MATCH_SECONDS = 600;

  /** Number of points for the flag. A coin is 1 point. */
  public static final int FLAG_POINTS = 10;

  /** Running speed, m/s. */
  public static final float SPEED = 8;

  /** Speed at the start of a jump, m/s. */
  public static final float JUMP_SPEED = 13;

  /** Width of a player, metres. */
  public static final float PLAYER_WIDTH = 0.8f;

  /** Height of a player, metres. The body's origin is in the middle. */
  public static final float PLAYER_HEIGHT = 1.4f;

  private static final float GROUND_STEER = 16; // k / mass, 1/s
  private static final float AIR_STEER = 6;
  private static final float AIR_DRAG = 2; // 1/s, without a direction

  /** Extra gravity while a player rises with the button released, m/s^2. */
  private static final float CUT_GRAVITY = 30;

  private static final float MAX_FALL = 18;
  private static final float COYOTE_SECONDS = 0.1f;
  private static final float BUFFER_SECONDS = 0.12f;
  private static final float DROP_SECONDS = 0.2f;
  private static final float RESPAWN_SECONDS = 1;
  private static final float COIN_SECONDS = 10;
  private static final float FLAG_SECONDS = 4;
  private static final int[] COLORS = {
    0xef476f, 0xffd166, 0x06d6a0, 0x4cc9f0, 0xb388eb, 0xf78c6b, 0x9ef01a, 0xff9ebb
  };

  private static final int MAX_COINS = 1_024;

  private static final MatchClock CLOCK = MatchClock.playing(MATCH_SECONDS);

  // Of a player. Input writes them, so that clients predict jumps.
  private static final Count CAN_JUMP = Field.count("canJump", 0, 1_000); // ticks after an edge
  private static final Countdown WANTS_JUMP = Field.countdown("wantsJump"); // also before landing
  private static final Countdown DROPS = Field.countdown("drops"); // one-way platforms don't hold
  private static final Flag JUMPING = Field.flag("jumping");
  private static final Flag JUMP_HELD = Field.flag("jumpHeld"); // the button, a tick ago

  // Of a player without a body: when and at which spawn it comes back.
  private static final Countdown RESPAWN = Field.countdown("respawn").to(OWNER);
  private static final Count RESPAWN_PLACE = Field.count("respawnPlace", 0, 65_535).to(NOBODY);

  // Of the match.
  private static final EntityRef FLAG = Field.entity("flag").of(MATCH).to(ALL);
  private static final Count FLAG_PLACE = Field.count("flagPlace", 0, 65_535).of(MATCH).to(NOBODY);
  private static final Countdown FLAG_WAIT = Field.countdown("flagWait").of(MATCH).to(ALL);
  private static final EntityRef COIN = Field.entity("coin").of(MATCH).to(NOBODY).times(MAX_COINS);
  private static final Countdown COIN_WAIT =
      Field.countdown("coinWait").of(MATCH).to(NOBODY).times(MAX_COINS);

  private final Archetype[] kinds = new Archetype[COLORS.length];

  /**
   * Largest upward part of the normal from the player to a contact that counts as ground: slopes up
   * to 53 degrees. The player's bevelled edge (50 degrees) counts, or a player wedged between
   * crates could not jump.
   */
  private static final float MAX_GROUND_NORMAL = -0.6f;

  private final BodyContactVisitor<Entity> groundFinder = this::findGround;
  private EventKind jumpEvent;
  private EventKind coinEvent;
  private EventKind flagEvent;
  private EventKind fallEvent;
  private Archetype coin;
  private Archetype flag;
  private List<Level.Spawn> coins = List.of();
  private List<Level.Spawn> flags = List.of();
  private List<Level.Spawn> places = List.of();

  private float groundImpulse;
  private float groundX;
  private float groundY;
  private boolean groundOneWay;

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
    return List.of(
        CAN_JUMP,
        WANTS_JUMP,
        DROPS,
        JUMPING,
        JUMP_HELD,
        RESPAWN,
        RESPAWN_PLACE,
        FLAG,
        FLAG_PLACE,
        FLAG_WAIT,
        COIN,
        COIN_WAIT);
  }

  @Override
  public void setUp(Simulation s) {
    // No friction: walls must not hold a jumper, and the drive below brakes better than friction.
    Material skin = new Material(1.2f, 0, 0);
    for (int i = 0; i < COLORS.length; i++) {
      kinds[i] =
          s.archetypes()
              .add(
                  new ArchetypeDef("player." + i)
                      .shape(figure(), skin)
                      .fixedRotation(true)
                      .appearance(Appearance.of(COLORS[i], Appearance.Look.PLAYER)));
    }
    coin =
        s.archetypes()
            .add(
                new ArchetypeDef("coin")
                    .type(BodyType.STATIC)
                    .sensor(true)
                    .shape(new Circle(0.3f), skin)
                    .appearance(Appearance.of(0xffd166, Appearance.Look.COIN)));
    flag =
        s.archetypes()
            .add(
                new ArchetypeDef("flag")
                    .type(BodyType.STATIC)
                    .sensor(true)
                    .shape(Polygon.of(-0.4f, -0.7f, -0.25f, -0.7f, 0.7f, 0.35f, -0.4f, 0.8f), skin)
                    .appearance(Appearance.of(0xff4d6d, Appearance.Look.PLAIN)));
    jumpEvent = s.eventKinds().add("jump", 0xffffff, 0.6f, "", Sound.HOP, 0);
    coinEvent = s.eventKinds().add("coin", 0xffd166, 0.8f, "+1", Sound.CHIME, 0);
    flagEvent = s.eventKinds().add("flag", 0xff4d6d, 3, "+" + FLAG_POINTS, Sound.FANFARE, 0);
    fallEvent = s.eventKinds().add("fall", 0xef476f, 2, "", Sound.DROP, 0);
    coins = s.level().spawns("coin");
    flags = s.level().spawns("flag");
    places = s.level().spawns("player");
    if (places.isEmpty() || flags.isEmpty()) {
      throw new IllegalArgumentException(
          "level \""
              + s.level().name()
              + "\" can't be played as platformer: it needs spawns named \"player\" and \"flag\"");
    }
    if (coins.size() > MAX_COINS) {
      throw new IllegalArgumentException(
          "level \"" + s.level().name() + "\" has coins=" + coins.size() + ", limit " + MAX_COINS);
    }
    if (s.role() == Role.AUTHORITY) {
      for (int i = 0; i < coins.size(); i++) {
        placeCoin(s, i);
      }
      placeFlag(s);
    }
  }

  /** Returns a box whose corners are cut, so that it glides over seams and edges. */
  private static Polygon figure() {
    float w = PLAYER_WIDTH / 2;
    float h = PLAYER_HEIGHT / 2;
    return Polygon.of(
        -w,
        h - 0.12f,
        -w,
        -h + 0.12f,
        -w + 0.1f,
        -h,
        w - 0.1f,
        -h,
        w,
        -h + 0.12f,
        w,
        h - 0.12f,
        w - 0.12f,
        h,
        -w + 0.12f,
        h);
  }

  @Override
  public void join(Simulation s, Player p) {
    giveBody(s, p, p.id() % places.size());
  }

  @Override
  public void input(Simulation s, Player p, Input in) {
    Body<Entity> body = p.body().body();
    groundImpulse = 0;
    groundX = 0;
    groundY = 0;
    groundOneWay = false;
    body.forEachContact(groundFinder);
    boolean held = in.held(Input.JUMP);
    boolean jumping = p.get(JUMPING) && body.velocityY() > groundY;
    boolean grounded = groundImpulse > 0 && !jumping;

    if (grounded) {
      p.set(CAN_JUMP, s.ticks(COYOTE_SECONDS));
    } else {
      p.add(CAN_JUMP, -1);
    }
    if (held && !p.get(JUMP_HELD)) {
      p.set(WANTS_JUMP, s.ticks(BUFFER_SECONDS));
    }
    if ((in.held(Input.DOWN) || in.moveY() < -0.6f) && grounded && groundOneWay) {
      p.set(DROPS, s.ticks(DROP_SECONDS));
      p.set(CAN_JUMP, 0);
    }
    if (p.get(WANTS_JUMP) > 0 && p.get(CAN_JUMP) > 0) {
      p.set(WANTS_JUMP, 0);
      p.set(CAN_JUMP, 0);
      jumping = true;
      body.setVelocity(body.velocityX(), JUMP_SPEED + Math.max(0, groundY));
      s.emit(jumpEvent).at(body.x(), body.y() - PLAYER_HEIGHT / 2).of(p.body()).by(p);
    } else if (jumping && !held) {
      body.applyForce(0, -CUT_GRAVITY * body.mass());
    }
    p.set(JUMPING, jumping);
    p.set(JUMP_HELD, held);

    float steer = grounded ? GROUND_STEER : in.moveX() == 0 ? AIR_DRAG : AIR_STEER;
    float goal = in.moveX() * SPEED + groundX;
    body.applyForce(steer * body.mass() * (goal - body.velocityX()), 0);
    if (body.velocityY() < -MAX_FALL) {
      body.setVelocity(body.velocityX(), -MAX_FALL);
    }
  }

  private void findGround(Body<Entity> other, float normalX, float normalY, float impulse) {
    if (normalY < MAX_GROUND_NORMAL && impulse > groundImpulse) {
      groundImpulse = impulse;
      groundX = other.velocityX();
      groundY = other.velocityY();
      groundOneWay = other.user().archetype().oneWay();
    }
  }

  @Override
  public boolean collision(Simulation s, Collision<Entity> c) {
    if (drops(s, c.self().user(), c.other().user())
        || drops(s, c.other().user(), c.self().user())) {
      return false;
    }
    return ONE_WAY.preSolve(c);
  }

  private static boolean drops(Simulation s, Entity rider, Entity platform) {
    if (!platform.archetype().oneWay()) {
      return false;
    }
    Player p = s.owner(rider);
    return p != null && p.body() == rider && p.get(DROPS) > 0;
  }

  @Override
  public void beforeStep(Simulation s) {
    for (int i = 0; i < coins.size(); i++) {
      if (s.get(COIN, i) == null && s.get(COIN_WAIT, i) == 0) {
        placeCoin(s, i);
      }
    }
    if (s.get(FLAG) == null && s.get(FLAG_WAIT) == 0) {
      placeFlag(s);
    }
    for (int id = 0; id < s.playerCapacity(); id++) {
      Player p = s.player(id);
      if (p != null && p.body() == null && p.get(RESPAWN) == 0) {
        giveBody(s, p, p.get(RESPAWN_PLACE));
      }
    }
  }

  @Override
  public void afterStep(Simulation s) {
    for (int id = 0; id < s.playerCapacity(); id++) {
      Player p = s.player(id);
      if (p == null || p.body() == null) {
        continue;
      }
      Body<Entity> body = p.body().body();
      if (!insideSidesAndFloor(s, body)) {
        int place = nearestPlace(body.x(), body.y());
        s.emit(fallEvent).at(body.x(), body.y()).by(p);
        s.despawn(p.body());
        p.set(RESPAWN, s.ticks(RESPAWN_SECONDS));
        p.set(RESPAWN_PLACE, place);
      }
    }
    for (int id = 0; id < s.level().bodies().size(); id++) {
      Body<Entity> body = s.entity(id).body();
      if (body.type() == BodyType.DYNAMIC && !insideSidesAndFloor(s, body)) {
        Level.Placement home = s.level().bodies().get(id);
        s.entity(id).teleport(home.x(), home.y(), home.angle());
        body.setVelocity(0, 0);
        body.setAngularVelocity(0);
      }
    }
  }

  /**
   * Returns whether a body is inside the bounds but for their upper edge. A player may jump out of
   * that edge, because gravity brings it back.
   */
  private static boolean insideSidesAndFloor(Simulation s, Body<Entity> body) {
    Level.Bounds b = s.level().bounds();
    return body.x() >= b.minX() && body.x() <= b.maxX() && body.y() >= b.minY();
  }

  @Override
  public void entered(Simulation s, Entity sensor, Entity visitor) {
    Player p = s.owner(visitor);
    if (p == null || p.body() != visitor || !MatchClock.isPlaying(s)) {
      return;
    }
    float x = sensor.body().x();
    float y = sensor.body().y();
    if (sensor.archetype() == coin) {
      int place = placeOf(s, sensor);
      s.emit(coinEvent).at(x, y).of(visitor).by(p).data(place);
      s.despawn(sensor);
      s.set(COIN_WAIT, place, s.ticks(COIN_SECONDS));
      award(s, p, 1);
    } else if (sensor.archetype() == flag) {
      s.emit(flagEvent).at(x, y).of(visitor).by(p).to(ALL);
      s.despawn(sensor);
      s.set(FLAG_WAIT, s.ticks(FLAG_SECONDS));
      s.notice(p.name() + " got the flag: +" + FLAG_POINTS);
      award(s, p, FLAG_POINTS);
    }
  }

  private int placeOf(Simulation s, Entity coin) {
    int place = 0;
    while (s.get(COIN, place) != coin) {
      place++;
    }
    return place;
  }

  private static void award(Simulation s, Player p, int points) {
    p.score(p.score() + points);
    if (p.score() >= POINTS_TO_WIN) {
      CLOCK.finish(s, p);
    }
  }

  @Override
  public MatchClock clock() {
    return CLOCK;
  }

  @Override
  public void phase(Simulation s, MatchPhase now) {
    if (now == MatchPhase.OVER) {
      Player best = s.leader();
      CLOCK.decide(s, best, 0);
      s.notice(best == null ? "A draw!" : best.name() + " wins with " + best.score() + " points!");
    }
  }

  private void placeCoin(Simulation s, int i) {
    Level.Spawn spot = coins.get(i);
    s.set(COIN, i, s.spawn(coin, spot.x(), spot.y(), 0, null));
  }

  /** Puts the flag at another place than last time. */
  private void placeFlag(Simulation s) {
    if (flags.size() > 1) {
      int further = 1 + s.random().nextInt(flags.size() - 1);
      s.set(FLAG_PLACE, (s.get(FLAG_PLACE) + further) % flags.size());
    }
    Level.Spawn spot = flags.get(s.get(FLAG_PLACE));
    s.set(FLAG, s.spawn(flag, spot.x(), spot.y(), 0, null));
  }

  private int nearestPlace(float x, float y) {
    int nearest = 0;
    float best = Float.MAX_VALUE;
    for (int i = 0; i < places.size(); i++) {
      float dx = places.get(i).x() - x;
      float dy = places.get(i).y() - y;
      if (dx * dx + dy * dy < best) {
        best = dx * dx + dy * dy;
        nearest = i;
      }
    }
    return nearest;
  }

  /** Gives a player a body at a spawn, above any player who stands there already. */
  private void giveBody(Simulation s, Player p, int place) {
    Level.Spawn spot = places.get(place);
    p.resetFields();
    float y = spot.y();
    for (int i = 0; i < 5 && !isFree(s, spot.x(), y); i++) {
      y += PLAYER_HEIGHT + 0.1f;
    }
    s.spawn(kinds[p.id() % kinds.length], spot.x(), y, 0, p);
  }

  private static boolean isFree(Simulation s, float x, float y) {
    for (int id = 0; id < s.playerCapacity(); id++) {
      Player p = s.player(id);
      if (p != null
          && p.body() != null
          && Math.abs(p.body().body().x() - x) < PLAYER_WIDTH
          && Math.abs(p.body().body().y() - y) < PLAYER_HEIGHT) {
        return false;
      }
    }
    return true;
  }
}

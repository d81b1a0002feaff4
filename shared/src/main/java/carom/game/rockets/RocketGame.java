package carom.game.rockets;

import static carom.sim.event.Audience.ALL;
import static carom.sim.event.Audience.NOBODY;
import static carom.sim.field.Scope.ENTITY;

import carom.physics.Body;
import carom.physics.BodyContactVisitor;
import carom.physics.BodyType;
import carom.physics.BodyVisitor;
import carom.physics.Collision;
import carom.physics.Material;
import carom.physics.geometry.Circle;
import carom.physics.math.Trig;
import carom.sim.Game;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.Input;
import carom.sim.entity.HostPlayer;
import carom.sim.event.EventKind;
import carom.sim.event.Sound;
import carom.sim.field.Cooldown;
import carom.sim.field.Count;
import carom.sim.field.Countdown;
import carom.sim.field.Field;
import carom.sim.field.Flag;
import carom.sim.gauge.Gauge;
import carom.sim.level.Appearance;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import carom.sim.match.MatchClock;
import carom.sim.match.MatchPhase;
import carom.sim.spawn.Origin;
import java.util.List;

/**
 * Players shoot rockets at each other, seen from above, and watch others while they are out. The
 * match begins when two or more are there and all are ready; before, they may practise. The first
 * with {@value #HITS_TO_WIN} hits wins, or the one that leads after {@value #MATCH_SECONDS} s.
 *
 * <p>{@link Input#ACTION} fires a rocket along the aim, {@link Input#SECOND} sets off all that fly.
 * A rocket goes off when it touches something or its fuel is used up; what is near is pushed away,
 * and players lose health.
 *
 * <p>{@code input} fires rockets and removes those that are spent, so a player sees both at once.
 * What the blast does to others is for {@code afterStep}, a moment before: both ask {@link
 * #isSpent}, which depends on nothing but the state between two ticks.
 *
 * <p>A level needs spawns {@code player}.
 */
public final class RocketGame implements Game {
  /** Speed of a player, m/s. */
  public static final float SPEED = 7;

  /** Speed of a rocket, m/s. */
  public static final float ROCKET_SPEED = 20;

  /** Number of players to hit in order to win a match. */
  public static final int HITS_TO_WIN = 10;

  /** Longest match, seconds. */
  public static final float MATCH_SECONDS = 240;

  /** Time from a hit until the player is back, long enough to look on. */
  public static final float RESPAWN_SECONDS = 4;

  private static final MatchClock CLOCK =
      MatchClock.playing(MATCH_SECONDS).warmUp(2).whenReady().countdown(3);

  private static final float STEER = 12; // 1/s
  private static final float FUEL_SECONDS = 2;
  private static final float MUZZLE = 0.75f;
  private static final float BLAST_RADIUS = 3;
  private static final float BLAST_SPEED = 9;
  private static final int DAMAGE = 45;

  // Of a player. Input writes the first two, so that clients predict shots.
  private static final Countdown RELOAD = Field.countdown("reload");
  private static final Flag SETS_OFF = Field.flag("setsOff"); // wants its rockets to go off
  private static final Count HEALTH = Field.count("health", 0, 100).to(ALL).startsAt(100);
  private static final Countdown OUT = Field.countdown("out").to(NOBODY); // until it is back

  // Of a rocket.
  private static final Countdown FUEL = Field.countdown("fuel").of(ENTITY);

  private final String name;
  private final float reloadSeconds;
  private final BodyContactVisitor<HostEntity> touch = this::touch;
  private final BodyVisitor<HostEntity> push = this::push;
  private Archetype player;
  private Archetype rocket;
  private EventKind shot;
  private EventKind boom;
  private int ownerOfTouching;
  private boolean touches;
  private Body<HostEntity> blast;

  /** Creates the game, for the service loader. */
  public RocketGame() {
    this("rockets", 0.5f);
  }

  /**
   * Creates a variant of the game.
   *
   * @param name of the variant
   * @param reloadSeconds time from shot to shot
   */
  public RocketGame(String name, float reloadSeconds) {
    this.name = name;
    this.reloadSeconds = reloadSeconds;
  }

  @Override
  public String name() {
    return name;
  }

  @Override
  public String defaultLevel() {
    return "rockets";
  }

  @Override
  public String description() {
    return "shoot rockets at each other: Space fires, E sets off what flies";
  }

  @Override
  public List<Cooldown> cooldowns() {
    return List.of(new Cooldown("rocket", RELOAD, reloadSeconds));
  }

  @Override
  public List<Gauge> gauges() {
    return List.of(Gauge.bar("health", HEALTH), Gauge.overHeads("health", HEALTH));
  }

  @Override
  public List<Field<?>> fields() {
    return List.of(RELOAD, SETS_OFF, HEALTH, OUT, FUEL);
  }

  @Override
  public void setUp(SimulationHost s) {
    player =
        s.archetypes()
            .add(
                new ArchetypeDef("player")
                    .shape(new Circle(0.5f), new Material(1, 0.3f, 0.2f))
                    .fixedRotation(true)
                    .appearance(Appearance.of(0x4cc9f0, Appearance.Look.PLAYER)));
    rocket =
        s.archetypes()
            .add(
                new ArchetypeDef("rocket")
                    .shape(new Circle(0.16f), new Material(0.5f, 0, 0))
                    .fixedRotation(true)
                    .appearance(Appearance.of(0xffd166, Appearance.Look.BALL)));
    shot = s.eventKinds().add("shot", 0xffd166, 0.6f, "", Sound.WHOOSH, 0);
    boom = s.eventKinds().add("boom", 0xff9f1c, BLAST_RADIUS, "", Sound.KNOCK, 0);
    if (s.level().spawns("player").isEmpty()) {
      throw new IllegalArgumentException(
          "level \"" + s.level().name() + "\" can't be played: it needs a spawn \"player\"");
    }
  }

  @Override
  public void join(SimulationHost s, HostPlayer p) {
    List<Level.Spawn> spots = s.level().spawns("player");
    Level.Spawn spot = spots.get(p.id() % spots.size());
    p.set(HEALTH, HEALTH.max());
    s.spawn(player, spot.x(), spot.y(), 0, p);
  }

  @Override
  public void input(SimulationHost s, HostPlayer p, Input in) {
    Body<HostEntity> body = p.body().body();
    body.seekVelocity(in.moveX() * SPEED, in.moveY() * SPEED, STEER * body.mass());
    for (int i = p.spawnedCount() - 1; i >= 0; i--) {
      HostEntity fired = p.spawned(i);
      if (isSpent(p, fired, 0)) {
        s.emit(boom).at(fired.body().x(), fired.body().y()).of(fired).by(p);
        s.despawn(fired);
      }
    }
    p.set(SETS_OFF, in.held(Input.SECOND));
    boolean mayFire = p.get(RELOAD) == 0 && p.spawnedCount() < Origin.MOST_PER_PLAYER;
    if (in.held(Input.ACTION) && mayFire) {
      p.set(RELOAD, s.ticks(reloadSeconds));
      fire(s, p, Trig.cos(in.aim()), Trig.sin(in.aim()));
    }
  }

  private void fire(SimulationHost s, HostPlayer p, float wayX, float wayY) {
    float x = p.body().body().x() + MUZZLE * wayX;
    float y = p.body().body().y() + MUZZLE * wayY;
    HostEntity fired = s.spawn(rocket, x, y, 0, p);
    fired.body().setVelocity(ROCKET_SPEED * wayX, ROCKET_SPEED * wayY);
    fired.set(FUEL, s.ticks(FUEL_SECONDS));
    s.emit(shot).at(x, y).by(p);
  }

  /**
   * Returns whether a rocket goes off in a tick's input.
   *
   * @param ticksUntil ticks until that tick's input: 0 in it, 1 in the tick before
   */
  private boolean isSpent(HostPlayer p, HostEntity fired, int ticksUntil) {
    touches = false;
    ownerOfTouching = fired.ownerId();
    fired.body().forEachContact(touch);
    return touches || p.get(SETS_OFF) || fired.get(FUEL) <= ticksUntil;
  }

  private void touch(Body<HostEntity> other, float normalX, float normalY, float impulse) {
    touches |= other.user().ownerId() != ownerOfTouching;
  }

  /** Rockets pass through their player and through each other. */
  @Override
  public boolean collision(SimulationHost s, Collision<HostEntity> c) {
    int owner = c.self().user().ownerId();
    return owner == HostEntity.NO_OWNER || owner != c.other().user().ownerId();
  }

  @Override
  public void afterStep(SimulationHost s) {
    for (int id = 0; id < s.playerCapacity(); id++) {
      HostPlayer p = s.player(id);
      if (p == null) {
        continue;
      }
      boolean isOut = p.body() == null; // then no input goes on with its rockets
      for (int i = p.spawnedCount() - 1; i >= 0; i--) {
        HostEntity fired = p.spawned(i);
        if (isOut || isSpent(p, fired, 1)) {
          goOff(s, p, fired);
        }
        if (isOut) {
          s.despawn(fired);
        }
      }
      if (p.body() == null && isOut && p.get(OUT) == 0 && !p.isSpectator()) {
        join(s, p);
      }
    }
  }

  /** Pushes what is near a rocket, and takes health from players. */
  private void goOff(SimulationHost s, HostPlayer p, HostEntity fired) {
    blast = fired.body();
    float x = blast.x();
    float y = blast.y();
    s.world()
        .queryAabb(x - BLAST_RADIUS, y - BLAST_RADIUS, x + BLAST_RADIUS, y + BLAST_RADIUS, push);
    for (int id = 0; id < s.playerCapacity(); id++) {
      HostPlayer other = s.player(id);
      if (other == null || other == p || other.body() == null || force(other.body().body()) == 0) {
        continue;
      }
      other.add(HEALTH, -Math.round(DAMAGE * force(other.body().body())));
      if (other.get(HEALTH) == 0) {
        score(s, p);
        other.set(OUT, s.ticks(RESPAWN_SECONDS));
        s.despawn(other.body());
      }
    }
  }

  private static void score(SimulationHost s, HostPlayer p) {
    if (MatchClock.phase(s) == MatchPhase.OVER) {
      return;
    }
    p.score(p.score() + 1);
    if (p.score() >= HITS_TO_WIN) {
      CLOCK.finish(s, p);
    }
  }

  @Override
  public MatchClock clock() {
    return CLOCK;
  }

  @Override
  public void phase(SimulationHost s, MatchPhase now) {
    if (now == MatchPhase.OVER) {
      CLOCK.decide(s, s.leader(), 0);
    } else if (now == MatchPhase.PLAYING) {
      forgetPractice(s);
    }
  }

  private static void forgetPractice(SimulationHost s) {
    for (int id = 0; id < s.playerCapacity(); id++) {
      if (s.player(id) != null) {
        s.player(id).score(0);
        s.player(id).set(HEALTH, HEALTH.max());
      }
    }
  }

  /** Returns how much of a blast a body gets, 0..1. */
  private float force(Body<HostEntity> body) {
    float dx = body.centerX() - blast.x();
    float dy = body.centerY() - blast.y();
    return Math.max(0, 1 - (float) Math.sqrt(dx * dx + dy * dy) / BLAST_RADIUS);
  }

  private boolean push(Body<HostEntity> body) {
    float force = force(body);
    if (body.type() == BodyType.DYNAMIC && force > 0 && body.user().archetype() != rocket) {
      float dx = body.centerX() - blast.x();
      float dy = body.centerY() - blast.y();
      float scale =
          BLAST_SPEED * force * body.mass() / Math.max(0.1f, (float) Math.sqrt(dx * dx + dy * dy));
      body.applyImpulse(scale * dx, scale * dy);
    }
    return true;
  }
}

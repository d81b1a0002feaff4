package carom.game.rockets;

import static carom.sim.event.Audience.ALL;
import static carom.sim.event.Audience.NOBODY;
import static carom.sim.field.Scope.ENTITY;

import carom.physics.Material;
import carom.physics.geometry.Circle;
import carom.physics.math.Trig;
import carom.sim.Game;
import carom.sim.Match;
import carom.sim.MatchClock;
import carom.sim.MatchPhase;
import carom.sim.SetUp;
import carom.sim.Simulation;
import carom.sim.entity.Contact;
import carom.sim.entity.Entity;
import carom.sim.entity.EntityContactVisitor;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.event.EventKind;
import carom.sim.event.Sound;
import carom.sim.field.Cooldown;
import carom.sim.field.Count;
import carom.sim.field.Countdown;
import carom.sim.field.Field;
import carom.sim.field.Flag;
import carom.sim.field.Gauge;
import carom.sim.level.Appearance;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import java.util.List;
import java.util.function.Predicate;

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

  // Fields of a player. Input writes the first two, so that clients predict shots.
  private static final Countdown RELOAD = Field.countdown("reload");
  private static final Flag SETS_OFF = Field.flag("setsOff"); // wants its rockets to go off

  /** Health that a player has left. */
  public static final Count HEALTH = Field.count("health", 0, 100).to(ALL).startsAt(100);

  private static final Countdown OUT = Field.countdown("out").to(NOBODY); // until it is back

  // Of a rocket.
  private static final Countdown FUEL = Field.countdown("fuel").of(ENTITY);

  private final String name;
  private final float reloadSeconds;
  private final EntityContactVisitor touch = this::touch;
  private final Predicate<Entity> push = this::push;
  private Archetype player;
  private Archetype rocket;
  private EventKind shot;
  private EventKind boom;
  private Entity touching;
  private boolean touches;
  private Entity blast;

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
  public void setUp(SetUp s) {
    player =
        s.archetype(
            new ArchetypeDef("player")
                .shape(new Circle(0.5f), new Material(1, 0.3f, 0.2f))
                .fixedRotation(true)
                .appearance(Appearance.of(0x4cc9f0, Appearance.Look.PLAYER)));
    rocket =
        s.archetype(
            new ArchetypeDef("rocket")
                .shape(new Circle(0.16f), new Material(0.5f, 0, 0))
                .fixedRotation(true)
                .appearance(Appearance.of(0xffd166, Appearance.Look.BALL)));
    shot = s.event("shot", 0xffd166, 0.6f, "", Sound.WHOOSH, 0);
    boom = s.event("boom", 0xff9f1c, BLAST_RADIUS, "", Sound.KNOCK, 0);
    if (s.level().spawns("player").isEmpty()) {
      throw new IllegalArgumentException(
          "level \"" + s.level().name() + "\" can't be played: it needs a spawn \"player\"");
    }
  }

  @Override
  public void join(Match m, Player p) {
    List<Level.Spawn> spots = m.level().spawns("player");
    Level.Spawn spot = spots.get(p.id() % spots.size());
    p.set(HEALTH, HEALTH.max());
    m.spawn(player, spot.x(), spot.y(), 0, p);
  }

  @Override
  public void input(Simulation s, Player p, Input in) {
    p.entity().seekVelocity(in.moveX() * SPEED, in.moveY() * SPEED, STEER);
    for (int i = p.spawnedCount() - 1; i >= 0; i--) {
      Entity fired = p.spawned(i);
      if (isSpent(p, fired, 0)) {
        s.emit(boom).at(fired.x(), fired.y()).of(fired).by(p);
        fired.despawn();
      }
    }
    p.set(SETS_OFF, in.held(Input.SECOND));
    boolean mayFire = p.get(RELOAD) == 0 && !p.isFull();
    if (in.held(Input.ACTION) && mayFire) {
      p.set(RELOAD, s.ticks(reloadSeconds));
      fire(s, p, Trig.cos(in.aim()), Trig.sin(in.aim()));
    }
  }

  private void fire(Simulation s, Player p, float wayX, float wayY) {
    float x = p.entity().x() + MUZZLE * wayX;
    float y = p.entity().y() + MUZZLE * wayY;
    Entity fired = p.spawn(rocket, x, y, 0);
    fired.setVelocity(ROCKET_SPEED * wayX, ROCKET_SPEED * wayY);
    fired.set(FUEL, s.ticks(FUEL_SECONDS));
    s.emit(shot).at(x, y).by(p);
  }

  /**
   * Returns whether a rocket goes off in a tick's input.
   *
   * @param ticksUntil ticks until that tick's input: 0 in it, 1 in the tick before
   */
  private boolean isSpent(Player p, Entity fired, int ticksUntil) {
    touches = false;
    touching = fired;
    fired.forEachContact(touch);
    return touches || p.get(SETS_OFF) || fired.get(FUEL) <= ticksUntil;
  }

  private void touch(Entity other, float normalX, float normalY, float impulse) {
    touches |= !other.isOfSameOwner(touching);
  }

  /** Rockets pass through their player and through each other. */
  @Override
  public boolean collision(Simulation s, Contact c) {
    return !c.self().isOfSameOwner(c.other());
  }

  @Override
  public void afterStep(Match m) {
    for (Player p : m.players()) {
      boolean isOut = !p.isAlive(); // then no input goes on with its rockets
      for (int i = p.spawnedCount() - 1; i >= 0; i--) {
        Entity fired = p.spawned(i);
        if (isOut || isSpent(p, fired, 1)) {
          goOff(m, p, fired);
        }
        if (isOut) {
          fired.despawn();
        }
      }
      if (!p.isAlive() && isOut && p.get(OUT) == 0) {
        join(m, p);
      }
    }
  }

  /** Pushes what is near a rocket, and takes health from players. */
  private void goOff(Match m, Player p, Entity fired) {
    blast = fired;
    float x = blast.x();
    float y = blast.y();
    m.forEachInBox(x - BLAST_RADIUS, y - BLAST_RADIUS, x + BLAST_RADIUS, y + BLAST_RADIUS, push);
    for (Player other : m.players()) {
      if (other == p || !other.isAlive() || force(other.entity()) == 0) {
        continue;
      }
      other.add(HEALTH, -Math.round(DAMAGE * force(other.entity())));
      if (other.get(HEALTH) == 0) {
        score(m, p);
        other.set(OUT, m.ticks(RESPAWN_SECONDS));
        other.entity().despawn();
      }
    }
  }

  private static void score(Match m, Player p) {
    if (MatchClock.phase(m) == MatchPhase.OVER) {
      return;
    }
    m.addScore(p, 1);
    if (m.score(p) >= HITS_TO_WIN) {
      CLOCK.finish(m, p);
    }
  }

  @Override
  public MatchClock clock() {
    return CLOCK;
  }

  @Override
  public void phase(Match m, MatchPhase now) {
    if (now == MatchPhase.OVER) {
      CLOCK.decide(m, m.leader(), 0);
    } else if (now == MatchPhase.PLAYING) {
      for (Player p : m.players()) { // what was practised is forgotten
        m.score(p, 0);
        p.set(HEALTH, HEALTH.max());
      }
    }
  }

  /** Returns how much of a blast an entity gets, 0..1. */
  private float force(Entity e) {
    float dx = e.centerX() - blast.x();
    float dy = e.centerY() - blast.y();
    return Math.max(0, 1 - (float) Math.sqrt(dx * dx + dy * dy) / BLAST_RADIUS);
  }

  private boolean push(Entity e) {
    float force = force(e);
    if (e.isDynamic() && force > 0 && e.archetype() != rocket) {
      float dx = e.centerX() - blast.x();
      float dy = e.centerY() - blast.y();
      float scale =
          BLAST_SPEED * force * e.mass() / Math.max(0.1f, (float) Math.sqrt(dx * dx + dy * dy));
      e.applyImpulse(scale * dx, scale * dy);
    }
    return true;
  }
}

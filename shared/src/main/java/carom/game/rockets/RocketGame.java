package carom.game.rockets;

import static carom.game.rockets.RocketFields.AMMO;
import static carom.game.rockets.RocketFields.HEALTH;
import static carom.game.rockets.RocketFields.OUT;
import static carom.game.rockets.RocketFields.REPAIRS;
import static carom.game.rockets.RocketFields.SHIELDED;
import static carom.game.rockets.RocketFields.SPENT;
import static carom.game.rockets.RocketFields.WEAPON;

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
import carom.sim.field.Cooldown;
import carom.sim.field.Field;
import carom.sim.field.Gauge;
import carom.sim.level.Level;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;

/**
 * Players shoot rockets at each other, seen from above, and watch others while they are out. The
 * match begins when two or more are there and all are ready; before, they may practise. The first
 * with {@value #HITS_TO_WIN} hits wins, or the one that leads after {@value #MATCH_SECONDS} s.
 *
 * <p>{@link Input#ACTION} fires along the aim, {@link Input#SECOND} sets off all that flies, {@link
 * #SHIELD} holds up a shield that empties and fills again. A shot goes off when it touches
 * something or its fuel is used up; what is near is pushed away, players lose health, and rocks
 * break. Rocks hold repair kits and other weapons.
 *
 * <p>{@code input} moves, fires and shields, {@code rules} hand out what lies about, so a player
 * sees all of it at once. Blasts, health and rocks are the server's.
 *
 * <p>A level needs spawns {@code player}, and may have spawns {@code rock}.
 *
 * <pre>
 *   RocketGame       the order of a tick, and who wins
 *     RocketFields   the state that is saved, hashed and sent
 *     Sky            kinds of entities and events, the level's places
 *     Weapon         what shots do
 *     Shots          firing, flying, blasts
 *     Rocks          rocks that break, and what is in them
 * </pre>
 */
public final class RocketGame implements Game {
  /** Button that holds the shield up. */
  public static final int SHIELD = 1 << 5;

  /** Speed of a player, m/s. */
  public static final float SPEED = 8;

  /** Number of players to hit in order to win a match. */
  public static final int HITS_TO_WIN = 10;

  /** Longest match, seconds. */
  public static final float MATCH_SECONDS = 240;

  /** Time from a hit until the player is back, long enough to look on. */
  public static final float RESPAWN_SECONDS = 4;

  /** Time that a full shield is held up, seconds. */
  public static final float SHIELD_SECONDS = 2;

  /** Time in which an empty shield is full again, seconds. */
  public static final float SHIELD_FILL_SECONDS = 6;

  private static final MatchClock CLOCK =
      MatchClock.playing(MATCH_SECONDS).warmUp(2).whenReady().countdown(3);

  private static final float STEER = 6; // 1/s
  private static final int REPAIR = 50;

  private final String name;
  private final float reloadSeconds;
  private Sky sky;
  private Shots shots;
  private Rocks rocks;

  /** Creates the game, for the service loader. */
  public RocketGame() {
    this("rockets", Weapon.ROCKET.seconds);
  }

  /**
   * Creates a variant of the game.
   *
   * @param name of the variant
   * @param reloadSeconds time from rocket to rocket
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
    return "shoot rockets at each other among rocks: the first with ten hits wins";
  }

  @Override
  public List<Cooldown> cooldowns() {
    return List.of(
        new Cooldown("rocket", RocketFields.RELOAD, reloadSeconds),
        new Cooldown("shield", SPENT, SHIELD_FILL_SECONDS));
  }

  @Override
  public List<Gauge> gauges() {
    return List.of(
        Gauge.bar("health", HEALTH), Gauge.number("ammo", AMMO), Gauge.overHeads("health", HEALTH));
  }

  @Override
  public List<Field<?>> fields() {
    return RocketFields.all();
  }

  @Override
  public MatchClock clock() {
    return CLOCK;
  }

  @Override
  public void setUp(SetUp s) {
    sky = new Sky(s);
    rocks = new Rocks(sky);
    shots = new Shots(sky, rocks, reloadSeconds);
  }

  @Override
  public void begin(Match m) {
    rocks.begin(m);
  }

  @Override
  public void join(Match m, Player p) {
    giveBody(m, p, sky.places.get(p.id() % sky.places.size()));
  }

  private void giveBody(Match m, Player p, Level.Spawn spot) {
    p.set(HEALTH, HEALTH.max());
    p.set(WEAPON, Weapon.ROCKET);
    p.set(AMMO, 0);
    p.set(SPENT, 0);
    m.spawn(sky.player, spot.x(), spot.y(), 0, p);
  }

  @Override
  public void beforeStep(Match m) {
    rocks.beforeStep(m);
  }

  @Override
  public void input(Simulation s, Player p, Input in) {
    p.entity().seekVelocity(in.moveX() * SPEED, in.moveY() * SPEED, STEER);
    shield(s, p, in.held(SHIELD));
    shots.input(s, p, in);
  }

  /** Holds the shield up while there is some of it; what is below half must fill first. */
  private static void shield(Simulation s, Player p, boolean wants) {
    int full = s.ticks(SHIELD_FILL_SECONDS);
    int empties = Math.round(SHIELD_FILL_SECONDS / SHIELD_SECONDS) + 1; // it fills by 1 meanwhile
    boolean isUp = wants && p.get(SPENT) < (p.get(SHIELDED) ? full - empties : full / 2);
    if (isUp) {
      p.set(SPENT, p.get(SPENT) + empties);
    }
    p.set(SHIELDED, isUp);
  }

  @Override
  public Consumer<Rules> rules(Level level) {
    return r -> rocks.take(r);
  }

  @Override
  public void forces(Simulation s, Entity e) {
    shots.forces(e);
  }

  /** Shots pass through their player and through each other. */
  @Override
  public boolean collision(Simulation s, Contact c) {
    return !c.self().isOfSameOwner(c.other());
  }

  @Override
  public void afterStep(Match m) {
    for (Player p : m.players()) {
      boolean wasOut = !p.isAlive();
      shots.afterStep(m, p);
      if (wasOut && p.get(OUT) == 0) {
        giveBody(m, p, furthestPlace(m, p));
      }
    }
    for (Player p : m.players()) {
      if (p.get(REPAIRS)) {
        p.add(HEALTH, REPAIR);
        p.set(REPAIRS, false);
      }
      if (p.isAlive() && p.get(HEALTH) == 0) {
        wreck(m, p);
      }
    }
    rocks.afterStep(m);
  }

  /** Returns the place that is furthest from the others; the player's own one for the first. */
  private Level.Spawn furthestPlace(Match m, Player p) {
    Level.Spawn best = null;
    float most = -1;
    for (int i = 0; i < sky.places.size(); i++) {
      Level.Spawn spot = sky.places.get((p.id() + i) % sky.places.size());
      float nearest = Float.MAX_VALUE;
      for (Player other : m.players()) {
        if (other.isAlive()) {
          float dx = other.entity().x() - spot.x();
          float dy = other.entity().y() - spot.y();
          nearest = Math.min(nearest, dx * dx + dy * dy);
        }
      }
      if (nearest > most) {
        most = nearest;
        best = spot;
      }
    }
    return best;
  }

  private void wreck(Match m, Player p) {
    Entity body = p.entity();
    Player by = p.get(RocketFields.WRECKED_BY);
    m.emit(sky.wreck).at(body.x(), body.y()).of(body).by(p);
    body.despawn();
    p.set(OUT, m.ticks(RESPAWN_SECONDS));
    if (by == null || MatchClock.phase(m) == MatchPhase.OVER) {
      return;
    }
    m.addScore(by, 1);
    String weapon = p.get(RocketFields.WRECKED_WITH).name().toLowerCase(Locale.ROOT);
    m.notice(m.name(by) + " hit " + m.name(p) + ": " + weapon);
    if (m.score(by) >= HITS_TO_WIN && MatchClock.isPlaying(m)) {
      CLOCK.finish(m, by);
      m.notice(m.name(by) + " wins: the first with " + HITS_TO_WIN + " hits");
    }
  }

  @Override
  public void phase(Match m, MatchPhase now) {
    if (now == MatchPhase.PLAYING) {
      for (Player p : m.players()) { // what was practised is forgotten
        m.score(p, 0);
        p.set(HEALTH, HEALTH.max());
      }
    } else if (now == MatchPhase.OVER) {
      if (MatchClock.winner(m) < 0) {
        Player best = m.leader();
        CLOCK.decide(m, best, 0);
        m.notice(
            best == null
                ? "A draw: nobody leads after " + Math.round(MATCH_SECONDS / 60) + " minutes"
                : m.name(best) + " wins: the most hits, " + m.score(best));
      }
      Player winner = m.player(MatchClock.winner(m));
      if (winner != null) {
        winner.add(RocketFields.WINS, 1);
      }
    }
  }
}

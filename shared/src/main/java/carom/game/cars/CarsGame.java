package carom.game.cars;

import static carom.game.cars.CarsFields.GATE;
import static carom.game.cars.CarsFields.LAP;
import static carom.game.cars.CarsFields.NITRO;
import static carom.game.cars.CarsFields.OVER;
import static carom.game.cars.CarsFields.PLACE;

import carom.sim.Game;
import carom.sim.Match;
import carom.sim.MatchClock;
import carom.sim.MatchPhase;
import carom.sim.Rules;
import carom.sim.SetUp;
import carom.sim.Simulation;
import carom.sim.entity.Contact;
import carom.sim.entity.Entity;
import carom.sim.entity.EntityJoint;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.field.Field;
import carom.sim.field.Gauge;
import carom.sim.level.Level;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;

/**
 * A race of {@value #LAPS} laps. The first car through the tunnel at the end of the last lap wins;
 * after {@value #MATCH_SECONDS} seconds the one that has come furthest.
 *
 * <p>Movement to the sides drives and brakes, movement upwards and downwards leans back and
 * forwards, {@link Input#ACTION} burns nitro, {@link Input#SECOND} puts the car back at its last
 * gate. Rings, flights and flips fill the tank. Cars pass one another, and meet on what moves:
 * bridges that break, see-saws, crates.
 *
 * <p>All that a car does is in {@code input}, laps, gates and falls, too, and {@code rules} breaks
 * crates; so a player sees it at once. Places, bridges that are built again and the result are the
 * server's.
 *
 * <p>A level needs spawns {@code player}, a zone {@code end}, and a spawn {@code lap}, where cars
 * that enter the zone come out. It needs a sensor {@code gate}, and may have more, sensors {@code
 * ring}, spawns {@code crate}, zones {@code bridge} and {@code pit}, and loops: chains with the
 * tags {@value Track#CLIMB} and {@value Track#DESCENT}, zones {@code loop top} and, before and
 * after it, {@code loop side}.
 *
 * <pre>
 *   CarsGame        the order of a tick, and who wins
 *     CarsFields    the state that is saved, hashed and sent
 *     Track         kinds of entities and events, the level's places
 *     Driving       motors, nitro, flips, laps, tows
 *     Roadworks     crates that break, and what is built again
 * </pre>
 */
public final class CarsGame implements Game {
  /** Number of laps of a race. */
  public static final int LAPS = 3;

  /** Longest race, seconds. */
  public static final float MATCH_SECONDS = 240;

  /** Greatest speed without nitro on level ground, m/s. */
  public static final float SPEED = 15;

  /** Greatest speed with nitro on level ground, m/s. */
  public static final float BOOST_SPEED = 23;

  /** Radius of a wheel, m. */
  static final float WHEEL = 0.46f;

  /** Height of a car's origin over level ground, m. */
  static final float HEIGHT = 0.95f;

  /** Mass of a car, kg. */
  static final float MASS = 3;

  private static final MatchClock CLOCK = MatchClock.playing(MATCH_SECONDS).warmUp(2).countdown(3);

  private Track track;
  private Driving driving;
  private Roadworks roadworks;

  /** Creates the game, for the service loader. */
  public CarsGame() {}

  @Override
  public String name() {
    return "cars";
  }

  @Override
  public String defaultLevel() {
    return "cars";
  }

  @Override
  public String description() {
    return "race over hills, bridges and loops: the first after three laps wins";
  }

  @Override
  public List<Field<?>> fields() {
    return CarsFields.all();
  }

  @Override
  public List<Gauge> gauges() {
    return List.of(
        Gauge.bar("nitro", NITRO), Gauge.number("lap", LAP), Gauge.number("place", PLACE));
  }

  @Override
  public MatchClock clock() {
    return CLOCK;
  }

  @Override
  public void setUp(SetUp s) {
    track = new Track(s);
    driving = new Driving(track);
    roadworks = new Roadworks(track);
  }

  /** Gives a player a car; one who comes late drives in the lap of the last one. */
  @Override
  public void join(Match m, Player p) {
    int lap = LAPS;
    for (Player other : m.players()) {
      if (other != p) {
        lap = Math.min(lap, other.get(LAP));
      }
    }
    p.set(LAP, MatchClock.isPlaying(m) && m.playerCount() > 1 ? lap : 1);
    giveCar(m, p);
  }

  private void giveCar(Match m, Player p) {
    Level.Spawn spot = track.grid.get(p.id() % track.grid.size());
    m.spawn(track.car(p.id()), spot.x(), spot.y(), 0, p);
  }

  @Override
  public void input(Simulation s, Player p, Input in) {
    driving.input(s, p, in);
  }

  @Override
  public Consumer<Rules> rules(Level level) {
    return r -> roadworks.rules(r);
  }

  /** Lets a car into and out of a loop. */
  @Override
  public boolean collision(Simulation s, Contact c) {
    return !passes(c.self(), c.other()) && !passes(c.other(), c.self()) && c.holdsOneWay();
  }

  private static boolean passes(Entity e, Entity road) {
    int tag = road.archetype().tag();
    return tag != 0 && road.isLevel() && e.isOwned() && (tag == Track.CLIMB) == e.owner().get(OVER);
  }

  @Override
  public void broke(Simulation s, EntityJoint joint) {
    s.emit(track.snap).at(joint.anchorBX(), joint.anchorBY());
  }

  @Override
  public void beforeStep(Match m) {
    roadworks.beforeStep(m);
  }

  @Override
  public void afterStep(Match m) {
    for (Player p : m.players()) {
      int gates = (p.get(LAP) - 1) * (track.gates.size() + 1) + p.get(GATE);
      if (m.score(p) != gates) {
        m.score(p, gates);
      }
      int place = 1;
      for (Player other : m.players()) {
        place += way(other) > way(p) ? 1 : 0;
      }
      p.set(PLACE, place);
    }
    if (MatchClock.isPlaying(m)) {
      finishIfDecided(m);
    } else if (MatchClock.phase(m) != MatchPhase.OVER) {
      for (Player p : m.players()) {
        if (p.get(LAP) > LAPS) {
          p.set(LAP, 1); // it practises
        }
      }
    }
  }

  private float way(Player p) {
    return track.way(p.get(LAP), p.entity());
  }

  private void finishIfDecided(Match m) {
    Player first = first(m, null);
    if (first != null && first.get(LAP) > LAPS) {
      float seconds = MATCH_SECONDS - MatchClock.ticksLeft(m) * m.tickSeconds();
      CLOCK.finish(m, first);
      m.notice(
          String.format(
              Locale.ROOT, "%s wins in %.1f s%s", m.name(first), seconds, lead(m, first)));
    }
  }

  /** Returns the player who has come furthest, but for one, or null if there is none. */
  private Player first(Match m, Player but) {
    Player first = null;
    for (Player p : m.players()) {
      if (p != but && (first == null || way(p) > way(first))) {
        first = p;
      }
    }
    return first;
  }

  private String lead(Match m, Player first) {
    Player second = first(m, first);
    return second == null
        ? ""
        : ", " + Math.round(way(first) - way(second)) + " m ahead of " + m.name(second);
  }

  @Override
  public void phase(Match m, MatchPhase now) {
    if (now == MatchPhase.COUNTDOWN) {
      for (Player p : m.players()) { // what was practised is forgotten
        if (p.isAlive()) {
          p.entity().despawn();
        }
        p.resetFields();
        giveCar(m, p);
      }
    } else if (now == MatchPhase.OVER && MatchClock.winner(m) < 0) {
      Player first = first(m, null);
      CLOCK.decide(m, first, 0);
      m.notice(
          first == null
              ? "Nobody finished"
              : m.name(first) + " wins, furthest when time was up" + lead(m, first));
    }
  }
}

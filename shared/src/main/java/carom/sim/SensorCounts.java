package carom.sim;

import carom.physics.Body;
import carom.physics.BodyVisitor;
import carom.sim.entity.HostEntity;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/**
 * Counts what is in sensors, for rules that clients run. The counts are {@link RuleWords}, from the
 * first question on, so that the server's are known to each client. A client adds what it doesn't
 * have itself: the difference at the last tick at which it knew the server's count. So a rule means
 * the same at a client far away. One thread; allocates nothing in a step.
 */
final class SensorCounts {
  /** A sensor's name, and what is called so. */
  private record Sensor(String name, List<HostEntity> statics, List<Integer> bodies) {}

  private final SimulationHost simulation;
  private final SimParts parts;
  private final RuleWords words;
  private final List<Sensor> sensors = new ArrayList<>();

  /** By sensor: how many players' bodies, and how many others, are in it that aren't here. */
  private final int[] unknownPlayers;

  private final int[] unknownBodies;

  // Scratch of a count.
  private int players;
  private int bodies;
  private final BodyVisitor<HostEntity> count = this::count;
  private Consumer<? super HostEntity> receiver;
  private final BodyVisitor<HostEntity> visit = this::visit;

  SensorCounts(SimulationHost simulation, SimParts parts) {
    this.simulation = simulation;
    this.parts = parts;
    words = parts.ruleWords;
    for (String name : RuleWords.sensors(parts.level, parts.rules != null)) {
      sensors.add(new Sensor(name, new ArrayList<>(), new ArrayList<>()));
    }
    unknownPlayers = new int[sensors.size()];
    unknownBodies = new int[sensors.size()];
  }

  /** Finds the sensors, once the level is built. */
  void begin() {
    for (Sensor sensor : sensors) {
      for (HostEntity entity : parts.statics) {
        if (isSensor(entity, sensor.name)) {
          sensor.statics.add(entity);
        }
      }
      for (int i = 0; i < parts.level.bodies().size(); i++) {
        int archetype = parts.level.bodies().get(i).archetype();
        if (parts.archetypes.get(archetype).name().equals(sensor.name)) {
          sensor.bodies.add(i);
        }
      }
    }
  }

  private static boolean isSensor(HostEntity entity, String name) {
    return entity.archetype().sensor() && entity.archetype().name().equals(name);
  }

  /**
   * Returns the place of a sensor.
   *
   * @throws IllegalArgumentException if there is none of that name
   */
  int find(String name) {
    for (int i = 0; i < sensors.size(); i++) {
      if (sensors.get(i).name.equals(name)) {
        return i;
      }
    }
    throw new IllegalArgumentException(
        "sensor=\"" + name + "\" isn't a static of the level with \"sensor\": true");
  }

  /** Returns how many players' bodies are in a sensor. */
  int players(String name) {
    return players(find(name));
  }

  /** Returns how many bodies are in a sensor that belong to nobody. */
  int bodies(String name) {
    return bodies(find(name));
  }

  /** Returns how many players' bodies are in a sensor, by its place. */
  int players(int at) {
    if (simulation.get(words.players, at) == RuleWords.NEVER_ASKED) {
      lookInto(at);
      simulation.set(words.players, at, players + unknownPlayers[at]);
    }
    return Math.max(0, simulation.get(words.players, at));
  }

  /** Returns how many bodies are in a sensor that belong to nobody, by its place. */
  int bodies(int at) {
    if (simulation.get(words.bodies, at) == RuleWords.NEVER_ASKED) {
      lookInto(at);
      simulation.set(words.bodies, at, bodies + unknownBodies[at]);
    }
    return Math.max(0, simulation.get(words.bodies, at));
  }

  /** Counts after the physics of a tick. */
  void count() {
    for (int i = 0; i < sensors.size(); i++) {
      boolean countsPlayers = simulation.get(words.players, i) != RuleWords.NEVER_ASKED;
      boolean countsBodies = simulation.get(words.bodies, i) != RuleWords.NEVER_ASKED;
      if (countsPlayers || countsBodies) {
        lookInto(i);
      }
      if (countsPlayers) {
        simulation.set(words.players, i, players + unknownPlayers[i]);
      }
      if (countsBodies) {
        simulation.set(words.bodies, i, bodies + unknownBodies[i]);
      }
    }
  }

  /** Takes the present counts as the server's, see {@link Mirror#anchor}. */
  void anchor() {
    for (int i = 0; i < sensors.size(); i++) {
      lookInto(i);
      unknownPlayers[i] = Math.max(0, simulation.get(words.players, i) - players);
      unknownBodies[i] = Math.max(0, simulation.get(words.bodies, i) - bodies);
    }
  }

  private void lookInto(int at) {
    players = 0;
    bodies = 0;
    forEachOverlap(at, count);
  }

  private boolean count(Body<HostEntity> body) {
    HostEntity entity = body.user();
    if (entity.isOwned()) {
      players++;
    } else if (!entity.isLevel()) {
      bodies++;
    }
    return true;
  }

  /** Visits what is in a sensor, as far as it is known here. */
  void forEach(String name, Consumer<? super HostEntity> visitor) {
    forEach(find(name), visitor);
  }

  /** Visits what is in a sensor, by its place, as far as it is known here. */
  void forEach(int at, Consumer<? super HostEntity> visitor) {
    receiver = visitor;
    forEachOverlap(at, visit);
    receiver = null;
  }

  private boolean visit(Body<HostEntity> body) {
    if (!body.user().isLevel()) {
      receiver.accept(body.user());
    }
    return true;
  }

  private void forEachOverlap(int at, BodyVisitor<HostEntity> visitor) {
    Sensor sensor = sensors.get(at);
    for (int i = 0; i < sensor.statics.size(); i++) {
      sensor.statics.get(i).body().forEachOverlap(visitor);
    }
    for (int i = 0; i < sensor.bodies.size(); i++) {
      HostEntity entity = parts.levelBody(sensor.bodies.get(i));
      if (entity != null && isSensor(entity, sensor.name)) {
        entity.body().forEachOverlap(visitor);
      }
    }
  }
}

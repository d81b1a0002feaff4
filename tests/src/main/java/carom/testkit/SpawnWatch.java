package carom.testkit;

import carom.client.view.ClientView;
import carom.physics.Body;
import carom.sim.Simulation;
import carom.sim.entity.Entity;
import carom.sim.entity.Player;
import carom.sim.outbox.Event;
import carom.sim.spawn.Origin;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;

/**
 * Watches what the inputs of one client's player spawn: as the server has it, as the client
 * predicts it, and as the client draws it. Steps the stepper.
 */
public final class SpawnWatch {
  /** Where an entity is at a tick, to the last bit. */
  private record Place(float x, float y) {}

  /** An entity at a tick. */
  private record Moment(int origin, int tick) {}

  private final Stepper stepper;
  private final SimulatedClient client;
  private final int playerId;

  /** Origins before this one were spawned before. */
  private final int first;

  private final Map<Moment, Place> truth = new HashMap<>();
  private final Map<Moment, Place> predicted = new HashMap<>();
  private final Map<Integer, Integer> firstShown = new HashMap<>();
  private final Set<Integer> spawned = new HashSet<>();
  private final Map<Integer, Place> drawn = new HashMap<>();
  private long drawnNs;
  private int lastTick;
  private double largestJump;
  private final Map<Integer, Long> unpredictedSince = new HashMap<>();
  private double longestUnpredicted;
  private int mostAlive;

  /** Starts to watch a client that plays. */
  public SpawnWatch(Stepper stepper, SimulatedClient client) {
    this.stepper = stepper;
    this.client = client;
    playerId = stepper.player(client).id();
    first = Origin.of(client.view().tick() + 1, 0);
  }

  /** Runs for a number of seconds. */
  public void run(double seconds) {
    long endNs = stepper.nowNs() + (long) (seconds * 1e9);
    while (stepper.nowNs() < endNs) {
      step();
    }
  }

  /** Advances time by one slice. */
  public void step() {
    stepper.step();
    Player player = stepper.room().simulation().player(playerId);
    int tick = stepper.frame().tick();
    for (int i = 0; player != null && i < player.spawnedCount(); i++) {
      Entity e = player.spawned(i);
      if (Origin.isEarlier(e.origin(), first)) {
        continue;
      }
      spawned.add(e.origin());
      truth.put(new Moment(e.origin(), tick), place(e));
    }
    Simulation simulation = client.view().predictedWorld();
    if (simulation == null || simulation.player(playerId) == null) {
      return;
    }
    Player mirrored = simulation.player(playerId);
    mostAlive = Math.max(mostAlive, mirrored.spawnedCount());
    if (simulation.tick() > lastTick) {
      lastTick = simulation.tick();
      for (int i = 0; i < mirrored.spawnedCount(); i++) {
        Entity e = mirrored.spawned(i);
        if (Origin.isEarlier(e.origin(), first)) {
          continue;
        }
        predicted.put(new Moment(e.origin(), lastTick), place(e));
        firstShown.putIfAbsent(e.origin(), lastTick);
      }
    }
    look(mirrored);
  }

  private static Place place(Entity e) {
    return new Place(e.body().x(), e.body().y());
  }

  /** Looks at the picture: jumps, and what is drawn without being there. */
  private void look(Player mirrored) {
    Map<Integer, Place> now = new HashMap<>();
    double seconds = (stepper.nowNs() - drawnNs) * 1e-9;
    drawnNs = stepper.nowNs();
    ClientView view = client.view();
    Set<Integer> unpredicted = new HashSet<>();
    for (int i = 0; i < view.entityCount(); i++) {
      ClientView.Drawn d = view.entity(i);
      if (d.ownerId() != playerId || d == view.own() || d.alpha() < 0.1f) {
        continue;
      }
      Entity e = find(mirrored, d);
      if (e == null) {
        int key = Event.key(d.id(), d.generation());
        unpredicted.add(key);
        long since = unpredictedSince.computeIfAbsent(key, k -> stepper.nowNs());
        longestUnpredicted = Math.max(longestUnpredicted, (stepper.nowNs() - since) * 1e-9);
        continue;
      }
      Place place = new Place(d.x(), d.y());
      now.put(e.origin(), place);
      Place before = drawn.get(e.origin());
      if (before != null) {
        Body<Entity> body = e.body();
        double speed = Math.hypot(body.velocityX(), body.velocityY());
        double moved = Math.hypot(place.x - before.x, place.y - before.y);
        largestJump = Math.max(largestJump, Math.abs(moved - speed * seconds));
      }
    }
    unpredictedSince.keySet().retainAll(unpredicted);
    drawn.clear();
    drawn.putAll(now);
  }

  private static Entity find(Player mirrored, ClientView.Drawn d) {
    for (int i = 0; i < mirrored.spawnedCount(); i++) {
      Entity e = mirrored.spawned(i);
      if (Event.key(e.id(), e.generation()) == Event.key(d.id(), d.generation())) {
        return e;
      }
    }
    return null;
  }

  /** Returns how many entities the server has spawned. */
  public int spawned() {
    return spawned.size();
  }

  /** Returns how many entities the client has shown. */
  public int shown() {
    return firstShown.size();
  }

  /** Returns the percentage of the shown ones that the server has spawned, too. */
  public double matchedPercent() {
    long matched = firstShown.keySet().stream().filter(spawned::contains).count();
    return firstShown.isEmpty() ? 0 : 100.0 * matched / firstShown.size();
  }

  /** Returns the largest number of ticks after its spawn at which one of the server's was shown. */
  public int latestTicks() {
    return firstShown.entrySet().stream()
        .filter(shown -> spawned.contains(shown.getKey()))
        .mapToInt(shown -> Origin.ticksBetween(shown.getKey(), Origin.of(shown.getValue(), 0)))
        .max()
        .orElse(-1);
  }

  /**
   * Returns the percentage of predicted places, at all ticks, that were the server's in each bit.
   */
  public double rightPercent() {
    int known = stepper.frame().tick();
    long compared = predicted.keySet().stream().filter(m -> m.tick <= known).count();
    long right =
        predicted.entrySet().stream()
            .filter(p -> p.getKey().tick <= known && p.getValue().equals(truth.get(p.getKey())))
            .count();
    return compared == 0 ? 0 : 100.0 * right / compared;
  }

  /** Returns the largest difference between a picture's way in a frame and its speed, metres. */
  public double largestJump() {
    return largestJump;
  }

  /**
   * Returns for how long an entity was drawn, at most, that the client doesn't predict: one that
   * fades out, a second picture of one, or one that lives on. Seconds.
   */
  public double longestUnpredicted() {
    return longestUnpredicted;
  }

  /** Returns the most entities of the player that the client has predicted at a time. */
  public int mostAlive() {
    return mostAlive;
  }

  @Override
  public String toString() {
    return String.format(
        java.util.Locale.ROOT,
        "spawned=%d shown=%d matched=%.1f%% latest=%d right=%.1f%% jump=%.3f"
            + " unpredicted=%.3f s alive=%d",
        spawned(),
        shown(),
        matchedPercent(),
        latestTicks(),
        rightPercent(),
        largestJump,
        longestUnpredicted,
        mostAlive);
  }
}

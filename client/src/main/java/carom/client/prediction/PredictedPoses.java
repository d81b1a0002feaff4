package carom.client.prediction;

import carom.client.interpolation.Pose;
import carom.net.snapshot.exact.NearState;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.level.Archetype;
import carom.sim.near.Neighbourhood;
import carom.sim.spawn.Origin;
import java.util.ArrayList;
import java.util.List;

/**
 * Poses to draw of the predicted set: the own body and the bodies near it. One prediction's;
 * allocates when a body enters the set.
 */
final class PredictedPoses {
  /** Ticks by which an input may count earlier or later at the server, for one picture to go on. */
  private static final int MOST_TICKS_APART = 12;

  private final SimulationHost simulation;
  private final SnapshotRecords records;
  private final List<PredictedBody> others = new ArrayList<>();
  private final Pose scratch = new Pose();
  private PredictedBody own;

  /** Version of the simulation's entities that the bodies follow. */
  private long version;

  /** Index in {@link #others} that was found last: searches mostly ask for the one after it. */
  private int cursor;

  PredictedPoses(SimulationHost simulation, SnapshotRecords records) {
    this.simulation = simulation;
    this.records = records;
  }

  /** Returns the own body, or null while there is none. */
  PredictedBody own() {
    return own;
  }

  /** Removes all bodies. */
  void clear() {
    others.clear();
    own = null;
  }

  /** Starts anew with an own body and no others. */
  void begin(int id, int generation) {
    others.clear();
    own = new PredictedBody(id, generation, records.archetype(id), 1);
    own.updateTeleports(records.teleports(id, generation));
  }

  /** Returns whether the own body is the only one. */
  boolean isAlone() {
    return others.isEmpty();
  }

  /**
   * Follows what the last ticks spawned and despawned.
   *
   * @param corrected whether they were computed again
   */
  void follow(boolean corrected) {
    if (simulation.rosterVersion() != version) {
      bind(corrected);
    }
  }

  /** Follows a correction of the simulation's entities: binds, detaches and adds bodies. */
  void bind() {
    bind(true);
  }

  private void bind(boolean corrected) {
    version = simulation.rosterVersion();
    own.entity = simulation.entity(own.id);
    own.archetype = own.entity == null ? own.archetype : own.entity.archetype();
    for (int i = others.size() - 1; i >= 0; i--) {
      PredictedBody body = others.get(i);
      HostEntity e = simulation.entity(body.id);
      if (e == null || e.generation() != body.generation) {
        body.detach(corrected ? body.before : body.previous);
      } else {
        body.entity = e;
        body.archetype = e.archetype();
      }
    }
    for (int id = 0; id < simulation.entityCapacity(); id++) {
      HostEntity e = simulation.entity(id);
      if (e != null
          && id != own.id
          && find(id, e.generation()) == null
          && !takeOver(e, corrected)) {
        add(e, 0);
      }
    }
    for (int i = 0; i < simulation.mirror().provisionalCount(); i++) {
      HostEntity e = simulation.mirror().provisional(i);
      if (find(e.id(), 0) == null && !takeOver(e, corrected)) {
        PredictedBody body = add(e, 1);
        body.previous.x -= body.previous.vx * simulation.tickSeconds(); // where it was spawned
        body.previous.y -= body.previous.vy * simulation.tickSeconds();
      }
    }
  }

  private PredictedBody add(HostEntity e, float blend) {
    PredictedBody body = new PredictedBody(e.id(), e.generation(), e.archetype(), blend);
    body.entity = e;
    body.isOwn = e.ownerId() == own.entity.ownerId();
    body.readPose(body.previous);
    body.readPose(body.before);
    body.updateTeleports(teleports(e));
    others.add(body);
    if (e.origin() != Origin.NONE) {
      records.spawns().predict(e.origin());
    }
    return body;
  }

  private int teleports(HostEntity e) {
    return e.isProvisional() ? 0 : records.teleports(e.id(), e.generation());
  }

  /**
   * Lets the picture of a provisional entity become that of the server's or, in a correction, of
   * one that the same input has spawned a little earlier or later now.
   *
   * @return whether there was one
   */
  private boolean takeOver(HostEntity e, boolean corrected) {
    PredictedBody nearest = null;
    int best = MOST_TICKS_APART + 1;
    for (int i = 0; i < others.size() && e.origin() != Origin.NONE; i++) {
      PredictedBody body = others.get(i);
      if (body.isProvisional() && body.archetype == e.archetype()) {
        int apart = Math.abs(Origin.ticksBetween(body.id, e.origin()));
        boolean moved = corrected && body.wasThere && body.entity == null;
        boolean free = body.id == e.origin() || moved;
        if (free && apart < best) {
          best = apart;
          nearest = body;
        }
      }
    }
    if (nearest == null) {
      return false;
    }
    nearest.become(e, teleports(e));
    records.spawns().predict(e.origin());
    return true;
  }

  private PredictedBody find(int id, int generation) {
    int size = others.size();
    for (int i = 0; i < size; i++) {
      cursor = cursor < size - 1 ? cursor + 1 : 0;
      PredictedBody body = others.get(cursor);
      if (body.id == id && body.generation == generation) {
        return body;
      }
    }
    return null;
  }

  /** Notes the poses before the newest tick is simulated. */
  void beginTick() {
    own.readPose(own.previous);
    for (int i = 0; i < others.size(); i++) {
      PredictedBody body = others.get(i);
      if (body.entity != null) {
        body.readPose(body.previous);
      }
    }
  }

  /** Notes the poses before a correction. */
  void beginCorrection() {
    own.readPose(own.before);
    for (int i = 0; i < others.size(); i++) {
      others.get(i).readPose(others.get(i).before);
      others.get(i).wasThere = others.get(i).entity != null;
    }
  }

  /**
   * Turns what a correction moved into visual errors, which fade.
   *
   * @return how far the own body moved, metres
   */
  float endCorrection() {
    for (int i = 0; i < others.size(); i++) {
      smooth(others.get(i));
    }
    return smooth(own);
  }

  private float smooth(PredictedBody body) {
    body.readPose(scratch);
    if (!body.isProvisional()
        && body.updateTeleports(records.teleports(body.id, body.generation))) {
      body.error.clear();
      body.previous.set(scratch);
      return 0;
    }
    float dx = body.before.x - scratch.x;
    float dy = body.before.y - scratch.y;
    body.error.add(dx, dy, Pose.wrap(body.before.angle - scratch.angle));
    return (float) Math.sqrt(dx * dx + dy * dy);
  }

  /**
   * Lets time pass for visual errors and blends.
   *
   * @param near what the server counts as near
   */
  void advance(float seconds, NearState near) {
    if (own != null) {
      own.advance(seconds);
    }
    for (int i = others.size() - 1; i >= 0; i--) {
      PredictedBody body = others.get(i);
      body.advance(seconds);
      if (body.isFadedOut() && (body.isProvisional() || !isGone(body, near))) {
        others.remove(i);
      }
    }
  }

  /** Returns whether the own input has despawned an entity that the server has still near. */
  boolean isGone(int id, int generation, NearState near) {
    PredictedBody body = own.id == id && own.generation == generation ? own : find(id, generation);
    return body != null && isGone(body, near);
  }

  private static boolean isGone(PredictedBody body, NearState near) {
    if (body.entity != null || !body.isOwn) {
      return false;
    }
    int key = Neighbourhood.key(body.id, body.generation);
    for (int i = 0; i < near.count(); i++) {
      if (near.key(i) == key) {
        return true;
      }
    }
    return false;
  }

  /** Returns the number of bodies besides the own one, faded ones included. */
  int count() {
    return others.size();
  }

  /** Returns a body besides the own one. */
  PredictedBody get(int index) {
    return others.get(index);
  }

  /** Returns the archetype that an entity has in the prediction, or null if it isn't predicted. */
  Archetype archetype(int id, int generation) {
    boolean isOwn = own.id == id && own.generation == generation;
    PredictedBody body = isOwn ? own : find(id, generation);
    return body == null ? null : body.archetype;
  }

  /** Reads a pose to draw; see {@link Prediction#readPose}. */
  float readPose(int id, int generation, float fraction, Pose out) {
    boolean isOwn = own.id == id && own.generation == generation;
    return readPose(isOwn ? own : find(id, generation), fraction, out);
  }

  /** Reads a pose to draw of a body, which may be null. */
  float readPose(PredictedBody body, float fraction, Pose out) {
    if (body == null || body.weight() == 0) {
      return 0;
    }
    body.readPose(scratch);
    out.set(body.previous);
    out.blend(scratch, fraction);
    body.error.addTo(out);
    return body.weight();
  }
}

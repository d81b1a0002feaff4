package carom.client.prediction;

import carom.client.interpolation.Pose;
import carom.client.prediction.received.SnapshotRecords;
import carom.sim.Entity;
import carom.sim.Simulation;
import java.util.ArrayList;
import java.util.List;

/**
 * Poses to draw of the predicted set: the own body and the bodies near it. One prediction's;
 * allocates when a body enters the set.
 */
final class PredictedPoses {
  private final Simulation simulation;
  private final SnapshotRecords records;
  private final List<PredictedBody> others = new ArrayList<>();
  private final Pose scratch = new Pose();
  private PredictedBody own;

  /** Index in {@link #others} that was found last: searches mostly ask for the one after it. */
  private int cursor;

  PredictedPoses(Simulation simulation, SnapshotRecords records) {
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
    own = new PredictedBody(id, generation, 1);
    own.updateTeleports(records.teleports(id, generation));
  }

  /** Returns whether the own body is the only one. */
  boolean isAlone() {
    return others.isEmpty();
  }

  /** Follows a change of the simulation's entities: binds, detaches and adds bodies. */
  void bind() {
    own.entity = simulation.entity(own.id);
    for (int i = others.size() - 1; i >= 0; i--) {
      PredictedBody body = others.get(i);
      Entity e = simulation.entity(body.id);
      if (e == null || e.generation() != body.generation) {
        body.detach();
      } else {
        body.entity = e;
      }
    }
    for (int id = 0; id < simulation.entityCapacity(); id++) {
      Entity e = simulation.entity(id);
      if (e != null && id != own.id && find(id, e.generation()) == null) {
        PredictedBody body = new PredictedBody(id, e.generation(), 0);
        body.entity = e;
        body.readPose(body.previous);
        body.readPose(body.before);
        body.updateTeleports(records.teleports(id, e.generation()));
        others.add(body);
      }
    }
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
    if (body.updateTeleports(records.teleports(body.id, body.generation))) {
      body.error.clear();
      body.previous.set(scratch);
      return 0;
    }
    float dx = body.before.x - scratch.x;
    float dy = body.before.y - scratch.y;
    body.error.add(dx, dy, Pose.wrap(body.before.angle - scratch.angle));
    return (float) Math.sqrt(dx * dx + dy * dy);
  }

  /** Lets time pass for visual errors and blends. */
  void advance(float seconds) {
    if (own != null) {
      own.advance(seconds);
    }
    for (int i = others.size() - 1; i >= 0; i--) {
      others.get(i).advance(seconds);
      if (others.get(i).isFadedOut()) {
        others.remove(i);
      }
    }
  }

  /** Reads a pose to draw; see {@link Prediction#readPose}. */
  float readPose(int id, int generation, float fraction, Pose out) {
    boolean isOwn = own.id == id && own.generation == generation;
    PredictedBody body = isOwn ? own : find(id, generation);
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

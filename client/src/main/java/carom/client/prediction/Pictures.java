package carom.client.prediction;

import carom.client.interpolation.Pose;
import carom.sim.Entity;
import carom.sim.Simulation;
import java.util.ArrayList;
import java.util.List;

/**
 * The pictures of all predicted bodies: the own one and those near it. One prediction's; allocates
 * when a body comes near.
 */
final class Pictures {
  private final Simulation simulation;
  private final Records records;
  private final List<Neighbour> others = new ArrayList<>();
  private final Pose scratch = new Pose();
  private Neighbour own;
  private int next;

  Pictures(Simulation simulation, Records records) {
    this.simulation = simulation;
    this.records = records;
  }

  /** The own body's, or null when there is none. */
  Neighbour own() {
    return own;
  }

  /** Shows nobody. */
  void clear() {
    others.clear();
    own = null;
  }

  /** Shows this own body, and nobody else. */
  void begin(int id, int generation) {
    others.clear();
    own = new Neighbour(id, generation, 1);
    own.teleports(records.teleports(id, generation));
  }

  /** Whether nobody but the own body is shown. */
  boolean alone() {
    return others.isEmpty();
  }

  /** Finds each picture's entity, after the simulation's entities changed. */
  void bind() {
    own.entity = simulation.entity(own.id);
    for (int i = others.size() - 1; i >= 0; i--) {
      Neighbour n = others.get(i);
      Entity e = simulation.entity(n.id);
      if (e == null || e.generation() != n.generation) {
        n.leave();
      } else {
        n.entity = e;
      }
    }
    for (int id = 0; id < simulation.entityCapacity(); id++) {
      Entity e = simulation.entity(id);
      if (e != null && id != own.id && find(id, e.generation()) == null) {
        Neighbour n = new Neighbour(id, e.generation(), 0);
        n.entity = e;
        n.pose(n.previous);
        n.pose(n.before);
        n.teleports(records.teleports(id, e.generation()));
        others.add(n);
      }
    }
  }

  /** Whoever is looked for in the order of the last time is found at once. */
  private Neighbour find(int id, int generation) {
    int size = others.size();
    for (int i = 0; i < size; i++) {
      next = next < size - 1 ? next + 1 : 0;
      Neighbour n = others.get(next);
      if (n.id == id && n.generation == generation) {
        return n;
      }
    }
    return null;
  }

  /** A tick begins. */
  void stepping() {
    own.pose(own.previous);
    for (int i = 0; i < others.size(); i++) {
      Neighbour n = others.get(i);
      if (n.entity != null) {
        n.pose(n.previous);
      }
    }
  }

  /** A correction begins. */
  void correcting() {
    own.pose(own.before);
    for (int i = 0; i < others.size(); i++) {
      others.get(i).pose(others.get(i).before);
    }
  }

  /**
   * A correction has ended: what it moved is still shown, and fades.
   *
   * @return by how much the own body moved, metres
   */
  float corrected() {
    for (int i = 0; i < others.size(); i++) {
      glide(others.get(i));
    }
    return glide(own);
  }

  private float glide(Neighbour n) {
    n.pose(scratch);
    if (n.teleports(records.teleports(n.id, n.generation))) {
      n.error.clear();
      n.previous.set(scratch);
      return 0;
    }
    float dx = n.before.x - scratch.x;
    float dy = n.before.y - scratch.y;
    n.error.add(dx, dy, Pose.wrap(n.before.angle - scratch.angle));
    return (float) Math.sqrt(dx * dx + dy * dy);
  }

  /** Lets time pass for what fades. */
  void advance(float seconds) {
    if (own != null) {
      own.advance(seconds);
    }
    for (int i = others.size() - 1; i >= 0; i--) {
      others.get(i).advance(seconds);
      if (others.get(i).faded()) {
        others.remove(i);
      }
    }
  }

  /** As {@link Prediction#drawn}. */
  float drawn(int id, int generation, float fraction, Pose out) {
    boolean isOwn = own.id == id && own.generation == generation;
    Neighbour n = isOwn ? own : find(id, generation);
    if (n == null || n.share() == 0) {
      return 0;
    }
    n.pose(scratch);
    out.set(n.previous);
    out.blend(scratch, fraction);
    n.error.addTo(out);
    return n.share();
  }
}

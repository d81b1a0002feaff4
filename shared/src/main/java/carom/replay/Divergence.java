package carom.replay;

import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/** Report of a difference between a replay and its recording. */
public final class Divergence {
  /** Largest number of bodies that a report lists. */
  private static final int MAX_LISTED = 8;

  /**
   * An entity that differs, with both its states. A state is x, y, cos, sin, vx, vy and omega in
   * metres, m/s and rad/s.
   */
  public static final class Difference {
    private final int id;
    private final String name;
    private final float[] recorded;
    private final float[] replayed;

    Difference(int id, String name, int[] recorded, int[] replayed) {
      this.id = id;
      this.name = name;
      this.recorded = floats(recorded);
      this.replayed = floats(replayed);
    }

    private static float[] floats(int[] bits) {
      float[] values = new float[bits.length];
      for (int i = 0; i < bits.length; i++) {
        values[i] = Float.intBitsToFloat(bits[i]);
      }
      return values;
    }

    /** Returns the entity's slot. */
    public int id() {
      return id;
    }

    /** Returns the entity's archetype, generation and owner as replayed. */
    public String name() {
      return name;
    }

    /** Returns a copy of the recorded state, which is empty if the recording lacks the entity. */
    public float[] recorded() {
      return recorded.clone();
    }

    /** Returns a copy of the replayed state, which is empty if the replay lacks the entity. */
    public float[] replayed() {
      return replayed.clone();
    }

    @Override
    public String toString() {
      return String.format(
          Locale.ROOT,
          "entity %d, %s%n    recorded %s%n    replayed %s",
          id,
          name,
          describe(recorded),
          describe(replayed));
    }

    private static String describe(float[] s) {
      if (s.length == 0) {
        return "not there";
      }
      return "x=" + s[0] + " y=" + s[1] + " cos=" + s[2] + " sin=" + s[3] + " vx=" + s[4] + " vy="
          + s[5] + " omega=" + s[6];
    }
  }

  private final int tick;
  private final long recordedHash;
  private final long replayedHash;
  private int bodyTick = -1;
  private int endTick = -1;
  private boolean exact;
  private int differing;
  private final List<Difference> differences = new ArrayList<>();

  Divergence(int tick, long recordedHash, long replayedHash) {
    this.tick = tick;
    this.recordedHash = recordedHash;
    this.replayedHash = replayedHash;
  }

  void oneBody(int when, SimulationHost s, int id, int[] recorded) {
    int[] replayed = new int[Fingerprint.FIELDS];
    HostEntity e = s.entity(id);
    Fingerprint.read(e, replayed);
    bodyTick = when;
    exact = true;
    differing = 1;
    differences.add(new Difference(id, name(e), recorded.clone(), replayed));
  }

  /**
   * Notes that several bodies differ, or that only one side has an entity. The sums don't tell
   * which.
   */
  void severalBodies(int when) {
    bodyTick = when;
  }

  /** Notes that the replay took over a whole state from the recording and is equal again. */
  void endsAt(int when) {
    endTick = when;
  }

  /** Compares all entities with a keyframe. */
  void keyframe(SimulationHost s, RecordingReader r) {
    int[] recorded = new int[Fingerprint.FIELDS];
    int[] replayed = new int[Fingerprint.FIELDS];
    for (int id = 0; id < Math.max(s.entityCapacity(), r.keyframeLimit()); id++) {
      HostEntity e = s.entity(id);
      boolean there = r.kind(id) >= 0;
      if (there) {
        r.keyState(id, recorded);
      }
      if (e != null) {
        Fingerprint.read(e, replayed);
      }
      boolean same =
          e == null
              ? !there
              : there
                  && e.archetype().index() == r.kind(id)
                  && e.generation() == r.generation(id)
                  && Arrays.equals(recorded, replayed);
      if (!same) {
        differing++;
        if (differences.size() < MAX_LISTED) {
          differences.add(
              new Difference(
                  id,
                  e == null ? "archetype " + r.kind(id) : name(e),
                  there ? recorded.clone() : new int[0],
                  e == null ? new int[0] : replayed.clone()));
        }
      }
    }
    if (differing > 0 && bodyTick < 0) {
      bodyTick = s.tick();
    }
  }

  private static String name(HostEntity e) {
    String owner = e.ownerId() == HostEntity.NO_OWNER ? "" : " of player " + e.ownerId();
    return e.archetype().name() + " generation " + e.generation() + owner;
  }

  /** Returns the first tick whose state hash differs. */
  public int tick() {
    return tick;
  }

  /**
   * Returns the tick of the recording's next whole state, from which the replay continued, or -1 if
   * the replay has not reached one.
   */
  public int endTick() {
    return endTick;
  }

  /** Returns the recorded hash of the first differing tick. */
  public long recordedHash() {
    return recordedHash;
  }

  /** Returns the replay's hash of the first differing tick. */
  public long replayedHash() {
    return replayedHash;
  }

  /**
   * Returns the first tick at which a body differs, or -1 if none differed before the replay
   * stopped. If it is -1, the difference is in inputs, scores, memory, random numbers, contacts or
   * joints.
   */
  public int bodyTick() {
    return bodyTick;
  }

  /**
   * Returns the bodies that differ. If one body was first, it is that body at {@link #bodyTick}. If
   * there were several, it is what a later keyframe shows, at most {@value #MAX_LISTED} bodies.
   */
  public List<Difference> differences() {
    return List.copyOf(differences);
  }

  /** Returns the report in several lines. */
  @Override
  public String toString() {
    StringBuilder text = new StringBuilder();
    text.append(
        String.format(
            Locale.ROOT,
            "diverged at tick %d: hash recorded %016x, replayed %016x",
            tick,
            recordedHash,
            replayedHash));
    if (bodyTick < 0) {
      text.append(
          "\n"
              + "  no body differs yet: it is an input, a score, memory, a random number, a contact"
              + " or a joint");
    } else if (exact) {
      text.append("\n  first body, at tick ").append(bodyTick);
    } else {
      text.append("\n  several bodies at once, at tick ").append(bodyTick);
      text.append("; ").append(differing).append(" differ at the next keyframe");
    }
    for (Difference difference : differences) {
      text.append("\n  ").append(difference);
    }
    if (endTick >= 0) {
      text.append("\n  went on from the recorded state of tick ").append(endTick);
    }
    return text.toString();
  }
}

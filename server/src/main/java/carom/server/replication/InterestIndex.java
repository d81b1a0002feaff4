package carom.server.replication;

import carom.net.codec.Quantizer;
import carom.net.snapshot.frame.FrameState;
import carom.physics.broadphase.AabbArray;
import carom.physics.broadphase.IntVisitor;
import carom.physics.broadphase.KdTree;
import carom.sim.SimulationHost;
import carom.sim.event.Audience;
import java.util.Arrays;

/**
 * Finds a room's entities by place: a KD-tree over a frame's entities, shared by all sessions. It
 * is brought up to date at most once a tick, and only when a session asks.
 *
 * <p>The room's thread. Bringing it up to date is O(entities), a query O(log n + found); nothing
 * allocates once arrays have grown.
 */
final class InterestIndex {
  private static final int MIN_LENGTH = 64;

  private final SimulationHost simulation;
  private final AabbArray boxes = new AabbArray(MIN_LENGTH);
  private final KdTree tree = new KdTree(boxes);
  private final float[] reach;
  private int[] ids = new int[MIN_LENGTH];
  private int count;
  private int[] special = new int[MIN_LENGTH];
  private int specialCount;
  private int tick = -1;
  private boolean narrow;

  InterestIndex(SimulationHost simulation) {
    this.simulation = simulation;
    reach = new float[simulation.archetypes().size()];
    for (int i = 0; i < reach.length; i++) {
      reach[i] = simulation.archetypes().get(i).reach();
    }
  }

  /** Radius around an entity's position that holds all of it, metres. */
  float reach(FrameState frame, int slot) {
    return reach[frame.archetype(slot)];
  }

  /** Sets whether views are narrow; see {@link FrameCapture#narrowViews}. */
  void narrowViews(boolean nowNarrow) {
    narrow = nowNarrow;
  }

  /** Returns whether views are narrow. */
  boolean viewsAreNarrow() {
    return narrow;
  }

  /** Visits the slots whose entities may overlap a box, metres; some lie just outside. */
  void query(FrameState frame, float minX, float minY, float maxX, float maxY, IntVisitor visitor) {
    update(frame);
    tree.query(minX, minY, maxX, maxY, visitor);
  }

  /** Visits the slots of entities whose audience is not {@link Audience#NEAR}. */
  void special(FrameState frame, IntVisitor visitor) {
    update(frame);
    for (int i = 0; i < specialCount; i++) {
      visitor.visit(special[i]);
    }
  }

  private void update(FrameState frame) {
    if (tick == frame.tick()) {
      return;
    }
    tick = frame.tick();
    boxes.ensureCapacity(frame.slotLimit());
    int n = 0;
    int specials = 0;
    boolean same = true;
    for (int slot = 0; slot < frame.slotLimit(); slot++) {
      if (!frame.alive(slot)) {
        continue;
      }
      float x = Quantizer.positionOf(frame.x(slot));
      float y = Quantizer.positionOf(frame.y(slot));
      float r = reach[frame.archetype(slot)];
      boxes.set(slot, x - r, y - r, x + r, y + r);
      if (n == ids.length) {
        ids = Arrays.copyOf(ids, 2 * n);
      }
      same &= n < count && ids[n] == slot;
      ids[n++] = slot;
      if (FrameCapture.audience(frame, slot) != Audience.NEAR) {
        if (specials == special.length) {
          special = Arrays.copyOf(special, 2 * specials);
        }
        special[specials++] = slot;
      }
    }
    specialCount = specials;
    if (same && n == count) {
      tree.refit();
    } else {
      count = n;
      tree.rebuild(boxes, ids, n);
    }
  }

  /** Returns the simulation that the entities belong to. */
  SimulationHost simulation() {
    return simulation;
  }
}

package carom.net.snapshot;

/**
 * The last {@link #SIZE} frame states of a room. The server captures each tick like this:
 *
 * <pre>{@code
 * FrameState frame = ring.begin(tick);
 * for (each entity) frame.put(id, generation, archetype, owner, x, y, angle, vx, vy, omega);
 * ring.end();
 * }</pre>
 *
 * One thread, no allocation after construction.
 */
public final class FrameRing {

  /** Frames kept; a baseline is at most {@code SIZE - 1} ticks old. */
  public static final int SIZE = 64;

  /**
   * Creates an empty ring.
   *
   * @param capacity entity slots of each frame, 1..65,535
   */
  public FrameRing(int capacity) {}

  /** Entity slots of each frame. */
  public int capacity() {
    throw new UnsupportedOperationException("soon");
  }

  /**
   * Starts the frame of a tick; all slots are free until {@link FrameState#put}.
   *
   * @param tick greater than the newest frame's
   */
  public FrameState begin(int tick) {
    throw new UnsupportedOperationException("soon");
  }

  /** Ends the frame that was begun: from now on it is the newest and doesn't change. */
  public void end() {
    throw new UnsupportedOperationException("soon");
  }

  /** The newest ended frame, or null before the first. */
  public FrameState newest() {
    throw new UnsupportedOperationException("soon");
  }

  /** The frame of a tick, or null when the ring doesn't hold it. */
  public FrameState at(int tick) {
    throw new UnsupportedOperationException("soon");
  }
}

package carom.net.snapshot;

/**
 * A room's whole world at one tick, quantised once for all sessions: a structure of int arrays, by
 * entity slot. Filled through {@link FrameRing}. Units: see {@link carom.net.codec.Quantizer}.
 */
public final class FrameState {

  FrameState(int capacity) {}

  /**
   * Puts an entity into the frame, quantising its state.
   *
   * @param slot entity id, 0..capacity - 1, put at most once per frame
   * @param generation 0..255, differs from that of the slot's previous entity
   * @param archetype 0..65,535
   * @param owner player id 0..255, or -1
   * @param x metres
   * @param y metres
   * @param angle radians
   * @param vx metres per second
   * @param vy metres per second
   * @param omega radians per second
   */
  public void put(
      int slot,
      int generation,
      int archetype,
      int owner,
      float x,
      float y,
      float angle,
      float vx,
      float vy,
      float omega) {
    throw new UnsupportedOperationException("soon");
  }

  /**
   * As {@link #put}, already quantised; values outside the ranges of {@code Quantizer} are refused.
   */
  public void putQuantized(
      int slot,
      int generation,
      int archetype,
      int owner,
      int x,
      int y,
      int angle,
      int vx,
      int vy,
      int omega) {
    throw new UnsupportedOperationException("soon");
  }

  /** The tick this frame is the state after. */
  public int tick() {
    throw new UnsupportedOperationException("soon");
  }

  /** Entities alive. */
  public int count() {
    throw new UnsupportedOperationException("soon");
  }

  /** Whether a slot holds an entity. */
  public boolean alive(int slot) {
    throw new UnsupportedOperationException("soon");
  }

  /** Generation of the slot's entity, 0..255. */
  public int generation(int slot) {
    throw new UnsupportedOperationException("soon");
  }

  /** Archetype of the slot's entity. */
  public int archetype(int slot) {
    throw new UnsupportedOperationException("soon");
  }

  /** Player id of the owner, or -1. */
  public int owner(int slot) {
    throw new UnsupportedOperationException("soon");
  }

  /** Position, steps. */
  public int x(int slot) {
    throw new UnsupportedOperationException("soon");
  }

  /** Position, steps. */
  public int y(int slot) {
    throw new UnsupportedOperationException("soon");
  }

  /** Angle, steps, 0..1,023. */
  public int angle(int slot) {
    throw new UnsupportedOperationException("soon");
  }

  /** Velocity, steps. */
  public int vx(int slot) {
    throw new UnsupportedOperationException("soon");
  }

  /** Velocity, steps. */
  public int vy(int slot) {
    throw new UnsupportedOperationException("soon");
  }

  /** Angular velocity, steps. */
  public int omega(int slot) {
    throw new UnsupportedOperationException("soon");
  }

  /**
   * The last tick at which anything of the slot's quantised state changed, liveness and identity
   * included.
   */
  public int changedTick(int slot) {
    throw new UnsupportedOperationException("soon");
  }

  /**
   * 64-bit hash of all slots' quantised state; equal frames have equal hashes, whatever their tick.
   */
  public long hash() {
    throw new UnsupportedOperationException("soon");
  }
}

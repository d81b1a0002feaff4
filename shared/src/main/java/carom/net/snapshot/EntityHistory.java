package carom.net.snapshot;

/**
 * What a client has received of one entity slot: up to {@link #SIZE} states, each exactly the
 * server's quantised state after its tick. Index 0 is the newest. Between two entries the entity
 * moved; an entity that rested has an entry at the end of its rest, so that the way between two
 * neighbouring entries is always a movement that really took that long.
 */
public final class EntityHistory {

  /** Most states kept. */
  public static final int SIZE = 64;

  EntityHistory() {}

  /** States held, 0..{@link #SIZE}. */
  public int size() {
    throw new UnsupportedOperationException("soon");
  }

  /** Whether the newest known state is a living entity. */
  public boolean alive() {
    return size() > 0 && alive(0);
  }

  /** Index of the newest entry at or before a tick, or -1. */
  public int indexAt(int tick) {
    throw new UnsupportedOperationException("soon");
  }

  /** Tick of an entry. */
  public int tick(int index) {
    throw new UnsupportedOperationException("soon");
  }

  /** Whether the slot held an entity then; if not, the entry's other values mean nothing. */
  public boolean alive(int index) {
    throw new UnsupportedOperationException("soon");
  }

  /** Generation: entries of different generations are different entities. */
  public int generation(int index) {
    throw new UnsupportedOperationException("soon");
  }

  /** Archetype index. */
  public int archetype(int index) {
    throw new UnsupportedOperationException("soon");
  }

  /** Player id of the owner, or -1. */
  public int owner(int index) {
    throw new UnsupportedOperationException("soon");
  }

  /** Position in steps; {@code Quantizer.positionOf} gives metres. */
  public int x(int index) {
    throw new UnsupportedOperationException("soon");
  }

  /** Position in steps. */
  public int y(int index) {
    throw new UnsupportedOperationException("soon");
  }

  /** Angle in steps, 0..1,023; {@code Quantizer.angleOf} gives radians. */
  public int angle(int index) {
    throw new UnsupportedOperationException("soon");
  }

  /** Velocity in steps; {@code Quantizer.velocityOf} gives m/s. */
  public int vx(int index) {
    throw new UnsupportedOperationException("soon");
  }

  /** Velocity in steps. */
  public int vy(int index) {
    throw new UnsupportedOperationException("soon");
  }

  /** Angular velocity in steps; {@code Quantizer.omegaOf} gives rad/s. */
  public int omega(int index) {
    throw new UnsupportedOperationException("soon");
  }
}

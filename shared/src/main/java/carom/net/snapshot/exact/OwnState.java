package carom.net.snapshot.exact;

import carom.net.snapshot.frame.PlayerSet;
import carom.net.snapshot.relay.RelayCodec;

/**
 * The exact state of a player's own body, bit by bit, with the player's four memory ints: what
 * client prediction restores. Mutable, reused. Positions and velocities are of the body's centre of
 * mass, metres, m/s, rad/s.
 */
public final class OwnState {

  /** Number of exact floats: x, y, cos, sin, vx, vy, omega. */
  public static final int FLOATS = 7;

  /** Number of memory ints. */
  public static final int MEMORY = 4;

  /** Most players whose inputs are relayed to one client. */
  public static final int MAX_RELAYED = RelayCodec.MAX_PLAYERS;

  /** Inputs of a relayed player are told of so many ticks before the present at most. */
  public static final int RELAYED_TICKS = RelayCodec.MAX_WINDOW;

  public int slot = -1;
  public int generation;
  public final int[] values = new int[FLOATS + MEMORY];
  public final PlayerSet relayed = new PlayerSet();
  public final NearState near = new NearState();

  /** Creates the state of a player without a body. */
  public OwnState() {}

  /** Sets the body's exact state. */
  public void setBody(
      int slot,
      int generation,
      float x,
      float y,
      float cos,
      float sin,
      float vx,
      float vy,
      float omega) {
    this.slot = slot;
    this.generation = generation;
    values[0] = Float.floatToRawIntBits(x);
    values[1] = Float.floatToRawIntBits(y);
    values[2] = Float.floatToRawIntBits(cos);
    values[3] = Float.floatToRawIntBits(sin);
    values[4] = Float.floatToRawIntBits(vx);
    values[5] = Float.floatToRawIntBits(vy);
    values[6] = Float.floatToRawIntBits(omega);
  }

  /** The player has no body now; the memory stays. */
  public void clearBody() {
    slot = -1;
    generation = 0;
    for (int i = 0; i < FLOATS; i++) {
      values[i] = 0;
    }
  }

  /** The other players whose inputs are told to this client; at most {@value #MAX_RELAYED}. */
  public PlayerSet relayed() {
    return relayed;
  }

  /** Sets one of the player's memory ints. */
  public void setMemory(int index, int value) {
    values[FLOATS + checked(index)] = value;
  }

  /** Entity slot of the body, or -1 when there is none. */
  public int slot() {
    return slot;
  }

  /** Generation of the body's entity. */
  public int generation() {
    return generation;
  }

  /** Centre of mass, metres. */
  public float x() {
    return Float.intBitsToFloat(values[0]);
  }

  /** Centre of mass, metres. */
  public float y() {
    return Float.intBitsToFloat(values[1]);
  }

  /** Cosine of the angle. */
  public float cos() {
    return Float.intBitsToFloat(values[2]);
  }

  /** Sine of the angle. */
  public float sin() {
    return Float.intBitsToFloat(values[3]);
  }

  /** Velocity of the centre of mass, m/s. */
  public float vx() {
    return Float.intBitsToFloat(values[4]);
  }

  /** Velocity of the centre of mass, m/s. */
  public float vy() {
    return Float.intBitsToFloat(values[5]);
  }

  /** Angular velocity, rad/s. */
  public float omega() {
    return Float.intBitsToFloat(values[6]);
  }

  /** One of the player's memory ints, index 0..3. */
  public int memory(int index) {
    return values[FLOATS + checked(index)];
  }

  /** One of the {@link #FLOATS} floats' bits, then of the {@link #MEMORY} memory ints, 0..10. */
  public int bits(int index) {
    return values[index];
  }

  /** Copies body and memory alone: nothing of others, which takes many times as much. */
  public void setBody(OwnState other) {
    slot = other.slot;
    generation = other.generation;
    System.arraycopy(other.values, 0, values, 0, values.length);
  }

  /** Copies everything of another state into this one. */
  public void set(OwnState other) {
    setBody(other);
    relayed.set(other.relayed);
    near.set(other.near);
  }

  /** Copies all but the exact states of others: what a later section is coded against. */
  public void setBaseline(OwnState other) {
    setBody(other);
    relayed.set(other.relayed);
    near.setList(other.near);
  }

  /** Whether body, memory and relayed players are the same, bit by bit. */
  public boolean sameSection(OwnState other) {
    return sameAs(other) && relayed.sameAs(other.relayed);
  }

  /** Whether the numbers of the body are finite, and its angle is one: what was read may be not. */
  public boolean isSane() {
    for (int i = 0; i < FLOATS; i++) {
      if (!Float.isFinite(Float.intBitsToFloat(values[i]))) {
        return false;
      }
    }
    return slot < 0 || Math.abs(cos() * cos() + sin() * sin() - 1) < 1e-3f;
  }

  /** What is near the own body, itself included. */
  public NearState near() {
    return near;
  }

  /** Whether all bits of body and memory are the same. */
  public boolean sameAs(OwnState other) {
    return slot == other.slot
        && generation == other.generation
        && java.util.Arrays.equals(values, other.values);
  }

  private static int checked(int index) {
    if (index < 0 || index >= MEMORY) {
      throw new IndexOutOfBoundsException(
          "memory index=" + index + " is outside 0.." + (MEMORY - 1));
    }
    return index;
  }
}

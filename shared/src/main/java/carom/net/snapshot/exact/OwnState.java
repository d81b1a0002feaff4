package carom.net.snapshot.exact;

import carom.net.snapshot.frame.PlayerSet;
import carom.physics.rows.BodyRow;
import java.util.Arrays;

/**
 * The exact state of a player's own body, bit for bit, with the words of the player's fields that
 * players may be told. Client prediction restores it. Positions and velocities are those of the
 * body's centre of mass, in metres, m/s and rad/s. Mutable, reused.
 */
public final class OwnState {

  /** Number of exact floats, those of {@link BodyRow#MOTION}: x, y, cos, sin, vx, vy, omega. */
  public static final int FLOATS = BodyRow.MOTION_INTS;

  /** Largest number of words. */
  public static final int MAX_WORDS = 256;

  /** Largest number of players whose inputs are relayed to one client. */
  public static final int MAX_RELAYED = RelayCodec.MAX_PLAYERS;

  /**
   * Bound of each float of a body's exact state. Far beyond the ends of all worlds, and a world
   * still computes with finite numbers.
   */
  public static final float LIMIT = 1e9f;

  public int slot = -1;
  public int generation;
  int archetype;
  public int[] values = new int[FLOATS];
  public final PlayerSet relayed = new PlayerSet();

  /** By player: the tick from which its inputs are relayed without a pause; the sender's. */
  private int[] relayedSince = {};

  public final NearState near = new NearState();
  private final SpawnList spawned = new SpawnList();

  /** Creates the state of a player without body and words. */
  public OwnState() {}

  /**
   * Creates the state of a player without a body, whose words are 0.
   *
   * @param words their number, 0..{@value #MAX_WORDS}
   */
  public OwnState(int words) {
    setWords(words);
  }

  /** Changes the number of words; those that are new are 0. */
  void setWords(int words) {
    if (words < 0 || words > MAX_WORDS) {
      throw new IllegalArgumentException("words=" + words + " is outside 0.." + MAX_WORDS);
    }
    if (words != words()) {
      values = Arrays.copyOf(values, FLOATS + words);
    }
  }

  /** Returns the number of words. */
  public int words() {
    return values.length - FLOATS;
  }

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
    setMotion(BodyRow.X, x);
    setMotion(BodyRow.Y, y);
    setMotion(BodyRow.COS, cos);
    setMotion(BodyRow.SIN, sin);
    setMotion(BodyRow.VX, vx);
    setMotion(BodyRow.VY, vy);
    setMotion(BodyRow.OMEGA, omega);
  }

  /** Sets the index of the archetype of the body's entity, 0..4,095. */
  public void setArchetype(int index) {
    archetype = index;
  }

  /** Returns the index of the archetype of the body's entity. */
  public int archetype() {
    return archetype;
  }

  private void setMotion(int field, float value) {
    values[field - BodyRow.MOTION] = Float.floatToRawIntBits(value);
  }

  /**
   * Returns the bits of one of the floats.
   *
   * @param field offset that {@link BodyRow} declares, X to OMEGA
   */
  int motion(int field) {
    return values[field - BodyRow.MOTION];
  }

  /** Removes the body; the words stay. */
  public void clearBody() {
    slot = -1;
    generation = 0;
    archetype = 0;
    for (int i = 0; i < FLOATS; i++) {
      values[i] = 0;
    }
  }

  /**
   * Returns the other players whose inputs are relayed to this client, at most {@value
   * #MAX_RELAYED}.
   */
  public PlayerSet relayed() {
    return relayed;
  }

  /**
   * Adds a player whose inputs are relayed.
   *
   * @param since the tick from which they are, without a pause; only the sender knows it
   */
  public void relay(int player, int since) {
    relayed.add(player);
    if (player >= relayedSince.length) {
      relayedSince = Arrays.copyOf(relayedSince, Math.max(2 * relayedSince.length, player + 1));
    }
    relayedSince[player] = since;
  }

  /** Returns since which tick a player's inputs are relayed, as {@link #relay} was told. */
  int relayedSince(int player) {
    return relayedSince[player];
  }

  /** Sets a word of the player's fields, index 0..{@link #words} - 1. */
  public void setWord(int index, int value) {
    values[FLOATS + checked(index)] = value;
  }

  /** Returns the entity slot of the body, or -1 if there is none. */
  public int slot() {
    return slot;
  }

  /** Returns the generation of the body's entity. */
  public int generation() {
    return generation;
  }

  /** Returns the x of the centre of mass, metres. */
  public float x() {
    return Float.intBitsToFloat(motion(BodyRow.X));
  }

  /** Returns the y of the centre of mass, metres. */
  public float y() {
    return Float.intBitsToFloat(motion(BodyRow.Y));
  }

  /** Returns the cosine of the angle. */
  public float cos() {
    return Float.intBitsToFloat(motion(BodyRow.COS));
  }

  /** Returns the sine of the angle. */
  public float sin() {
    return Float.intBitsToFloat(motion(BodyRow.SIN));
  }

  /** Returns the x of the velocity of the centre of mass, m/s. */
  public float vx() {
    return Float.intBitsToFloat(motion(BodyRow.VX));
  }

  /** Returns a word of the player's fields, index 0..{@link #words} - 1. */
  public int word(int index) {
    return values[FLOATS + checked(index)];
  }

  /** Returns the bits of a value: the {@link #FLOATS} floats come first, then the words. */
  public int bits(int index) {
    return values[index];
  }

  /**
   * Copies only body and words of another state. Copying the relayed players and near entities too
   * takes many times as long.
   */
  public void setBody(OwnState other) {
    slot = other.slot;
    generation = other.generation;
    archetype = other.archetype;
    setWords(other.words());
    System.arraycopy(other.values, 0, values, 0, values.length);
  }

  /** Copies everything of another state into this one. */
  public void set(OwnState other) {
    setBody(other);
    relayed.set(other.relayed);
    if (relayedSince.length < other.relayedSince.length) {
      relayedSince = Arrays.copyOf(other.relayedSince, other.relayedSince.length);
    } else {
      System.arraycopy(other.relayedSince, 0, relayedSince, 0, other.relayedSince.length);
    }
    spawned.set(other.spawned);
    near.set(other.near);
  }

  /** Copies everything except a near update. A later section is coded against the copy. */
  public void setBaseline(OwnState other) {
    setBody(other);
    relayed.set(other.relayed);
    spawned.set(other.spawned);
    near.setList(other.near);
  }

  /** Returns whether body, words, relayed players and spawned entities are the same. */
  public boolean sameSection(OwnState other) {
    return sameAs(other) && relayed.sameAs(other.relayed) && spawned.sameAs(other.spawned);
  }

  /**
   * Returns whether the body's floats are below {@link #LIMIT} and its cosine and sine make an
   * angle. State read from a datagram may fail this.
   */
  public boolean isSane() {
    for (int i = 0; i < FLOATS; i++) {
      if (!(Math.abs(Float.intBitsToFloat(values[i])) < LIMIT)) {
        return false;
      }
    }
    return slot < 0 || Math.abs(cos() * cos() + sin() * sin() - 1) < 1e-3f;
  }

  /** Returns the living entities that the player's own inputs have spawned. */
  public SpawnList spawned() {
    return spawned;
  }

  /** Returns the entities near the own body, itself included. */
  public NearState near() {
    return near;
  }

  /** Returns whether the body is the same entity, of the same archetype. */
  boolean sameIdentity(OwnState other) {
    return slot == other.slot && generation == other.generation && archetype == other.archetype;
  }

  /** Returns whether all bits of body and words are the same. */
  public boolean sameAs(OwnState other) {
    return sameIdentity(other) && Arrays.equals(values, other.values);
  }

  /** Returns whether the body is the same, bit for bit. */
  public boolean sameBody(OwnState other) {
    return sameIdentity(other) && Arrays.equals(values, 0, FLOATS, other.values, 0, FLOATS);
  }

  private int checked(int index) {
    if (index < 0 || index >= words()) {
      throw new IndexOutOfBoundsException(
          "word index=" + index + " is outside 0.." + (words() - 1));
    }
    return index;
  }
}

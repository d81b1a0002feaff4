package carom.net.protocol;

import carom.net.codec.BitReader;
import carom.net.codec.BitWriter;

/**
 * What a client sends, at most once a tick: key, acks of snapshots, and its last inputs. A mutable
 * object that is used again and again: the client fills and encodes it, the server decodes into
 * one. No allocation. One thread.
 */
public final class InputDatagram {

  /** Largest encoded size in bytes. */
  public static final int MAX_BYTES = 128;

  /** Largest {@link #viewDelay}. */
  public static final int MAX_VIEW_DELAY = 4_095;

  /** Nothing: it predicts nothing, or the own body alone. */
  public static final int NEAR_NONE = 0;

  /** What its body touches, or may touch soon. */
  public static final int NEAR_ISLAND = 1;

  /** As much around it as there is room for. */
  public static final int NEAR_ALL = 2;

  /** Largest {@link #holdTicks}. */
  public static final int MAX_HOLD_TICKS = 63;

  private static final int INPUT_BITS = 48;
  private static final int VIEW_DELAY_BITS = 12;
  private static final int HOLD_BITS = 6;

  /**
   * The key of {@link ServerMessage.Welcome}. The server drops datagrams with another one silently.
   */
  public int key;

  /** Sequence number of this datagram, 16 bits, wraps. */
  public int sequence;

  /** Whether any snapshot datagram was received; when false the acks are meaningless. */
  public boolean hasAck;

  /** Sequence number of the newest snapshot datagram received, 16 bits. */
  public int ackSequence;

  /** Bit i = snapshot datagram {@code ackSequence - 1 - i} was received. */
  public long ackBits;

  /** What the client wants to know of what is near its body: one of the three {@code NEAR}s. */
  public int near;

  /** Whether the client's newest comparison of what is near failed and isn't mended yet. */
  public boolean disagrees;

  /** The tick of that comparison, its lowest 16 bits. */
  public int disagreedTick;

  /** Tick of the newest input, {@code inputs[0]}. */
  public int newestTick;

  /**
   * How old the picture was that the player saw when it gave the newest input: ticks from the
   * picture to {@link #newestTick} in sixteenths, 0..4,095. Only with inputs.
   */
  public int viewDelay;

  /**
   * For how many ticks after {@link #newestTick} the newest input goes on, unless a newer datagram
   * says otherwise, 0..63: so a client that does nothing, or goes on doing the same, need not say
   * so in each tick. Only with inputs.
   */
  public int holdTicks;

  /** How many inputs follow, 0..{@link Limits#MAX_INPUTS}; 0 = keep-alive. */
  public int count;

  /**
   * Packed inputs (48 bits each, {@code Input.pack()}); {@code inputs[i]} is for tick {@code
   * newestTick - i}.
   */
  public final long[] inputs = new long[Limits.MAX_INPUTS];

  private final BitWriter writer = new BitWriter();
  private final BitReader reader = new BitReader();

  /** Creates an empty datagram. */
  public InputDatagram() {}

  /**
   * Writes this datagram.
   *
   * @param out at least {@link #MAX_BYTES} from {@code offset} on
   * @return number of bytes written
   * @throws IllegalArgumentException when {@link #count}, {@link #viewDelay}, {@link #holdTicks} or
   *     {@link #near} is outside its range
   */
  public int encode(byte[] out, int offset) {
    if (count < 0 || count > Limits.MAX_INPUTS) {
      throw new IllegalArgumentException(
          "inputs count=" + count + " is outside 0.." + Limits.MAX_INPUTS);
    }
    if (viewDelay < 0 || viewDelay > MAX_VIEW_DELAY) {
      throw new IllegalArgumentException(
          "viewDelay=" + viewDelay + " is outside 0.." + MAX_VIEW_DELAY);
    }
    if (holdTicks < 0 || holdTicks > MAX_HOLD_TICKS) {
      throw new IllegalArgumentException(
          "holdTicks=" + holdTicks + " is outside 0.." + MAX_HOLD_TICKS);
    }
    if (near < NEAR_NONE || near > NEAR_ALL) {
      throw new IllegalArgumentException("near=" + near + " is outside 0.." + NEAR_ALL);
    }
    BitWriter w = writer;
    w.reset(out, offset, MAX_BYTES);
    w.write(key, 32);
    w.write(sequence, 16);
    w.write(hasAck);
    if (hasAck) {
      w.write(ackSequence, 16);
      w.writeLong(ackBits);
    }
    w.write(near, 2);
    if (near != NEAR_NONE) {
      w.write(disagrees);
      if (disagrees) {
        w.write(disagreedTick, 16);
      }
    }
    w.write(count, 5);
    if (count > 0) {
      w.write(newestTick, 32);
      w.write(viewDelay, VIEW_DELAY_BITS);
      w.write(holdTicks, HOLD_BITS);
    }
    for (int i = 0; i < count; i++) {
      boolean same = i > 0 && ((inputs[i] ^ inputs[i - 1]) << (64 - INPUT_BITS)) == 0;
      if (i > 0) {
        w.write(same);
      }
      if (!same) {
        w.write((int) inputs[i], 32);
        w.write((int) (inputs[i] >>> 32), INPUT_BITS - 32);
      }
    }
    return w.bytes();
  }

  /**
   * Reads a datagram into this object. Never throws on the content.
   *
   * @return false when the bytes are not exactly one input datagram; this object is then undefined
   */
  public boolean decode(byte[] bytes, int offset, int length) {
    BitReader r = reader;
    r.reset(bytes, offset, length);
    key = r.read(32);
    sequence = r.read(16);
    hasAck = r.readBit();
    ackSequence = hasAck ? r.read(16) : 0;
    ackBits = hasAck ? r.readLong() : 0;
    near = r.read(2);
    if (near > NEAR_ALL) {
      return false;
    }
    disagrees = near != NEAR_NONE && r.readBit();
    disagreedTick = disagrees ? r.read(16) : 0;
    count = r.read(5);
    if (count > Limits.MAX_INPUTS) {
      return false;
    }
    newestTick = count > 0 ? r.read(32) : 0;
    viewDelay = count > 0 ? r.read(VIEW_DELAY_BITS) : 0;
    holdTicks = count > 0 ? r.read(HOLD_BITS) : 0;
    for (int i = 0; i < count; i++) {
      if (i > 0 && r.readBit()) {
        inputs[i] = inputs[i - 1];
      } else {
        long low = r.read(32) & 0xffffffffL;
        inputs[i] = low | ((long) r.read(INPUT_BITS - 32) << 32);
      }
    }
    return r.finished();
  }

  /** The key of an encoded datagram without decoding the rest; 0 when shorter than 4 bytes. */
  public static int peekKey(byte[] bytes, int offset, int length) {
    if (length < 4) {
      return 0;
    }
    return (bytes[offset] & 0xff)
        | (bytes[offset + 1] & 0xff) << 8
        | (bytes[offset + 2] & 0xff) << 16
        | bytes[offset + 3] << 24;
  }
}

package carom.net.protocol;

import carom.net.codec.BitReader;
import carom.net.codec.BitWriter;

/**
 * Datagram that a client sends at most once a tick, with its epoch, acknowledgements of snapshots
 * and its latest inputs. The object is mutable and reused: the client fills and encodes one, the
 * server decodes into one. Use it from one thread; it doesn't allocate.
 */
public final class InputDatagram {

  /** Largest encoded size in bytes. */
  public static final int MAX_BYTES = 128;

  /** Largest {@link #viewDelay}, in sixteenths of a tick. */
  public static final int MAX_VIEW_DELAY = 4_095;

  /** Value of {@link #near}: the client predicts nothing, or its own body alone. */
  public static final int NEAR_NONE = 0;

  /** Value of {@link #near}: the client predicts what its body touches or may touch soon. */
  public static final int NEAR_ISLAND = 1;

  /** Value of {@link #near}: the client predicts as much around its body as there is room for. */
  public static final int NEAR_ALL = 2;

  /** Largest {@link #holdTicks}, in ticks. */
  public static final int MAX_HOLD_TICKS = 63;

  private static final int INPUT_BITS = 48;
  private static final int VIEW_DELAY_BITS = 12;
  private static final int HOLD_BITS = 6;

  /**
   * Epoch of the last {@link ServerMessage.Welcome}, 0..7. The server drops a datagram of another
   * epoch silently.
   */
  public int epoch;

  /** Sequence number of this datagram, 16 bits, which wraps. */
  public int sequence;

  /**
   * True if the client has received a snapshot datagram. If false, the acknowledgements mean
   * nothing.
   */
  public boolean hasAck;

  /** Sequence number of the newest snapshot datagram received, 16 bits. */
  public int ackSequence;

  /** Bit set of older snapshot datagrams received: bit i stands for {@code ackSequence - 1 - i}. */
  public long ackBits;

  /**
   * Size of the predicted set that the client asks for: {@link #NEAR_NONE}, {@link #NEAR_ISLAND} or
   * {@link #NEAR_ALL}.
   */
  public int near;

  /** True if the client's newest comparison of the predicted set failed and isn't corrected yet. */
  public boolean disagrees;

  /** Tick of the failed comparison, lowest 16 bits. */
  public int disagreedTick;

  /** Tick of the newest input, {@code inputs[0]}. */
  public int newestTick;

  /**
   * Age of the picture that the player saw when giving the newest input, in sixteenths of a tick
   * before {@link #newestTick}, 0..4,095. It is sent only with inputs.
   */
  public int viewDelay;

  /**
   * Number of ticks after {@link #newestTick} for which the newest input stays valid, unless a
   * newer datagram replaces it, 0..63. So a client whose input doesn't change need not send one
   * each tick. It is sent only with inputs.
   */
  public int holdTicks;

  /**
   * Number of inputs that follow, 0..{@link ProtocolLimits#MAX_INPUTS}. A datagram with 0 inputs is
   * a keep-alive.
   */
  public int count;

  /**
   * Packed inputs of 48 bits each ({@code Input.pack()}); {@code inputs[i]} is for tick {@code
   * newestTick - i}.
   */
  public final long[] inputs = new long[ProtocolLimits.MAX_INPUTS];

  private final BitWriter writer = new BitWriter();
  private final BitReader reader = new BitReader();

  /** Creates an empty datagram. */
  public InputDatagram() {}

  /**
   * Writes this datagram.
   *
   * @param out has room for {@link #MAX_BYTES} from {@code offset} on
   * @return number of bytes written
   * @throws IllegalArgumentException when {@link #epoch}, {@link #count}, {@link #viewDelay},
   *     {@link #holdTicks} or {@link #near} is outside its range
   */
  public int encode(byte[] out, int offset) {
    if (count < 0 || count > ProtocolLimits.MAX_INPUTS) {
      throw new IllegalArgumentException(
          "inputs count=" + count + " is outside 0.." + ProtocolLimits.MAX_INPUTS);
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
    w.write(DatagramMark.ofState(epoch), DatagramMark.BITS);
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
   * Reads a datagram into this object. The content never makes it throw.
   *
   * @return false when the bytes are not exactly one input datagram; the fields are then undefined
   */
  public boolean decode(byte[] bytes, int offset, int length) {
    BitReader r = reader;
    r.reset(bytes, offset, length);
    int mark = r.read(DatagramMark.BITS);
    epoch = mark >> 1;
    if (mark != DatagramMark.ofState(epoch)) {
      return false;
    }
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
    if (count > ProtocolLimits.MAX_INPUTS) {
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
}

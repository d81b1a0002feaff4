package carom.net.frame;

import carom.net.protocol.ProtocolLimits;
import carom.net.seal.DatagramSealer;
import carom.net.seal.Encryption;
import carom.net.seal.ExchangeKey;
import carom.text.Texts;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;

/**
 * Layout of the frames around messages and datagrams. Over TCP, a frame is a 4-byte length of the
 * rest, a tag and the tag's fields. Over UDP, it is a tag and its fields. Numbers are big-endian.
 *
 * <pre>
 * tag              over       fields
 *  1 REGISTER_TCP  TCP s-&gt;c   link i32, token i64, UDP port u16, encryption u8, bits of work u8,
 *                             server's key 32       first frame
 *  2 REGISTER_UDP  UDP c-&gt;s   link i32, token i64, solution i64, 14 zeros   repeated until answered
 *                  TCP s-&gt;c   none                  the UDP address is known now
 *  9 KEY_OFFER     TCP c-&gt;s   encryption u8, new key 32, tag 16
 * 10 KEY_ANSWER    TCP s-&gt;c   new key 32, tag 16  the server's last frame in the clear
 * 11 KEY_CONFIRM   TCP c-&gt;s   none                  the client's first sealed frame
 *  7 CHALLENGE     UDP s-&gt;c   nonce i64             one for each datagram that is no shorter
 *  8 ANSWER        UDP c-&gt;s   nonce i64             the link is open: datagrams pass in both directions
 *  3 KEEP_ALIVE    both, both none, UDP c-&gt;s 8 zeros   TCP each 2 s of silence, UDP c-&gt;s each 1 s of silence
 *  4 MESSAGE       TCP, both  codec's bytes
 *  5 BYE           TCP, both  UTF-8 text, at most 512 bytes; the receiver closes
 *  6 DATAGRAM      UDP, both  payload, 1..1,200 bytes
 * 12 STREAM        TCP c-&gt;s   solution i64          instead of REGISTER_UDP or ANSWER: UDP is blocked
 * 13 STREAMED      TCP, both  hears UDP u8, received u16, payload 0..1,200   a datagram over TCP
 * </pre>
 *
 * <p>All frames behind KEY_ANSWER from the server and behind KEY_OFFER from the client are sealed:
 * over TCP tag and fields, see {@link carom.net.seal.StreamSeal}; over UDP all but REGISTER_UDP,
 * with the tag in the clear, see {@link carom.net.seal.DatagramSealer}.
 *
 * <p>The challenge proves that an address receives what the server sends. So an attacker can't aim
 * a stream of snapshots at another machine, a client behind a one-way firewall learns why it can't
 * connect, and a client whose address changes goes on. An address that hasn't proven itself gets no
 * more bytes than it sent: each challenge answers one datagram that is at least as long.
 */
public final class Frame {
  public static final byte REGISTER_TCP = 1;
  public static final byte REGISTER_UDP = 2;
  public static final byte KEEP_ALIVE = 3;
  public static final byte MESSAGE = 4;
  public static final byte BYE = 5;
  public static final byte DATAGRAM = 6;
  public static final byte CHALLENGE = 7;
  public static final byte ANSWER = 8;
  public static final byte KEY_OFFER = 9;
  public static final byte KEY_ANSWER = 10;
  public static final byte KEY_CONFIRM = 11;
  public static final byte STREAM = 12;
  public static final byte STREAMED = 13;

  /** Least bits of work that a client proves whose datagrams go over TCP. */
  public static final int STREAM_WORK_BITS = 12;

  /** Bytes of STREAM's fields. */
  public static final int SOLUTION_BYTES = 8;

  /** Bytes in front of STREAMED's payload. */
  public static final int STREAMED_HEAD_BYTES = 3;

  /** Bytes of the length in front of a TCP frame. */
  public static final int LENGTH_BYTES = 4;

  /** Bytes of REGISTER_TCP's fields. */
  public static final int GREETING_BYTES = 4 + 8 + 2 + 1 + 1 + ExchangeKey.BYTES;

  /** Bytes of the fields of CHALLENGE and ANSWER, and of a client's KEEP_ALIVE by UDP. */
  public static final int NONCE_BYTES = 8;

  /** Bytes of CHALLENGE on the wire. A shorter datagram isn't answered by one. */
  public static final int CHALLENGE_BYTES = 1 + NONCE_BYTES + DatagramSealer.EXTRA_BYTES;

  /** Bytes of REGISTER_UDP from a client: as many as those of the answer. */
  public static final int REGISTRATION_BYTES = CHALLENGE_BYTES;

  /** Largest number of payload bytes in a DATAGRAM. */
  public static final int MAX_PAYLOAD_BYTES = ProtocolLimits.MAX_DATAGRAM_BYTES;

  /** Largest number of bytes of a datagram on the wire. */
  public static final int MAX_DATAGRAM_BYTES = 1 + MAX_PAYLOAD_BYTES + DatagramSealer.EXTRA_BYTES;

  /**
   * Size of the server's receive buffer in bytes. It holds any valid datagram and shows that a
   * longer one is too long.
   */
  public static final int SERVER_BUFFER_BYTES = ProtocolLimits.MAX_DATAGRAM_BYTES + 80;

  /** Size of the client's receive buffer in bytes. It holds any frame from a server. */
  public static final int CLIENT_BUFFER_BYTES = ProtocolLimits.MAX_SERVER_MESSAGE_BYTES + 64;

  /** Time without a TCP write after which a KEEP_ALIVE is sent, ms. */
  public static final int KEEP_ALIVE_MILLIS = 2_000;

  /** Time that a side waits for the other side to close after it sent BYE, ns. */
  public static final long LINGER_NANOS = 400_000_000L;

  /** Fields of a frame that has none. */
  public static final byte[] NO_FIELDS = {};

  private Frame() {}

  /** An outgoing frame. It is mutable, so that a stream of datagrams needs one object only. */
  public static final class Payload {
    private byte tag;
    private byte[] bytes;
    private int offset;
    private int length;

    /** Sets tag and fields. It keeps the array and does not copy it. */
    public Payload set(byte tag, byte[] bytes, int offset, int length) {
      this.tag = tag;
      this.bytes = bytes;
      this.offset = offset;
      this.length = length;
      return this;
    }

    /** Returns the tag. */
    public byte tag() {
      return tag;
    }

    /**
     * Returns the bytes that the unsealed frame takes in a TCP write buffer, including its length
     * field.
     */
    public int tcpBytes() {
      return LENGTH_BYTES + 1 + length;
    }

    /** Writes tag and fields. */
    public void write(ByteBuffer buffer) {
      buffer.put(tag).put(bytes, offset, length);
    }
  }

  /** Returns the frame of an encoded message. */
  public static Payload message(byte[] bytes) {
    return new Payload().set(MESSAGE, bytes, 0, bytes.length);
  }

  /** Returns the BYE frame with a reason. */
  public static Payload bye(String reason) {
    byte[] bytes = reason.getBytes(StandardCharsets.UTF_8);
    return new Payload().set(BYE, bytes, 0, Math.min(bytes.length, ProtocolLimits.MAX_TEXT_BYTES));
  }

  /** Returns the fields of REGISTER_TCP. */
  public static byte[] greeting(
      int link, long token, int udpPort, Encryption encryption, int workBits, byte[] serverKey) {
    return ByteBuffer.allocate(GREETING_BYTES)
        .putInt(link)
        .putLong(token)
        .putShort((short) udpPort)
        .put(encryption.code())
        .put((byte) workBits)
        .put(serverKey)
        .array();
  }

  /** Returns the fields of a client's REGISTER_UDP. */
  public static byte[] registration(int link, long token, long solution) {
    return ByteBuffer.allocate(REGISTRATION_BYTES - 1)
        .putInt(link)
        .putLong(token)
        .putLong(solution)
        .array();
  }

  /** Returns the work that a client proves whose datagrams go over TCP, bits. */
  public static int streamWorkBits(int greetingBits) {
    return Math.max(greetingBits, STREAM_WORK_BITS);
  }

  /** Returns a STREAMED frame of a datagram, or of none if the length is 0. */
  public static Payload streamed(DatagramPath path, byte[] bytes, int offset, int length) {
    byte[] fields = new byte[STREAMED_HEAD_BYTES + length];
    path.write(fields, length > 0, System.nanoTime());
    System.arraycopy(bytes, offset, fields, STREAMED_HEAD_BYTES, length);
    return new Payload().set(STREAMED, fields, 0, fields.length);
  }

  /**
   * Reads the head of STREAMED's fields and leaves the buffer at the payload.
   *
   * @return false when the frame is invalid
   */
  public static boolean readStreamed(DatagramPath path, ByteBuffer fields, long now) {
    int payload = fields.remaining() - STREAMED_HEAD_BYTES;
    if (payload < 0 || payload > MAX_PAYLOAD_BYTES) {
      return false;
    }
    boolean hears = fields.get() != 0;
    return path.read(hears, Short.toUnsignedInt(fields.getShort()), payload > 0, now);
  }

  /** Returns the fields of CHALLENGE or ANSWER. */
  public static byte[] nonce(long nonce) {
    return ByteBuffer.allocate(8).putLong(nonce).array();
  }

  /**
   * Returns the text of a BYE whose tag has been read, as one line without invisible characters.
   */
  public static String byeText(ByteBuffer buffer) {
    byte[] bytes = new byte[Math.min(buffer.remaining(), ProtocolLimits.MAX_TEXT_BYTES)];
    buffer.get(bytes);
    return Texts.clean(new String(bytes, StandardCharsets.UTF_8)).strip();
  }
}

package carom.net.kryo;

import carom.net.protocol.Limits;
import com.esotericsoftware.kryonet.Connection;
import com.esotericsoftware.kryonet.FrameworkMessage.KeepAlive;
import com.esotericsoftware.kryonet.FrameworkMessage.RegisterTCP;
import com.esotericsoftware.kryonet.FrameworkMessage.RegisterUDP;
import com.esotericsoftware.kryonet.Serialization;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;

/**
 * The bytes around messages and datagrams. Over TCP a frame is a 4-byte big-endian length (of what
 * follows), a tag and the tag's fields; a datagram is a tag and its fields. Numbers are big-endian.
 *
 * <pre>
 * tag             over          fields
 * 1 REGISTER_TCP  TCP s->c      id i32, token i64   first frame; the token binds UDP to this connection
 * 2 REGISTER_UDP  UDP c->s      id i32, token i64   repeated each 100 ms until answered
 *                 TCP s->c      none                the UDP address is known now
 * 3 KEEP_ALIVE    both, both    none                TCP each 2 s of silence, UDP c->s each 1 s of silence
 * 4 MESSAGE       TCP, both     codec's bytes
 * 5 BYE           TCP, both     UTF-8 text, at most 512 bytes; the receiver closes
 * 6 DATAGRAM      UDP, both     payload, 1..1,200 bytes
 * 7 CHALLENGE     UDP s->c      nonce i64           repeated each 100 ms until answered
 * 8 ANSWER        UDP c->s      nonce i64           the link is open: datagrams pass in both directions
 * </pre>
 *
 * <p>The challenge is ours, not KryoNet's: it proves that the address the client registered
 * receives what we send, so that nobody can aim a stream of snapshots at somebody else, and a
 * client behind a one-way firewall is told so.
 */
final class Frame {
  static final byte REGISTER_TCP = 1;
  static final byte REGISTER_UDP = 2;
  static final byte KEEP_ALIVE = 3;
  static final byte MESSAGE = 4;
  static final byte BYE = 5;
  static final byte DATAGRAM = 6;
  static final byte CHALLENGE = 7;
  static final byte ANSWER = 8;

  /** Bytes of the length in front of a TCP frame. */
  static final int LENGTH_BYTES = 4;

  /** Bytes of REGISTER_TCP, and of REGISTER_UDP from a client. */
  static final int REGISTRATION_BYTES = 1 + 4 + 8;

  /** Bytes of CHALLENGE and ANSWER. */
  static final int NONCE_BYTES = 1 + 8;

  /** Payload bytes of a DATAGRAM. */
  static final int MAX_PAYLOAD_BYTES = Limits.MAX_DATAGRAM_BYTES;

  /** Buffer that holds any datagram, and shows that a longer one is too long. */
  static final int SERVER_BUFFER_BYTES = Limits.MAX_DATAGRAM_BYTES + 80;

  /** Buffer that holds any frame from a server. */
  static final int CLIENT_BUFFER_BYTES = Limits.MAX_SERVER_MESSAGE_BYTES + 64;

  /** Milliseconds without a TCP write after which a KEEP_ALIVE goes out. */
  static final int KEEP_ALIVE_MILLIS = 2_000;

  /** Nanoseconds that a side which said BYE waits for the other side to close. */
  static final long LINGER_NANOS = 400_000_000L;

  /**
   * What reading gives KryoNet for everything it has no business with; never null, which it takes
   * for "incomplete".
   */
  static final Object HANDLED = new Object();

  /** What a tag without fields has behind it. */
  static final byte[] NO_FIELDS = {};

  private Frame() {}

  /**
   * A frame of ours on its way out. Mutable, so that a stream of datagrams needs one object only.
   */
  static final class Payload {
    private byte tag;
    private byte[] bytes;
    private int offset;
    private int length;

    Payload set(byte tag, byte[] bytes, int offset, int length) {
      this.tag = tag;
      this.bytes = bytes;
      this.offset = offset;
      this.length = length;
      return this;
    }

    /** Tag and fields. */
    void write(ByteBuffer buffer) {
      buffer.put(tag).put(bytes, offset, length);
    }
  }

  static Payload message(byte[] bytes) {
    return new Payload().set(MESSAGE, bytes, 0, bytes.length);
  }

  static Payload bye(String reason) {
    byte[] bytes = reason.getBytes(StandardCharsets.UTF_8);
    return new Payload().set(BYE, bytes, 0, Math.min(bytes.length, Limits.MAX_TEXT_BYTES));
  }

  /** The fields of CHALLENGE and ANSWER. */
  static byte[] nonce(long nonce) {
    return ByteBuffer.allocate(8).putLong(nonce).array();
  }

  /** The text of a BYE whose tag has been read, as one line without control characters. */
  static String byeText(ByteBuffer buffer) {
    byte[] bytes = new byte[Math.min(buffer.remaining(), Limits.MAX_TEXT_BYTES)];
    buffer.get(bytes);
    return new String(bytes, StandardCharsets.UTF_8).replaceAll("\\p{Cntrl}", " ").strip();
  }

  /** Bytes that a frame takes in a TCP write buffer. */
  static int tcpBytes(Object frame) {
    if (frame instanceof Payload payload) {
      return LENGTH_BYTES + 1 + payload.length;
    }
    return LENGTH_BYTES + REGISTRATION_BYTES;
  }

  /** Where frames end up: writing is the same on both sides, reading isn't. */
  abstract static class Codec implements Serialization {

    /** The token of a connection: made by the server, learned by the client. */
    abstract long token(Connection connection);

    /** Whether this side is the server. */
    abstract boolean server();

    @Override
    public final void write(Connection connection, ByteBuffer buffer, Object frame) {
      if (frame instanceof Payload payload) {
        payload.write(buffer);
      } else if (frame instanceof KeepAlive) {
        buffer.put(KEEP_ALIVE);
      } else if (frame instanceof RegisterTCP register && server()) {
        buffer.put(REGISTER_TCP).putInt(register.connectionID).putLong(token(connection));
      } else if (frame instanceof RegisterUDP && server()) {
        buffer.put(REGISTER_UDP);
      } else if (frame instanceof RegisterUDP register) {
        buffer.put(REGISTER_UDP).putInt(register.connectionID).putLong(token(connection));
      } else {
        throw new IllegalArgumentException("no frame for " + frame.getClass().getName());
      }
    }

    @Override
    public final int getLengthLength() {
      return LENGTH_BYTES;
    }

    @Override
    public final void writeLength(ByteBuffer buffer, int length) {
      buffer.putInt(length);
    }

    @Override
    public final int readLength(ByteBuffer buffer) {
      return buffer.getInt();
    }
  }
}

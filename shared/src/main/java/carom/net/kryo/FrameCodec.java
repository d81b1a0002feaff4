package carom.net.kryo;

import carom.net.frame.Frame;
import carom.net.seal.StreamSeal;
import com.esotericsoftware.kryonet.Connection;
import com.esotericsoftware.kryonet.FrameworkMessage.KeepAlive;
import com.esotericsoftware.kryonet.FrameworkMessage.RegisterTCP;
import com.esotericsoftware.kryonet.FrameworkMessage.RegisterUDP;
import com.esotericsoftware.kryonet.Serialization;
import java.nio.ByteBuffer;

/** Codec between KryoNet's objects and frames. Writing is the same on both sides; reading isn't. */
public abstract class FrameCodec implements Serialization {
  /**
   * Result of reading a frame that KryoNet need not know about. It is not null, because KryoNet
   * takes null for "incomplete".
   */
  public static final Object HANDLED = new Object();

  /** Returns the bytes that a frame takes in a TCP write buffer at most. */
  public static int tcpBytes(Object frame) {
    int plain =
        frame instanceof Frame.Payload payload
            ? payload.tcpBytes()
            : Frame.LENGTH_BYTES + 1 + Frame.GREETING_BYTES;
    return plain + StreamSeal.EXTRA_BYTES;
  }

  /**
   * Writes the fields of KryoNet's own registration, which differ between the sides.
   *
   * @param buffer behind the tag
   */
  protected abstract void writeRegistration(
      Connection connection, ByteBuffer buffer, Object registration);

  /** Returns the seal of what leaves by a connection's TCP, or null while that is in the clear. */
  protected abstract StreamSeal streamSeal(Connection connection);

  /**
   * {@inheritDoc}
   *
   * <p>KryoNet calls it under the lock of the connection's stream, so sealed frames leave in the
   * order of their counters.
   */
  @Override
  public final void write(Connection connection, ByteBuffer buffer, Object frame) {
    StreamSeal seal = streamSeal(connection);
    int start = buffer.position();
    writePlain(connection, buffer, frame);
    if (seal != null) {
      int length = buffer.position() - start;
      seal.seal(buffer.array(), buffer.arrayOffset() + start, length);
      buffer.position(buffer.position() + StreamSeal.EXTRA_BYTES);
    }
    if (frame instanceof Frame.Payload payload) {
      written(connection, payload.tag());
    }
  }

  /** Learns that a frame is in the stream's buffer, under the lock of the stream. */
  protected void written(Connection connection, byte tag) {
    // a client needs nothing
  }

  private void writePlain(Connection connection, ByteBuffer buffer, Object frame) {
    if (frame instanceof Frame.Payload payload) {
      payload.write(buffer);
    } else if (frame instanceof KeepAlive) {
      buffer.put(Frame.KEEP_ALIVE);
    } else if (frame instanceof RegisterTCP) {
      writeRegistration(connection, buffer.put(Frame.REGISTER_TCP), frame);
    } else if (frame instanceof RegisterUDP) {
      writeRegistration(connection, buffer.put(Frame.REGISTER_UDP), frame);
    } else {
      throw new IllegalArgumentException("no frame for " + frame.getClass().getName());
    }
  }

  @Override
  public final int getLengthLength() {
    return Frame.LENGTH_BYTES;
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

package carom.net.kryo;

import carom.net.frame.Frame;
import com.esotericsoftware.kryonet.Connection;
import com.esotericsoftware.kryonet.FrameworkMessage.KeepAlive;
import com.esotericsoftware.kryonet.FrameworkMessage.RegisterTCP;
import com.esotericsoftware.kryonet.FrameworkMessage.RegisterUDP;
import com.esotericsoftware.kryonet.Serialization;
import java.nio.ByteBuffer;

/** Codec between KryoNet's objects and frames. Writing is the same on both sides; reading isn't. */
abstract class FrameCodec implements Serialization {
  /**
   * Result of reading a frame that KryoNet need not know about. It is not null, because KryoNet
   * takes null for "incomplete".
   */
  static final Object HANDLED = new Object();

  /** Returns the bytes that a frame takes in a TCP write buffer. */
  static int tcpBytes(Object frame) {
    return frame instanceof Frame.Payload payload
        ? payload.tcpBytes()
        : Frame.LENGTH_BYTES + Frame.REGISTRATION_BYTES;
  }

  /** Returns the token of a connection, which the server makes and the client receives. */
  abstract long token(Connection connection);

  /** Returns whether this side is the server. */
  abstract boolean server();

  @Override
  public final void write(Connection connection, ByteBuffer buffer, Object frame) {
    if (frame instanceof Frame.Payload payload) {
      payload.write(buffer);
    } else if (frame instanceof KeepAlive) {
      buffer.put(Frame.KEEP_ALIVE);
    } else if (frame instanceof RegisterTCP register && server()) {
      buffer.put(Frame.REGISTER_TCP).putInt(register.connectionID).putLong(token(connection));
    } else if (frame instanceof RegisterUDP && server()) {
      buffer.put(Frame.REGISTER_UDP);
    } else if (frame instanceof RegisterUDP register) {
      buffer.put(Frame.REGISTER_UDP).putInt(register.connectionID).putLong(token(connection));
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

package carom.net.kryo;

import carom.net.protocol.ProtocolLimits;
import carom.text.Texts;
import com.esotericsoftware.kryo.Kryo;
import com.esotericsoftware.kryo.Serializer;
import com.esotericsoftware.kryo.io.Input;
import com.esotericsoftware.kryo.io.KryoBufferUnderflowException;
import com.esotericsoftware.kryo.io.Output;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Objects;

/**
 * Base of the serializers of messages, which are never null and immutable, and of their fields.
 * What is out of a range throws IllegalArgumentException on both sides.
 *
 * @param <T> the message
 */
abstract class MessageSerializer<T> extends Serializer<T> {
  /** Creates a serializer. */
  protected MessageSerializer() {
    super(false, true);
  }

  @Override
  public final T read(Kryo kryo, Input in, Class<? extends T> type) {
    return read(in);
  }

  @Override
  public final void write(Kryo kryo, Output out, T message) {
    write(out, message);
  }

  /** Writes a message. */
  protected abstract void write(Output out, T message);

  /** Reads a message. */
  protected abstract T read(Input in);

  /** Returns a player's id that is certain to be one. */
  protected static int playerId(int id) {
    return inRange("playerId", id, 0, ProtocolLimits.MAX_PLAYERS - 1);
  }

  /** Returns a value that is certain to be in a range, both ends included. */
  protected static int inRange(String name, int value, int min, int max) {
    if (value < min || value > max) {
      throw new IllegalArgumentException(
          name + "=" + value + " must be from " + min + " to " + max);
    }
    return value;
  }

  /** Writes an integer of a range, both ends included. */
  protected static void writeInt(Output out, String name, int value, int min, int max) {
    out.writeVarInt(inRange(name, value, min, max), true);
  }

  /** Reads what {@link #writeInt} wrote. */
  protected static int readInt(Input in, String name, int min, int max) {
    return inRange(name, in.readVarInt(true), min, max);
  }

  /** Writes bytes and, before them, how many they are. */
  protected static void writeBlock(Output out, byte[] bytes, int min, int max) {
    writeInt(out, "bytes", bytes.length, min, max);
    out.writeBytes(bytes);
  }

  /** Reads what {@link #writeBlock} wrote. */
  protected static byte[] readBlock(Input in, int min, int max) {
    return readBytes(in, readInt(in, "bytes", min, max));
  }

  /** Writes a text: its length in bytes and UTF-8. */
  protected static void writeText(Output out, String name, String text, int maxBytes) {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    writeInt(out, name + ".bytes", bytes.length, 0, maxBytes);
    out.writeBytes(bytes);
  }

  /** Reads a text, which may come to a screen or a terminal: without what can't be shown there. */
  protected static String readText(Input in, String name, int maxBytes) {
    int length = readInt(in, name + ".bytes", 0, maxBytes);
    ByteBuffer bytes = ByteBuffer.wrap(readBytes(in, length));
    return Texts.clean(Objects.requireNonNull(Texts.ofUtf8(bytes), name));
  }

  /** Reads bytes, and allocates nothing if there aren't so many. */
  private static byte[] readBytes(Input in, int length) {
    if (length > in.limit() - in.position()) {
      throw new KryoBufferUnderflowException("length=" + length);
    }
    return in.readBytes(length);
  }
}

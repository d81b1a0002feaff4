package carom.fuzz;

import carom.net.kryo.KryoMessageCodec;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.Protocol;
import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.ServerMessage;
import java.util.Arrays;
import java.util.List;

/** Messages over TCP, of both sides. What is read must be writable, and reads as the same again. */
final class MessageTarget implements FuzzTarget {
  private final KryoMessageCodec codec = new KryoMessageCodec();

  @Override
  public void take(byte[] data) {
    Object message = codec.decode(data, 0, data.length);
    if (message == null) {
      return;
    }
    byte[] written = codec.encode(message);
    int limit =
        message instanceof ClientMessage
            ? ProtocolLimits.MAX_CLIENT_MESSAGE_BYTES
            : ProtocolLimits.MAX_SERVER_MESSAGE_BYTES;
    if (written.length > limit) {
      throw new AssertionError(message + " has bytes=" + written.length + ", limit " + limit);
    }
    byte[] again = codec.encode(codec.decode(written, 0, written.length));
    if (!Arrays.equals(written, again)) {
      throw new AssertionError(message + " changed when it was written and read");
    }
  }

  @Override
  public List<byte[]> seeds() {
    return List.of(
        codec.encode(new ClientMessage.Hello(Protocol.VERSION, 5, "player", 9)),
        codec.encode(new ClientMessage.LevelRequest(7, 1_000)),
        codec.encode(new ClientMessage.Ready(7, 5)),
        codec.encode(new ClientMessage.Leave()),
        codec.encode(new ClientMessage.Watch(1, -5, 255)),
        codec.encode(new ClientMessage.Look(1.5f, -2, 0, 3, ClientMessage.Look.NOBODY)),
        codec.encode(new ServerMessage.LevelChunk(4_096, new byte[] {1, 2, 3})),
        codec.encode(new ServerMessage.Notice("the arena closes")),
        codec.encode(new ServerMessage.Roster(List.of())),
        codec.encode(new ServerMessage.RoomList(0, List.of())),
        codec.encode(new ServerMessage.Watching(65_535)));
  }
}

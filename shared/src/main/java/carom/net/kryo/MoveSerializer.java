package carom.net.kryo;

import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.ServerMessage.Move;
import com.esotericsoftware.kryo.io.Input;
import com.esotericsoftware.kryo.io.Output;

/** Serializer of {@link Move}. */
final class MoveSerializer extends MessageSerializer<Move> {
  /** Creates a serializer. */
  public MoveSerializer() {}

  @Override
  protected void write(Output out, Move m) {
    writeText(out, "server", m.server(), ProtocolLimits.MAX_ADDRESS_BYTES);
    writeText(out, "fingerprint", m.fingerprint(), ProtocolLimits.MAX_FINGERPRINT_BYTES);
    writeText(out, "room", m.room(), ProtocolLimits.MAX_ROOM_NAME_BYTES);
    writeText(out, "ticket", m.ticket(), ProtocolLimits.MAX_TOKEN_BYTES);
  }

  @Override
  protected Move read(Input in) {
    return new Move(
        readText(in, "server", ProtocolLimits.MAX_ADDRESS_BYTES),
        readText(in, "fingerprint", ProtocolLimits.MAX_FINGERPRINT_BYTES),
        readText(in, "room", ProtocolLimits.MAX_ROOM_NAME_BYTES),
        readText(in, "ticket", ProtocolLimits.MAX_TOKEN_BYTES));
  }
}

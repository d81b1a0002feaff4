package carom.net.kryo;

import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.ServerMessage.Redirect;
import com.esotericsoftware.kryo.io.Input;
import com.esotericsoftware.kryo.io.Output;

/** Serializer of {@link Redirect}. */
final class RedirectSerializer extends MessageSerializer<Redirect> {
  /** Creates a serializer. */
  public RedirectSerializer() {}

  @Override
  protected void write(Output out, Redirect m) {
    writeText(out, "server", m.server(), ProtocolLimits.MAX_ADDRESS_BYTES);
    writeText(out, "fingerprint", m.fingerprint(), ProtocolLimits.MAX_FINGERPRINT_BYTES);
    writeText(out, "room", m.room(), ProtocolLimits.MAX_ROOM_NAME_BYTES);
    writeText(out, "token", m.token(), ProtocolLimits.MAX_TOKEN_BYTES);
  }

  @Override
  protected Redirect read(Input in) {
    return new Redirect(
        readText(in, "server", ProtocolLimits.MAX_ADDRESS_BYTES),
        readText(in, "fingerprint", ProtocolLimits.MAX_FINGERPRINT_BYTES),
        readText(in, "room", ProtocolLimits.MAX_ROOM_NAME_BYTES),
        readText(in, "token", ProtocolLimits.MAX_TOKEN_BYTES));
  }
}

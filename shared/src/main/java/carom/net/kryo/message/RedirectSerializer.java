package carom.net.kryo.message;

import carom.net.protocol.Limits;
import carom.net.protocol.ServerMessage.Redirect;
import com.esotericsoftware.kryo.io.Input;
import com.esotericsoftware.kryo.io.Output;

/** Serializer of {@link Redirect}. */
public final class RedirectSerializer extends MessageSerializer<Redirect> {
  /** Creates a serializer. */
  public RedirectSerializer() {}

  @Override
  protected void write(Output out, Redirect m) {
    writeText(out, "server", m.server(), Limits.MAX_ADDRESS_BYTES);
    writeText(out, "fingerprint", m.fingerprint(), Limits.MAX_FINGERPRINT_BYTES);
    writeText(out, "room", m.room(), Limits.MAX_ROOM_NAME_BYTES);
    writeText(out, "token", m.token(), Limits.MAX_TOKEN_BYTES);
  }

  @Override
  protected Redirect read(Input in) {
    return new Redirect(
        readText(in, "server", Limits.MAX_ADDRESS_BYTES),
        readText(in, "fingerprint", Limits.MAX_FINGERPRINT_BYTES),
        readText(in, "room", Limits.MAX_ROOM_NAME_BYTES),
        readText(in, "token", Limits.MAX_TOKEN_BYTES));
  }
}

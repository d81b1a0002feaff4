package carom.net.kryo;

import carom.net.transport.MessageCodec;

/**
 * The protocol's messages as bytes: Kryo from the server, a fixed layout from the client. Any
 * thread.
 */
public final class KryoMessageCodec implements MessageCodec {

  /** Creates a codec; one per transport is enough. */
  public KryoMessageCodec() {}

  @Override
  public byte[] encode(Object message) {
    throw new UnsupportedOperationException("soon");
  }

  @Override
  public Object decode(byte[] bytes, int offset, int length) {
    throw new UnsupportedOperationException("soon");
  }
}

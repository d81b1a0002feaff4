package carom.net.kryo;

import carom.net.transport.ClientTransport;

/** The promises of {@link KryoTransportTest}, by clients that share a thread. */
final class CrowdTransportTest extends KryoTransportTest {
  @Override
  ClientTransport clients(int connectMillis) {
    return new CrowdTransport(connectMillis);
  }
}

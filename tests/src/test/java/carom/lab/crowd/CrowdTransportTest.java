package carom.lab.crowd;

import carom.net.kryo.KryoTransportTest;
import carom.net.transport.ClientTransport;

/** The promises of {@link KryoTransportTest}, by clients that share a thread. */
final class CrowdTransportTest extends KryoTransportTest {
  @Override
  protected ClientTransport clients(int connectMillis) {
    return new CrowdTransport(connectMillis);
  }
}

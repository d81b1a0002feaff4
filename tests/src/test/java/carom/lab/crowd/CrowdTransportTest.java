package carom.lab.crowd;

import carom.net.kryo.KryoTransportTest;
import carom.net.transport.ClientTransport;

/** Runs the tests of {@link KryoTransportTest} with clients that share a thread. */
final class CrowdTransportTest extends KryoTransportTest {
  @Override
  protected ClientTransport clients(int connectMillis) {
    return new CrowdTransport(connectMillis);
  }
}

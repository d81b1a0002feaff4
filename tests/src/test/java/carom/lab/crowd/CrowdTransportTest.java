package carom.lab.crowd;

import carom.net.kryo.KryoTransportTest;
import carom.net.transport.ClientTransport;
import carom.suite.Needs;

/** Runs the tests of {@link KryoTransportTest} with clients that share a thread. */
@Needs("sockets")
final class CrowdTransportTest extends KryoTransportTest {
  @Override
  protected ClientTransport clients(int connectMillis) {
    return new CrowdTransport(connectMillis);
  }
}

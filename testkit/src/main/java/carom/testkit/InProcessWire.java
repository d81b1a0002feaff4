package carom.testkit;

import carom.net.kryo.KryoMessageCodec;
import carom.net.transport.ClientTransport;
import carom.net.transport.InProcessNetwork;
import carom.net.transport.Link;
import carom.net.transport.ServerTransport;

/** A wire in memory and virtual time: real bytes, but no sockets, no threads and no sleep. */
final class InProcessWire implements Wire {
  private static final long SLICE_NS = 2_000_000;

  private final KryoMessageCodec codec = new KryoMessageCodec();
  private InProcessNetwork network = new InProcessNetwork(codec);

  private final ClientTransport client =
      new ClientTransport() {
        @Override
        public Link connect(String host, int tcpPort, int udpPort) {
          return network.client().connect(host, tcpPort, udpPort);
        }

        @Override
        public void close() {}
      };

  @Override
  public ServerTransport serve() {
    network = new InProcessNetwork(codec);
    return network.server();
  }

  @Override
  public ClientTransport client() {
    return client;
  }

  @Override
  public int tcpPort() {
    return 0;
  }

  @Override
  public int udpPort() {
    return 0;
  }

  @Override
  public long advance(long nowNs) {
    return nowNs + SLICE_NS;
  }

  @Override
  public void close() {}
}

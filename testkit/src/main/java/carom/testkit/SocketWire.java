package carom.testkit;

import carom.net.kryo.KryoClientTransport;
import carom.net.kryo.server.KryoServerTransport;
import carom.net.transport.ClientTransport;
import carom.net.transport.ServerTransport;
import java.util.concurrent.locks.LockSupport;

/** A wire of KryoNet over loopback, on free ports and in real time. */
final class SocketWire implements Wire {
  private static final long NAP_NS = 1_000_000;

  private final KryoClientTransport client = new KryoClientTransport();
  private int tcpPort;
  private int udpPort;

  @Override
  public ServerTransport serve() {
    KryoServerTransport server = new KryoServerTransport(tcpPort, udpPort);
    tcpPort = server.tcpPort(); // a server that starts again keeps its address
    udpPort = server.udpPort();
    return server;
  }

  @Override
  public ClientTransport client() {
    return client;
  }

  @Override
  public int tcpPort() {
    return tcpPort;
  }

  @Override
  public int udpPort() {
    return udpPort;
  }

  @Override
  public long advance(long nowNs) {
    LockSupport.parkNanos(NAP_NS);
    return System.nanoTime();
  }

  @Override
  public void close() {
    client.close();
  }
}

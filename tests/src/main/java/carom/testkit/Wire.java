package carom.testkit;

import carom.net.transport.ClientTransport;
import carom.net.transport.ServerTransport;

/** What lies between a {@link Stepper}'s server and its clients, and whose time passes there. */
interface Wire extends AutoCloseable {
  /** Opens the server's side; may be called again once the side before is closed. */
  ServerTransport serve();

  /** Opens links to the server that serves now; refused when there is none. */
  ClientTransport client();

  /** TCP port for clients; 0 where there are none. */
  int tcpPort();

  /** UDP port for clients; 0 where there are none. */
  int udpPort();

  /** Lets a slice of time pass and tells the new time, nanoseconds. */
  long advance(long nowNs);

  @Override
  void close();
}

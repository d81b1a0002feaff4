package carom.testkit;

import carom.net.transport.ClientTransport;
import carom.net.transport.ServerTransport;

/** The network between a {@link Stepper}'s server and its clients, and its clock. */
interface Wire extends AutoCloseable {
  /** Opens the server's side. It can be opened again after it was closed. */
  ServerTransport serve();

  /** Returns the clients' side, which opens links to the present server. Fails if there is none. */
  ClientTransport client();

  /** Returns the TCP port for clients; 0 without sockets. */
  int tcpPort();

  /** Returns the UDP port for clients; 0 without sockets. */
  int udpPort();

  /** Lets a slice of time pass and returns the new time, ns. */
  long advance(long nowNs);

  @Override
  void close();
}

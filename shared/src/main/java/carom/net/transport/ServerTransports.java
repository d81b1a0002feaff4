package carom.net.transport;

import java.util.ArrayList;
import java.util.List;

/**
 * Several server transports as one: a server's own ports and its further doors. Links are accepted
 * in turn, so that a crowd at one door doesn't keep the others waiting.
 */
public final class ServerTransports implements ServerTransport {
  private final List<ServerTransport> all;
  private int turn; // the accepting thread only

  private ServerTransports(List<ServerTransport> all) {
    this.all = all;
  }

  /**
   * Combines transports. They are closed with the result.
   *
   * @param first the one whose ports are the server's
   * @param others may be empty; the result is {@code first} then
   */
  public static ServerTransport of(ServerTransport first, List<? extends ServerTransport> others) {
    if (others.isEmpty()) {
      return first;
    }
    List<ServerTransport> all = new ArrayList<>();
    all.add(first);
    all.addAll(others);
    return new ServerTransports(all);
  }

  @Override
  public Link accept() {
    for (int i = 0; i < all.size(); i++) {
      turn = (turn + 1) % all.size();
      Link link = all.get(turn).accept();
      if (link != null) {
        return link;
      }
    }
    return null;
  }

  /** Tells each transport; the server must look if one of them doesn't tell. */
  @Override
  public boolean onOpened(Runnable wake) {
    boolean allTell = true;
    for (ServerTransport transport : all) {
      allTell &= transport.onOpened(wake);
    }
    return allTell;
  }

  /** Passes the limits on to each; a door with lower limits of its own keeps them. */
  @Override
  public void limitLinks(int most, int mostPerAddress) {
    all.forEach(transport -> transport.limitLinks(most, mostPerAddress));
  }

  /** Returns the TCP port of the first. */
  @Override
  public int tcpPort() {
    return all.get(0).tcpPort();
  }

  /** Returns the UDP port of the first. */
  @Override
  public int udpPort() {
    return all.get(0).udpPort();
  }

  @Override
  public String troubles() {
    return String.join(
        "; ", all.stream().map(ServerTransport::troubles).filter(t -> !t.isEmpty()).toList());
  }

  @Override
  public List<NetworkCounter> networkCounters() {
    return all.stream().flatMap(transport -> transport.networkCounters().stream()).toList();
  }

  @Override
  public Throwable nextError() {
    for (ServerTransport transport : all) {
      Throwable error = transport.nextError();
      if (error != null) {
        return error;
      }
    }
    return null;
  }

  /** Closes all, also when one of them fails. */
  @Override
  public void close() {
    RuntimeException failure = null;
    for (ServerTransport transport : all) {
      try {
        transport.close();
      } catch (RuntimeException e) {
        failure = e;
      }
    }
    if (failure != null) {
      throw failure;
    }
  }
}

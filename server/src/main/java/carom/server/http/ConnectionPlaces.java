package carom.server.http;

import io.undertow.server.HttpServerExchange;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import org.xnio.ChannelListener;
import org.xnio.StreamConnection;

/**
 * The places of connections at the port for HTTP, which are few: the file descriptors of the
 * process are the game's. A newcomer always gets a place. When all are taken, or those that one
 * address may have, the connection gives way that has waited longest without asking anything, of
 * the address that has most. Then those give way whose answer isn't read. A WebSocket has no place
 * here; the page behind it limits them itself. Any thread.
 */
final class ConnectionPlaces implements ChannelListener<StreamConnection> {
  private final int most;
  private final Predicate<InetAddress> isProxy;
  private final ChannelListener<StreamConnection> next;
  private final Predicate<InetAddress> hears;
  private final Map<SocketAddress, Place> places = new LinkedHashMap<>();

  /** A connection. The lock of its places guards it. */
  private static final class Place {
    private final StreamConnection connection;
    private final InetAddress address;
    private int answers;

    Place(StreamConnection connection, InetAddress address) {
      this.connection = connection;
      this.address = address;
    }

    boolean isBusy() {
      return answers > 0;
    }
  }

  /**
   * Creates free places.
   *
   * @param most how many, at least 2; one address may have half of them
   * @param isProxy whether an address stands for many visitors, and may have all places
   * @param hears whether the server is for visitors of an address; others are hung up on
   * @param next takes each connection that has a place
   */
  ConnectionPlaces(
      int most,
      Predicate<InetAddress> isProxy,
      Predicate<InetAddress> hears,
      ChannelListener<StreamConnection> next) {
    this.hears = hears;
    this.most = most;
    this.isProxy = isProxy;
    this.next = next;
  }

  @Override
  public void handleEvent(StreamConnection connection) {
    if (connection.getPeerAddress() instanceof InetSocketAddress peer
        && hears.test(peer.getAddress())) {
      takePlace(peer, connection).forEach(ConnectionPlaces::end);
      next.handleEvent(connection);
    } else {
      end(connection); // it is gone already, or not for us
    }
  }

  private synchronized List<StreamConnection> takePlace(
      InetSocketAddress peer, StreamConnection connection) {
    places.values().removeIf(place -> !place.connection.isOpen());
    Map<InetAddress, Integer> counts = new HashMap<>();
    places.values().forEach(place -> counts.merge(place.address, 1, Integer::sum));
    int own = counts.getOrDefault(peer.getAddress(), 0);
    List<StreamConnection> ended = new ArrayList<>();
    if (own >= most / 2 && !isProxy.test(peer.getAddress())) {
      giveWay(place -> place.address.equals(peer.getAddress()), counts, ended);
    } else if (places.size() >= most) {
      giveWay(place -> true, counts, ended);
    }
    places.put(peer, new Place(connection, peer.getAddress()));
    return ended;
  }

  /** Takes the place of one connection, if any may be taken, and adds it to a list. */
  private void giveWay(
      Predicate<Place> which, Map<InetAddress, Integer> counts, List<StreamConnection> ended) {
    places.values().stream()
        .filter(which)
        .min( // the first of equals is the oldest
            Comparator.comparing(Place::isBusy).thenComparing(place -> -counts.get(place.address)))
        .ifPresent(
            place -> {
              places.values().remove(place);
              ended.add(place.connection);
            });
  }

  private static void end(StreamConnection connection) {
    try {
      connection.close();
    } catch (IOException e) {
      // it is gone either way
    }
  }

  /** Notes that a request has come whole, so that its connection gives way after those without. */
  synchronized void asks(HttpServerExchange exchange) {
    Place place = places.get(exchange.getConnection().getPeerAddress());
    if (place != null) {
      place.answers++;
      exchange.addExchangeCompleteListener(
          (done, others) -> {
            answered(place, done);
            others.proceed();
          });
    }
  }

  private synchronized void answered(Place place, HttpServerExchange exchange) {
    place.answers--;
    if (exchange.isUpgrade()) {
      places.values().remove(place);
    }
  }
}

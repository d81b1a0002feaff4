package carom.server.session;

import carom.net.admission.AddressGroup;
import java.util.HashMap;
import java.util.Map;
import java.util.function.Function;

/**
 * The part of a full room's seats that one network may hold while others want to play. Shares count
 * only then: as long as there are seats, a whole school behind one router plays.
 *
 * <p>The seats of a network are those of one IPv4 /24 or IPv6 /64. A network that holds more than
 * its share gives up the newest seat of its busiest address, if it then still holds no fewer seats
 * than the newcomer's network with the newcomer. Among the addresses of the newcomer's own network
 * the same holds. So seats move from those that hold many to those that hold few, and never back. A
 * network within its share never gives way.
 *
 * <p>A player with an account counts as a network of its own, by the account: the operator's
 * backend knows the player, and a class with accounts is no crowd. Immutable.
 */
final class SeatShares {
  /** Seats that a network may always hold: those of a household. */
  public static final int LEAST = 2;

  private static final int PERCENT = 100;

  private final int share;

  /**
   * Creates the shares of a room.
   *
   * @param seats number of seats of the room
   * @param percent a network's share of them, percent, 1..100; 100 turns shares off
   */
  public SeatShares(int seats, int percent) {
    share = Math.max(LEAST, (seats * percent + PERCENT - 1) / PERCENT);
  }

  /** Returns the group that a player counts for. */
  static AddressGroup groupOf(String account, AddressGroup origin) {
    return account.isEmpty()
        ? origin
        : new AddressGroup("account " + account, "account " + account);
  }

  /**
   * Returns the seat that gives way to a newcomer, or null.
   *
   * @param seats all seats, null where one is free
   * @param newcomer the group of the newcomer
   */
  Seats.Seat givesWay(Seats.Seat[] seats, AddressGroup newcomer) {
    Seats.Seat seat = newestOfBusiest(seats, newcomer, AddressGroup::network);
    if (seat != null) {
      return seat;
    }
    Seats.Seat[] neighbours = seats.clone();
    for (int id = 0; id < seats.length; id++) {
      boolean near = seats[id] != null && seats[id].group().network().equals(newcomer.network());
      neighbours[id] = near ? seats[id] : null;
    }
    return newestOfBusiest(neighbours, newcomer, AddressGroup::host);
  }

  private Seats.Seat newestOfBusiest(
      Seats.Seat[] seats, AddressGroup newcomer, Function<AddressGroup, String> key) {
    Map<String, Integer> groups = count(seats, key);
    int ofNewcomer = groups.getOrDefault(key.apply(newcomer), 0);
    int least = Math.max(share, ofNewcomer + 1);
    Map<String, Integer> hosts = count(seats, AddressGroup::host);
    Seats.Seat first = null;
    for (Seats.Seat seat : seats) {
      if (seat != null
          && seat.givesWay()
          && groups.get(key.apply(seat.group())) > least
          && (first == null || comesBefore(seat, first, groups, hosts, key))) {
        first = seat;
      }
    }
    return first;
  }

  private static boolean comesBefore(
      Seats.Seat a,
      Seats.Seat b,
      Map<String, Integer> groups,
      Map<String, Integer> hosts,
      Function<AddressGroup, String> key) {
    int byGroup =
        Integer.compare(groups.get(key.apply(a.group())), groups.get(key.apply(b.group())));
    int byHost = Integer.compare(hosts.get(a.group().host()), hosts.get(b.group().host()));
    int order = byGroup != 0 ? byGroup : byHost != 0 ? byHost : Long.compare(a.order(), b.order());
    return order > 0;
  }

  private static Map<String, Integer> count(
      Seats.Seat[] seats, Function<AddressGroup, String> key) {
    Map<String, Integer> counts = new HashMap<>();
    for (Seats.Seat seat : seats) {
      if (seat != null) {
        counts.merge(key.apply(seat.group()), 1, Integer::sum);
      }
    }
    return counts;
  }
}

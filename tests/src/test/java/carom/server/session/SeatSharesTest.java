package carom.server.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.admission.AddressGroup;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;

class SeatSharesTest {
  private final Seats seats = new Seats(32, new AtomicLong(1)::getAndIncrement);
  private final SeatShares shares = new SeatShares(32, 6);

  private static AddressGroup from(String address) {
    return AddressGroup.ofRemote(address + ":1");
  }

  private Seats.Seat sit(String account, String address) {
    Seats.Seat seat = seats.take("p", account, from(address));
    seats.occupy(seat);
    return seat;
  }

  @Test
  void playersWithAccountsAreNoCrowdButAnAccountIs() {
    for (int i = 0; i < 28; i++) {
      sit("pupil" + i, "192.0.2.1");
    }
    assertNull(seats.givesWay(shares, "", from("198.51.100.1")));
    sit("greedy", "203.0.113.1");
    sit("greedy", "203.0.114.1");
    assertNull(seats.givesWay(shares, "", from("198.51.100.1")), "two are within the share");
    Seats.Seat third = sit("greedy", "203.0.115.1");
    assertSame(third, seats.givesWay(shares, "", from("198.51.100.1")));
    assertNull(seats.givesWay(shares, "greedy", from("198.51.100.1")), "not for itself");
  }

  @Test
  void aSeatThatALinkClaimsAndOneThatStillLoadsStay() {
    Seats.Seat first = sit("", "192.0.2.1");
    Seats.Seat second = sit("", "192.0.2.1");
    Seats.Seat third = sit("", "192.0.2.1");
    seats.take("loading", "", from("192.0.2.1"));
    assertSame(third, seats.givesWay(shares, "", from("198.51.100.1")));
    seats.claim(third.secret(), from("192.0.2.1"), 0);
    assertSame(second, seats.givesWay(shares, "", from("198.51.100.1")));
    seats.claim(second.secret(), from("192.0.2.1"), 0);
    assertSame(first, seats.givesWay(shares, "", from("198.51.100.1")));
  }

  @Test
  void aPlayerWhoReturnsFromElsewhereCountsThere() {
    for (int i = 0; i < 3; i++) {
      sit("", "192.0.2.1");
    }
    Seats.Seat moved = sit("", "192.0.2.1");
    seats.claim(moved.secret(), from("198.51.100.1"), 0);
    seats.occupy(moved);
    assertTrue(seats.givesWay(shares, "", from("203.0.113.1")) != moved);
  }

  @Test
  void householdsOfIpv6AreOneNetworkHoweverManyAddressesTheyUse() {
    for (int i = 1; i <= 3; i++) {
      sit("", "[2001:db8::" + i + "]");
    }
    assertEquals(2, seats.givesWay(shares, "", from("[2001:db8:0:1::1]")).id());
    assertNull(seats.givesWay(shares, "", from("[2001:db8::9]")), "its own network is no other");
  }

  /** Whatever comes and goes, a network within its share loses nobody, and nobody is worse off. */
  @Test
  void nobodyWithinTheShareEverGivesWay() {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    Random random = new Random(seed);
    List<Seats.Seat> sitting = new ArrayList<>();
    Map<Seats.Seat, String> networks = new HashMap<>();
    for (int i = 0; i < 5_000; i++) {
      String network = "10.0." + random.nextInt(1 + random.nextInt(40)) + ".";
      String address = network + random.nextInt(3);
      Seats.Seat gives = null;
      if (sitting.size() == 32) {
        gives = seats.givesWay(shares, "", from(address));
        if (gives == null) {
          gives = random.nextInt(4) == 0 ? sitting.get(random.nextInt(32)) : null;
        } else {
          String poorer = networks.get(gives);
          long theirs = sitting.stream().filter(s -> networks.get(s).equals(poorer)).count();
          long ours = sitting.stream().filter(s -> networks.get(s).equals(network)).count();
          assertTrue(theirs > 2, "seed=" + seed);
          assertTrue(poorer.equals(network) || theirs - 1 >= ours + 1, "seed=" + seed);
        }
      }
      if (gives != null) {
        seats.vacate(gives);
        sitting.remove(gives);
      }
      if (sitting.size() < 32) {
        Seats.Seat seat = sit("", address);
        sitting.add(seat);
        networks.put(seat, network);
      }
    }
  }
}

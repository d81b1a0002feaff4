package carom.net.admission;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/** Goal: no crowd keeps those out who come after it, and none that proves something gives way. */
class EntranceTest {
  private static final class Guest implements Entrance.Guest {
    private final AddressGroup origin;
    private Entrance.Proof proof = Entrance.Proof.UNPROVEN;

    Guest(String address) {
      origin = AddressGroup.ofRemote(address + ":1");
    }

    @Override
    public AddressGroup origin() {
      return origin;
    }

    @Override
    public Entrance.Proof proof() {
      return proof;
    }
  }

  private final List<Guest> evicted = new ArrayList<>();
  private final Entrance<Guest> entrance = new Entrance<>(64, 16, evicted::add);

  private Guest guest(String address) {
    Guest guest = new Guest(address);
    entrance.add(guest);
    return guest;
  }

  @Test
  void aSchoolBehindOneRouterGetsInAsLongAsThereArePlaces() {
    for (int i = 0; i < 64; i++) {
      guest("192.0.2.1");
    }
    assertTrue(evicted.isEmpty());
  }

  @Test
  void theOldestGivesWay() {
    Guest first = guest("10.0.0.1");
    Guest second = guest("10.0.1.1");
    for (int i = 2; i < 65; i++) {
      guest("10.0." + i + ".1");
    }
    assertEquals(List.of(first), evicted);
    entrance.remove(second);
    guest("10.1.0.1");
    assertEquals(List.of(first), evicted, "one has left, so there is a place");
  }

  @Test
  void aNetworkThatHoldsItsShareGivesWayToItself() {
    Guest patient = guest("10.9.9.9");
    for (int i = 0; i < 63; i++) {
      guest("192.0.2." + i);
    }
    for (int i = 0; i < 1_000; i++) {
      guest("192.0.2." + i % 250);
    }
    assertEquals(1_000, evicted.size());
    assertFalse(evicted.contains(patient));
  }

  @Test
  void aHostThatHoldsItsShareGivesWayBeforeItsNeighbours() {
    for (int i = 0; i < 60; i++) {
      guest("10.0." + i + ".1");
    }
    guest("192.0.2.9"); // waits longer than the host that follows
    for (int i = 0; i < 53; i++) {
      guest("192.0.2.1");
    }
    assertEquals(50, evicted.size());
    assertEquals(
        Set.of("192.0.2.1"),
        evicted.stream().map(guest -> guest.origin().host()).collect(Collectors.toSet()));
  }

  @Test
  void aHouseholdOfIpv6IsOneHostHoweverManyAddressesItUses() {
    Guest patient = guest("[2001:db8:0:2::1]");
    for (int i = 0; i < 1_063; i++) {
      guest("[2001:db8:0:1::" + Integer.toHexString(i) + "]");
    }
    assertEquals(1_000, evicted.size());
    assertFalse(evicted.contains(patient));
  }

  @Test
  void theUnprovenNeverDisplaceTheProven() {
    Guest proven = guest("10.0.0.1");
    proven.proof = Entrance.Proof.PROVEN;
    for (int i = 0; i < 2_000; i++) {
      guest("10." + i / 250 + "." + i % 250 + ".1");
    }
    assertFalse(evicted.contains(proven));
    proven.proof = Entrance.Proof.IN;
    entrance.sort();
    for (int i = 0; i < 20; i++) {
      Guest other = guest("10.0." + i + ".7");
      other.proof = Entrance.Proof.PROVEN;
      entrance.sort();
    }
    assertFalse(evicted.contains(proven), "it is in, and holds no place");
  }

  @Test
  void theFewerPlacesTheMoreWork() {
    int last = 0;
    for (int i = 0; i < 64; i++) {
      assertTrue(entrance.workBits() >= last, "guests=" + i);
      last = entrance.workBits();
      assertEquals(i >= 32, last > 0, "guests=" + i);
      guest("10.0." + i + ".1");
    }
    assertEquals(16, entrance.workBits());
  }

  @Test
  void placesAreBoundedWhateverHappens() {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    SplittableRandom random = new SplittableRandom(seed);
    List<Guest> present = new ArrayList<>();
    for (int i = 0; i < 20_000; i++) {
      Guest guest = guest("10." + random.nextInt(3) + "." + random.nextInt(9) + ".1");
      present.add(guest);
      present.removeAll(evicted);
      evicted.clear();
      Guest one = present.get(random.nextInt(present.size()));
      one.proof = Entrance.Proof.values()[random.nextInt(one.proof.ordinal(), 3)];
      if (random.nextInt(4) == 0) {
        entrance.remove(one);
        present.remove(one);
      }
      if (random.nextInt(10) == 0) {
        entrance.sort();
        present.removeIf(g -> g.proof == Entrance.Proof.IN);
      }
      long unproven = present.stream().filter(g -> g.proof == Entrance.Proof.UNPROVEN).count();
      assertTrue(unproven <= 64, "seed=" + seed + " unproven=" + unproven);
    }
  }

  @Test
  void workIsProvenByTheOneWhoHasTheToken() {
    WorkProof proof = new WorkProof();
    long solution = proof.solve(7, 42, 10);
    assertTrue(proof.isSolved(7, 42, 10, solution));
    assertTrue(proof.isSolved(7, 42, 0, solution + 1));
    int others = 0;
    for (int i = 0; i < 100; i++) {
      others += proof.isSolved(7, 43 + i, 10, solution) ? 1 : 0;
    }
    assertTrue(others < 5, "others=" + others);
    assertThrows(IllegalArgumentException.class, () -> proof.solve(7, 42, 21));
  }
}

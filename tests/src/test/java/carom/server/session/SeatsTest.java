package carom.server.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.admission.AddressGroup;
import carom.net.protocol.PlayerName;
import carom.net.protocol.ProtocolLimits;
import java.util.HashSet;
import java.util.Set;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;

class SeatsTest {
  private static final AddressGroup ANYWHERE = AddressGroup.ofRemote("192.0.2.1:1");

  private long now;
  private final AtomicLong secrets = new AtomicLong();
  private final Seats seats = new Seats(3, secrets::getAndIncrement);

  @Test
  void idsAreTheLowestFreeOnes() {
    Seats.Seat a = seats.take("a");
    Seats.Seat b = seats.take("b");
    assertEquals(0, a.id());
    assertEquals(1, b.id());
    seats.unclaim(a);
    assertEquals(0, seats.take("c").id());
    assertEquals(2, seats.take("d").id());
    assertNull(seats.take("e"));
    assertEquals(3, seats.takenCount());
  }

  @Test
  void secretsAreNeverZero() {
    assertNotEquals(0, seats.take("a").secret());
    assertNull(seats.claim(0, ANYWHERE, 0));
  }

  @Test
  void sameNameGetsANumberWhateverItsCase() {
    assertEquals("Ann", seats.take("Ann").name());
    assertEquals("ann (2)", seats.take("ann").name());
    assertEquals("Ann (3)", seats.take("Ann").name());
  }

  @Test
  void nameThatLooksLikeATakenOneGetsANumber() {
    assertEquals("Admin", seats.take("Admin").name());
    Seats.Seat cyrillic = seats.take("\u0410dmin");
    assertEquals("\u0410dmin (2)", cyrillic.name());
    seats.unclaim(cyrillic);
    assertEquals("AdmIn (2)", seats.take("AdmIn").name());
  }

  @Test
  void nameIsFreeAgainWhenItsSeatIs() {
    Seats.Seat ann = seats.take("Ann");
    assertEquals("Ann (2)", seats.take("ann").name().replace('a', 'A'));
    seats.unclaim(ann);
    assertEquals("ANN", seats.take("ANN").name());
    assertEquals(2, seats.takenCount());
  }

  @Test
  void fullRoomOfTheSameNameHasAsManyNames() {
    Seats room = new Seats(ProtocolLimits.MAX_PLAYERS, secrets::getAndIncrement);
    Set<String> names = new HashSet<>();
    for (int i = 0; i < room.count(); i++) {
      names.add(room.take("player").name());
    }
    assertEquals(ProtocolLimits.MAX_PLAYERS, names.size());
    assertEquals(ProtocolLimits.MAX_PLAYERS, room.takenCount());
    assertNull(room.take("player"));
  }

  @Test
  void numberedNameStaysWithinTheLimit() {
    String longest = "\u00e9".repeat(16);
    seats.take(longest);
    String second = seats.take(longest).name();
    assertNull(PlayerName.problem(second), second);
    assertTrue(second.endsWith(" (2)"), second);
  }

  @Test
  void occupiedSeatOutlivesItsClaims() {
    Seats.Seat seat = seats.take("a");
    seats.occupy(seat);
    assertSame(seat, seats.claim(seat.secret(), ANYWHERE, now += 2_000_000_000L));
    assertTrue(seats.isClaimed(seat));
    seats.unclaim(seat);
    assertEquals(1, seats.takenCount());
    seats.vacate(seat);
    assertEquals(0, seats.takenCount());
    assertNull(seats.claim(seat.secret(), ANYWHERE, now += 2_000_000_000L));
  }

  @Test
  void claimedSeatOutlivesItsPlayer() {
    Seats.Seat seat = seats.take("a");
    seats.occupy(seat);
    assertNotNull(seats.claim(seat.secret(), ANYWHERE, now += 2_000_000_000L));
    seats.vacate(seat);
    assertEquals(1, seats.takenCount());
    seats.occupy(seat);
    seats.vacate(seat);
    assertEquals(0, seats.takenCount());
  }
}

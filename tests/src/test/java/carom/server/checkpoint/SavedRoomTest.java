package carom.server.checkpoint;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.protocol.Protocol;
import carom.net.snapshot.frame.EventRing;
import carom.server.account.AccountValues;
import carom.server.account.AccountWrite;
import carom.server.account.PlayerSkill;
import carom.server.account.Stay;
import carom.server.session.Seats;
import carom.server.session.Session;
import carom.sim.SimState;
import carom.sim.field.Field;
import carom.sim.field.Schema;
import carom.sim.field.Scope;
import carom.sim.outbox.NextMatch;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Goal: a file of seats is read as it was written, or refused with a reason. */
class SavedRoomTest {
  private static Stay stay() {
    Schema schema = Schema.of(List.of(Field.count("wins").of(Scope.ACCOUNT).times(2)));
    return new Stay("4711", 5L << 32, AccountValues.NONE.with("duel", schema, new int[] {7, 9}));
  }

  private static AccountWrite left() {
    return AccountWrite.of(stay(), "Cid", "duel", new AccountWrite.Place("1", 4, 990), true, true);
  }

  private static SavedRoom room(long physics, int layout, String config) {
    SavedSeat ann =
        new SavedSeat(
            3,
            "Ann",
            "Ann (2)",
            "4711",
            "trio",
            1_700,
            -77,
            true,
            1_234,
            Seats.Seat.SAME_COURSE,
            2,
            true,
            990,
            stay(),
            new int[0]);
    SavedSeat bob =
        new SavedSeat(
            1_023,
            "Zoë",
            "Zoë",
            "",
            "",
            PlayerSkill.NO_CLAIM,
            5,
            false,
            SavedSeat.PLAYED,
            9,
            0,
            false,
            7,
            null,
            new int[0]);
    return new SavedRoom(
        physics,
        layout,
        config,
        -1,
        4,
        2,
        NextMatch.level("commons").keepingTeams(),
        1_000,
        42,
        SavedEvents.of(new EventRing(), new Session[1]),
        List.of(ann, bob),
        List.of(left()));
  }

  private static SavedRoom room() {
    return room(Protocol.physicsDigest(), SimState.LAYOUT, "room=1");
  }

  @Test
  void whatIsWrittenIsRead() throws SlotException {
    SavedRoom read = SavedRoom.parse(room().toBytes());
    assertArrayEquals(room().toBytes(), read.toBytes());
    assertEquals("Zoë", read.seats().get(1).name());
    assertEquals("4711", read.seats().get(0).account());
    assertEquals(-77, read.seats().get(0).secret());
    assertEquals(1_234, read.seats().get(0).graceMs());
    assertEquals(2, read.seats().get(0).switches());
    assertTrue(read.seats().get(0).reserved());
    assertEquals(990, read.seats().get(0).sinceTick());
    assertEquals("commons", read.pending().level());
    assertTrue(read.pending().keepsTeams());
    assertFalse(read.pending().keepsScores());
    assertTrue(read.hasSamePhysics());
    read.requireFits("room=1");
  }

  @Test
  void aFileCutAtAnyByteIsRefused() {
    byte[] whole = room().toBytes();
    for (int length = 0; length < whole.length; length++) {
      byte[] cut = Arrays.copyOf(whole, length);
      assertThrows(SlotException.class, () -> SavedRoom.parse(cut), "length=" + length);
    }
  }

  @Test
  void aFileWithAnyFlippedBitIsRefused() {
    byte[] whole = room().toBytes();
    for (int bit = 0; bit < 8 * whole.length; bit++) {
      byte[] flipped = whole.clone();
      flipped[bit / 8] ^= (byte) (1 << bit % 8);
      assertThrows(SlotException.class, () -> SavedRoom.parse(flipped), "bit=" + bit);
    }
  }

  @Test
  void anotherLayoutIsRefusedByItsNumberAndOtherPhysicsIsNot() throws SlotException {
    SavedRoom older = room(1, SimState.LAYOUT - 1, "room=1");
    SlotException refused =
        assertThrows(
            SlotException.class, () -> SavedRoom.parse(older.toBytes()).requireFits("room=1"));
    assertTrue(refused.getMessage().contains("layout=" + (SimState.LAYOUT - 1)), "" + refused);
    SavedRoom updated = SavedRoom.parse(room(1, SimState.LAYOUT, "room=1").toBytes());
    updated.requireFits("room=1");
    assertFalse(updated.hasSamePhysics());
  }

  @Test
  void aRoomOfOtherSettingsIsRefusedByThem() {
    SlotException refused =
        assertThrows(SlotException.class, () -> room().requireFits("room=1 levels=x"));
    assertTrue(
        refused.getMessage().contains("\"room=1\" is now \"room=1 levels=x\""), "" + refused);
  }
}

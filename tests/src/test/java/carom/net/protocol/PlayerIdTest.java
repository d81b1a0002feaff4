package carom.net.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.codec.BitReader;
import carom.net.codec.BitWriter;
import carom.net.snapshot.frame.PlayerSet;
import carom.sim.SimulationHost;
import org.junit.jupiter.api.Test;

/** Ids of players, and sets of them. */
class PlayerIdTest {
  @Test
  void everyIdComesBackAndSmallOnesAreShort() {
    byte[] bytes = new byte[4 * (PlayerId.MAX + 1)];
    BitWriter writer = new BitWriter();
    writer.reset(bytes, 0, bytes.length);
    for (int id = 0; id <= PlayerId.MAX; id++) {
      int before = writer.bits();
      PlayerId.code(writer, id);
      assertEquals(id < 128 ? 8 : 11, writer.bits() - before, "id=" + id);
    }
    BitReader reader = new BitReader();
    reader.reset(bytes, 0, bytes.length);
    for (int id = 0; id <= PlayerId.MAX; id++) {
      assertEquals(id, PlayerId.code(reader, 0));
    }
  }

  @Test
  void allLayersAgreeHowManyThereAre() {
    assertEquals(ProtocolLimits.MAX_PLAYERS, PlayerId.MAX + 1);
    assertEquals(ProtocolLimits.MAX_PLAYERS, SimulationHost.MAX_PLAYERS);
  }

  @Test
  void setsOfAnyReachAreComparedByWhoIsIn() {
    PlayerSet near = new PlayerSet();
    PlayerSet far = new PlayerSet();
    near.add(3);
    far.add(3);
    far.add(PlayerId.MAX);
    assertFalse(near.sameAs(far));
    assertFalse(far.sameAs(near));
    assertEquals(PlayerId.MAX, far.next(4));
    assertEquals(-1, near.next(4));
    assertEquals(-1, far.next(PlayerId.MAX + 1));
    assertFalse(near.has(PlayerId.MAX));
    far.set(near);
    assertTrue(far.sameAs(near));
    assertTrue(near.sameAs(far));
    assertEquals(1, far.size());
    assertThrows(IndexOutOfBoundsException.class, () -> near.add(PlayerId.MAX + 1));
    assertThrows(IndexOutOfBoundsException.class, () -> near.add(-1));
  }
}

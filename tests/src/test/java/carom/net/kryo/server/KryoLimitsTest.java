package carom.net.kryo.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;

class KryoLimitsTest {
  @Test
  void eachCopyHasItsChangesAndEverythingElse() {
    KryoLimits other =
        KryoLimits.DEFAULT
            .withConnections(11, 12)
            .withPending(9)
            .withTimes(130, 140)
            .withRates(15, 16)
            .withInbox(17, 18);
    int unsent = KryoLimits.DEFAULT.unsentBytes();
    assertEquals(new KryoLimits(11, 9, 12, 130, 140, 15, 16, 17, 18, unsent), other);
  }

  @Test
  void valuesOutOfRangeAreRefusedByName() {
    Exception e =
        assertThrows(
            IllegalArgumentException.class, () -> KryoLimits.DEFAULT.withConnections(0, 1));
    assertEquals("maxConnections=0 must be from 1 to 132000", e.getMessage());
  }
}

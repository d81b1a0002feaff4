package carom.net.admission;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import org.junit.jupiter.api.Test;

/** Goal: addresses of one household are one host. */
class OriginTest {
  @Test
  void addressesAreGroupedByHouseholdAndNetwork() {
    assertEquals(
        new Origin("192.0.2.7", "192.0.2/24"), Origin.ofRemote("192.0.2.7:5000"), "IPv4 and port");
    assertEquals(Origin.ofRemote("192.0.2.7:1"), Origin.ofRemote("192.0.2.7:2"));
    assertEquals(
        Origin.ofRemote("[2001:db8:0:1::1]:5000"), Origin.ofRemote("[2001:db8:0:1:ffff::9]:6000"));
    assertNotEquals(
        Origin.ofRemote("[2001:db8:0:1::1]:5000"), Origin.ofRemote("[2001:db8:0:2::1]:5000"));
    assertEquals(new Origin("client-3", "client-3"), Origin.ofRemote("client-3"));
    assertEquals(new Origin("999.1.1.1", "999.1.1.1"), Origin.ofRemote("999.1.1.1:5"));
  }
}

package carom.net.admission;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import org.junit.jupiter.api.Test;

/** Goal: addresses of one household are one host. */
class AddressGroupTest {
  @Test
  void addressesAreGroupedByHouseholdAndNetwork() {
    assertEquals(
        new AddressGroup("192.0.2.7", "192.0.2/24"),
        AddressGroup.ofRemote("192.0.2.7:5000"),
        "IPv4 and port");
    assertEquals(AddressGroup.ofRemote("192.0.2.7:1"), AddressGroup.ofRemote("192.0.2.7:2"));
    assertEquals(
        AddressGroup.ofRemote("[2001:db8:0:1::1]:5000"),
        AddressGroup.ofRemote("[2001:db8:0:1:ffff::9]:6000"));
    assertNotEquals(
        AddressGroup.ofRemote("[2001:db8:0:1::1]:5000"),
        AddressGroup.ofRemote("[2001:db8:0:2::1]:5000"));
    assertEquals(new AddressGroup("client-3", "client-3"), AddressGroup.ofRemote("client-3"));
    assertEquals(new AddressGroup("999.1.1.1", "999.1.1.1"), AddressGroup.ofRemote("999.1.1.1:5"));
  }
}

package carom.net.kryo.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import org.junit.jupiter.api.Test;

final class AddressChangeLimitTest {
  private static final long SECOND = 1_000_000_000L;
  private static final InetSocketAddress PRESENT = address(0, 7);

  private static InetSocketAddress address(int host, int port) {
    try {
      byte[] bytes = {10, 1, (byte) (host >> 8), (byte) host};
      return new InetSocketAddress(InetAddress.getByAddress(bytes), port);
    } catch (UnknownHostException x) {
      throw new AssertionError(x);
    }
  }

  private static InetSocketAddress elsewhere(int number) {
    return address(1 + number / 1_000, 1 + number % 1_000);
  }

  @Test
  void aLinkHasTwentyASecondWhateverOthersReceive() {
    var total = AddressChangeLimit.total();
    AddressChangeLimit flooded = new AddressChangeLimit(total);
    AddressChangeLimit other = new AddressChangeLimit(total);
    int opened = 0;
    for (int i = 0; i < 30_000; i++) {
      long now = i * SECOND / 3_000;
      if (flooded.take(elsewhere(i), PRESENT, now)) {
        opened++;
        flooded.forged(elsewhere(i), now);
      }
      assertTrue(i % 300 != 0 || other.take(address(500, 1), PRESENT, now), "ten a second, i=" + i);
    }
    assertTrue(opened >= 200 && opened <= 220, "opened=" + opened);
  }

  @Test
  void aFloodFromOtherHostsTakesNothingFromTheClientsOwn() {
    AddressChangeLimit limit = new AddressChangeLimit(AddressChangeLimit.total());
    for (int i = 0; i < 30_000; i++) {
      long now = i * SECOND / 3_000;
      if (limit.take(elsewhere(i), PRESENT, now)) {
        limit.forged(elsewhere(i), now);
      }
      assertTrue(i % 300 != 0 || limit.take(address(0, 8 + i), PRESENT, now), "i=" + i);
    }
  }

  @Test
  void allLinksTogetherHaveTwoThousandASecond() {
    var total = AddressChangeLimit.total();
    int opened = 0;
    AddressChangeLimit[] links = new AddressChangeLimit[1_000];
    for (int i = 0; i < links.length; i++) {
      links[i] = new AddressChangeLimit(total);
    }
    for (int i = 0; i < 100_000; i++) {
      opened += links[i % links.length].take(elsewhere(i), PRESENT, i * SECOND / 20_000) ? 1 : 0;
    }
    assertTrue(opened >= 10_000 && opened <= 10_500, "opened=" + opened);
  }

  @Test
  void anAddressThatForgesIsNotHeardForASecond() {
    AddressChangeLimit limit = new AddressChangeLimit(AddressChangeLimit.total());
    for (int i = 0; i < AddressChangeLimit.FORGERS; i++) {
      assertTrue(limit.take(elsewhere(i), PRESENT, 0));
      limit.forged(elsewhere(i), 0);
    }
    for (int i = 0; i < 10_000; i++) {
      assertFalse(limit.take(elsewhere(i % AddressChangeLimit.FORGERS), PRESENT, SECOND - 1));
    }
    assertTrue(limit.take(elsewhere(100), PRESENT, SECOND - 1), "they used up nothing");
    assertTrue(limit.take(elsewhere(0), PRESENT, SECOND));
    assertEquals(8, AddressChangeLimit.FORGERS);
  }
}

package carom.server.lobby;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** Goal: one address can't crowd out or annoy the others. Method: closed sums in virtual time. */
final class AdmissionRateTest {
  private static final long SECOND = 1_000_000_000L;

  private final AdmissionRate rate = new AdmissionRate(64);

  @Test
  void aCrowdComesInAtOnceAndALoopIsSlowedDown() {
    for (int i = 0; i < AdmissionRate.LEAST_BURST; i++) {
      assertTrue(rate.allows("a", 0), "i=" + i);
      rate.count("a", 0);
    }
    assertFalse(rate.allows("a", 0));
    assertTrue(rate.allows("b", 0), "another address isn't meant");
    int entered = 0;
    for (int ms = 0; ms < 10_000; ms++) {
      long now = SECOND + ms * 1_000_000L;
      if (rate.allows("a", now)) {
        rate.count("a", now);
        entered++;
      }
    }
    assertEquals(11 * AdmissionRate.PER_SECOND, entered, 1);
  }

  @Test
  void asManyAsTheServerHasPlacesComeInAtOnce() {
    AdmissionRate large = new AdmissionRate(500);
    for (int i = 0; i < 500; i++) {
      assertTrue(large.allows("a", 0), "i=" + i);
      large.count("a", 0);
    }
    assertFalse(large.allows("a", 0));
  }

  @Test
  void restRefillsUpToTheBurst() {
    for (int i = 0; i < AdmissionRate.LEAST_BURST; i++) {
      rate.count("a", 0);
    }
    long later = 3_600 * SECOND;
    for (int i = 0; i < AdmissionRate.LEAST_BURST; i++) {
      assertTrue(rate.allows("a", later));
      rate.count("a", later);
    }
    assertFalse(rate.allows("a", later));
  }

  @Test
  void manyAddressesDoNotFillTheMemory() {
    for (int i = 0; i < 100_000; i++) {
      rate.count("address" + i, i);
    }
    assertTrue(rate.allows("address1", 100_000));
  }
}

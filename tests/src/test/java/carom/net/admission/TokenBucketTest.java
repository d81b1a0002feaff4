package carom.net.admission;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** Goal: a bucket lets a burst through and then its rate. Method: a clock by hand. */
final class TokenBucketTest {
  private static final long SECOND = 1_000_000_000L;

  private final TokenBucket bucket = new TokenBucket(4, 8);

  /** Any time will do as the first, because {@link System#nanoTime} begins anywhere. */
  private long now = Long.MAX_VALUE - SECOND;

  private int taken(int tries) {
    int taken = 0;
    for (int i = 0; i < tries; i++) {
      taken += bucket.take(now) ? 1 : 0;
    }
    return taken;
  }

  @Test
  void aBurstIsTakenAtOnceAndTheRestByTheRate() {
    assertEquals(8, taken(100));
    now += SECOND;
    assertEquals(4, taken(100));
    now += 60 * SECOND;
    assertEquals(8, taken(100), "the bucket holds no more than a burst");
  }

  @Test
  void aChargeCountsEvenWhenTheBucketIsEmpty() {
    for (int i = 0; i < 12; i++) {
      bucket.charge(now);
    }
    assertTrue(bucket.isEmpty(now));
    now += SECOND;
    assertTrue(bucket.isEmpty(now), "four events are still to be paid for");
    now += SECOND / 4;
    assertFalse(bucket.isEmpty(now));
  }

  @Test
  void aQuestionChangesNothing() {
    assertTrue(bucket.isFull(now));
    assertFalse(bucket.isEmpty(now));
    assertTrue(bucket.take(now));
    assertFalse(bucket.isFull(now));
    assertFalse(bucket.isFull(now + SECOND / 4 - 1));
    assertTrue(bucket.isFull(now + SECOND / 4));
    assertEquals(7, taken(100));
  }
}

package carom.net.snapshot;

import static org.junit.jupiter.api.Assertions.assertEquals;

import carom.net.codec.BitMeter;
import carom.net.codec.SectionCheck;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** The head of a datagram: written, measured and read alike. */
class DatagramHeadTest {
  private static final int NEAR_TICK = 1_000_000;

  private final Random random = new Random(71);

  private DatagramHead head() {
    DatagramHead head = new DatagramHead();
    head.mark = random.nextInt(16);
    head.sequence = random.nextInt(1 << 16);
    head.tick = NEAR_TICK + random.nextInt(1 << 16) - (1 << 15);
    head.news = random.nextBoolean();
    InputFeedback feedback = head.feedback;
    feedback.present = random.nextBoolean();
    feedback.sequence = random.nextInt(1 << 16);
    feedback.holdMs = random.nextInt(256);
    feedback.margin = random.nextInt(64) - 32;
    head.hasOwn = random.nextBoolean();
    head.ownAge = head.hasOwn ? random.nextInt(64) : 0;
    return head;
  }

  private static String text(DatagramHead head) {
    InputFeedback f = head.feedback;
    String feedback = f.present ? f.sequence + " " + f.holdMs + " " + f.margin : "none";
    return head.mark
        + " "
        + head.sequence
        + " "
        + head.tick
        + " "
        + head.news
        + " "
        + feedback
        + " "
        + head.hasOwn
        + " "
        + head.ownAge;
  }

  private final SectionCheck<DatagramHead> check =
      new SectionCheck<>((c, head) -> head.code(c, NEAR_TICK), this::head, DatagramHeadTest::text);

  @Test
  void whatIsWrittenIsMeasuredAndRead() {
    for (int i = 0; i < 300; i++) {
      check.check(head());
    }
    check.hostile(random, 300);
  }

  @Test
  void feedbackOutOfRangeIsClamped() {
    DatagramHead head = head();
    head.feedback.present = true;
    head.feedback.holdMs = 1_000;
    head.feedback.margin = -100;
    head.code(new BitMeter(), NEAR_TICK);
    assertEquals(255, head.feedback.holdMs);
    assertEquals(-32, head.feedback.margin);
  }
}

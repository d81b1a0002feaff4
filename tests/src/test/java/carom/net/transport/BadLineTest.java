package carom.net.transport;

import static org.junit.jupiter.api.Assertions.assertEquals;

import carom.suite.Needs;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Goal: what is reliable keeps its order on a simulated line. Method: many works at once, on a line
 * whose jitter makes most of them due at the same time.
 */
@Needs("waits")
@Timeout(30)
final class BadLineTest {
  private static final int WORKS = 20_000;

  @Test
  void whatIsReliableKeepsItsOrder() throws InterruptedException {
    try (HandshakeLine line = new HandshakeLine(Impairment.NONE.withLatency(20, 20))) {
      BadLine direction = new BadLine(line);
      List<Integer> done = new ArrayList<>(); // by the line's one thread
      List<Integer> sent = new ArrayList<>();
      CountDownLatch all = new CountDownLatch(WORKS);
      for (int i = 0; i < WORKS; i++) {
        int number = i;
        sent.add(i);
        direction.reliable(
            () -> {
              done.add(number);
              all.countDown();
            });
      }
      all.await(20, TimeUnit.SECONDS);
      assertEquals(sent, done);
    }
  }
}

package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.LoggerContext;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.read.ListAppender;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Goal: nobody fills the log from outside. Method: a log of its own with a clock of numbers. */
final class LogLimitTest {
  private static final long SECOND = 1_000_000_000L;

  private final LoggerContext logging = new LoggerContext();
  private final Logger log = logging.getLogger("test");
  private final ListAppender<ILoggingEvent> lines = new ListAppender<>();
  private long nowNs = -5 * SECOND;

  @BeforeEach
  void begin() {
    LogLimit limit = new LogLimit(() -> nowNs);
    limit.start();
    logging.addTurboFilter(limit);
    lines.start();
    log.addAppender(lines);
    log.setLevel(Level.INFO);
  }

  private List<String> texts() {
    return lines.list.stream().map(ILoggingEvent::getFormattedMessage).toList();
  }

  @Test
  void aLoopOfRefusalsWritesTwoLinesASecondAndSaysHowManyItHeldBack() {
    for (int i = 0; i < 476 * 20; i++) {
      nowNs += SECOND / 476;
      log.info("refused: {}", "203.0.113.7:" + i);
    }
    long refused = texts().stream().filter(line -> line.startsWith("refused")).count();
    assertTrue(refused <= LogLimit.BURST + 20 * LogLimit.PER_SECOND + 1, "refused=" + refused);
    assertTrue(refused >= LogLimit.BURST, "refused=" + refused);
    nowNs += 2 * SECOND;
    log.info("status: fine");
    long held =
        texts().stream()
            .filter(line -> line.startsWith("held back: "))
            .mapToLong(line -> Long.parseLong(line.split(" ")[2]))
            .sum();
    assertEquals(476 * 20, refused + held, "every line is written or counted");
    assertTrue(texts().size() < 170, "lines=" + texts().size());
  }

  @Test
  void aCountShowsALineThatWasHeldBackWithItsValues() {
    for (int i = 0; i < LogLimit.BURST + 15; i++) {
      log.info("join: {} as player {}", "bot" + i, i);
    }
    nowNs += 2 * SECOND;
    log.info("status: fine");
    String expected = "held back: 15 more of: join: bot100 as player 100";
    assertTrue(texts().contains(expected), () -> texts().toString());
  }

  @Test
  void otherCausesAreHeardDuringAFlood() {
    for (int i = 0; i < 1_000; i++) {
      log.info("refused: {}", i);
    }
    log.warn("recording {} failed", "x");
    assertTrue(texts().contains("recording x failed"), () -> texts().toString());
    assertEquals(LogLimit.BURST + 1, texts().size());
  }

  @Test
  void whatIsNotLoggedAnywayCostsNothing() {
    for (int i = 0; i < 1_000; i++) {
      log.debug("both {}", i);
    }
    log.info("both {}", "heard");
    assertEquals(List.of("both heard"), texts());
  }

  @Test
  void everythingFarApartIsWritten() {
    for (int i = 0; i < 500; i++) {
      nowNs += SECOND / LogLimit.PER_SECOND;
      log.info("joined: {}", i);
    }
    assertEquals(500, texts().size());
  }
}

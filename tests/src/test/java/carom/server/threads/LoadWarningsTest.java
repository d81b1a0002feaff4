package carom.server.threads;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.server.metrics.Counter;
import carom.server.metrics.Counters;
import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.read.ListAppender;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.slf4j.LoggerFactory;

/** Goal: the log says why ticks are missing. Method: a clock of numbers, and the lines. */
final class LoadWarningsTest {
  private static final long SECOND = 1_000_000_000L;

  private final Logger log = (Logger) LoggerFactory.getLogger(LoadWarnings.class);
  private final ListAppender<ILoggingEvent> lines = new ListAppender<>();
  private final Counters counters = new Counters();
  private final LoadWarnings warnings = new LoadWarnings("room 1: ", counters, 60);

  @BeforeEach
  void listen() {
    lines.start();
    log.setLevel(Level.WARN); // other tests of this process make the log quieter
    log.addAppender(lines);
  }

  @AfterEach
  void stopListening() {
    log.detachAppender(lines);
    log.setLevel(null);
  }

  private List<String> texts() {
    return lines.list.stream().map(ILoggingEvent::getFormattedMessage).toList();
  }

  @Test
  void oneDroppedTickIsNoPlural() {
    warnings.ticksDropped(1, 7, 0);
    assertTrue(
        texts().get(0).startsWith("room 1: can't keep up: 1 tick (16 ms) dropped up to tick 7;"),
        () -> texts().toString());
  }

  @Test
  void aProcessThatWasStoppedIsNotToldToFindAFasterMachine() {
    warnings.ticksDropped(585, 900, 0);
    assertEquals(1, texts().size());
    String line = texts().get(0);
    assertTrue(line.startsWith("room 1: stood still: 585 ticks (9750 ms) dropped up"), line);
    assertTrue(!line.contains("faster machine"), line);
    warnings.ticksDropped(0, 901, 0);
    assertEquals(1, texts().size(), "what was told isn't told again");
  }

  @Test
  void whatLastsIsRepeatedOnceAMinuteWithWhatHelps() {
    warnings.viewsChanged(true, true, 0);
    warnings.paceChanged(40, 0);
    for (int tick = 0; tick < 60 * 600; tick++) {
      warnings.lasts(tick * SECOND / 60);
    }
    long narrow = texts().stream().filter(line -> line.contains("only of what they show")).count();
    long slow = texts().stream().filter(line -> line.contains("passes at 40 percent")).count();
    assertEquals("12 12", narrow + " " + slow, "at 0, 10, 30 and 70 s, and then each minute");
    assertTrue(texts().get(0).contains("lower"), () -> texts().toString());
    warnings.viewsChanged(false, false, 601 * SECOND);
    warnings.paceChanged(100, 601 * SECOND);
    warnings.lasts(900 * SECOND);
    assertEquals(24, texts().size(), "it is over");
  }

  /** Lets snapshots wait in every n-th tick for some seconds, from a second on. */
  private void postpone(int everyTicks, int second, int seconds) {
    for (int tick = 60 * second; tick < 60 * (second + seconds); tick += everyTicks) {
      warnings.snapshotsPostponed(2, 3, tick, tick * SECOND / 60);
    }
  }

  @Test
  void singleLateTicksAreCountedButNoWarning() {
    for (int tick = 12; tick < 17; tick++) {
      warnings.snapshotsPostponed(2, 3, tick, tick * SECOND / 60); // the first join: code compiles
    }
    postpone(13, 2, 60);
    assertEquals(List.of(), texts());
    assertEquals(2 * (5 + 277), counters.get(Counter.SNAPSHOTS_POSTPONED));
  }

  @Test
  void aTenthOfTheTicksOfASecondIsAWarning() {
    postpone(10, 0, 2);
    assertEquals(
        List.of(
            "room 1: ticks take too long: in 6 of the last second snapshots waited, at tick 50 2 of"
                + " 3; if this repeats, lower --snapshot-rate, --budget or --max-players"),
        texts());
  }

  @Test
  void aWarningThatLastsComesAgainNowAndThen() {
    postpone(2, 0, 120);
    assertTrue(texts().size() > 2 && texts().size() < 15, () -> "lines=" + texts().size());
  }

  @Test
  void everyDroppedTickIsToldOnceAndCounted() {
    int told = 0;
    for (int second = 0; second < 600; second++) {
      warnings.ticksDropped(second % 5 == 0 ? 70 : 3, second, second * SECOND);
    }
    warnings.ticksDropped(0, 600, 700 * SECOND);
    for (String line : texts()) {
      told += Integer.parseInt(line.replaceAll(".*: (\\d+) ticks? .*", "$1"));
    }
    assertEquals(120 * 70 + 480 * 3, told);
    assertEquals(told, counters.get(Counter.TICKS_DROPPED));
    assertTrue(texts().size() < 30, () -> "lines=" + texts().size());
  }
}

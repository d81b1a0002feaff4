package carom.client.bots;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import org.junit.jupiter.api.Test;

final class BotReportTest {
  /** Time that passes faster than the real one, as bots wait long before they give up. */
  private static final class Hurry implements BotsMain.BotClock {
    private static final long NAP_NS = 100_000_000;

    private long now;
    private long nextNap;

    @Override
    public long nanoTime() {
      return now;
    }

    @Override
    public void sleep(long ns) throws InterruptedException {
      now += ns;
      if (now >= nextNap) {
        nextNap = now + NAP_NS;
        BotsMain.BotClock.REAL.sleep(NAP_NS / 50);
      }
    }
  }

  private static final String SHAPE =
      "\\{\"joined\":\\d+,\"disconnects\":\\d+,\"errors\":\\d+,\"snapshotsPerSecond\":[0-9.]+,"
          + "\"gapP99Ms\":[0-9.]+,\"rttP50Ms\":[0-9.]+,\"kbitPerSecond\":[0-9.]+,\"playing\":\\d+,"
          + "\"rejected\":\\d+,\"retries\":\\d+,\"kbitPerSecondUp\":[0-9.]+,"
          + "\"exactPercent\":[0-9.]+,\"correctionsPerMinute\":[0-9.]+,"
          + "\"lateInputPercent\":[0-9.]+,\"longestGapMs\":[0-9.]+,\"redirects\":[0-9]+,"
          + "\"ticksLost\":[0-9]+,\"keyP50Ms\":[0-9.]+,\"reconnects\":[0-9]+\\}";

  @Test
  void isOneLineOfJsonInEveryCountry() {
    Locale before = Locale.getDefault();
    try {
      Locale.setDefault(Locale.GERMANY);
      assertEquals(
          "{\"joined\":3,\"disconnects\":1,\"errors\":0,\"snapshotsPerSecond\":59.90,"
              + "\"gapP99Ms\":21.30,\"rttP50Ms\":1.50,\"kbitPerSecond\":42.00,\"playing\":2,"
              + "\"rejected\":4,\"retries\":5,\"kbitPerSecondUp\":6.00,"
              + "\"exactPercent\":99.50,\"correctionsPerMinute\":0.25,"
              + "\"lateInputPercent\":7.50,\"longestGapMs\":180.25,\"redirects\":3,\"ticksLost\":2,"
              + "\"keyP50Ms\":31.50,\"reconnects\":6}",
          new BotReport(
                  3, 1, 0, 59.9, 21.3, 1.5, 42, 2, 4, 5, 6, 99.5, 0.25, 7.5, 180.25, 3, 2, 31.5, 6)
              .toJson());
    } finally {
      Locale.setDefault(before);
    }
  }

  @Test
  void withoutAServerBotsSaySoPrintTheJsonAndFail() {
    PrintStream out = System.out;
    PrintStream err = System.err;
    ByteArrayOutputStream printed = new ByteArrayOutputStream();
    ByteArrayOutputStream complained = new ByteArrayOutputStream();
    int code;
    try {
      System.setOut(new PrintStream(printed, true, StandardCharsets.UTF_8));
      System.setErr(new PrintStream(complained, true, StandardCharsets.UTF_8));
      code =
          BotsMain.run(
              new Hurry(),
              "--host",
              "localhost:1",
              "--count",
              "2",
              "--seconds",
              "1",
              "--log-level",
              "error");
    } finally {
      System.setOut(out);
      System.setErr(err);
    }
    String[] lines = printed.toString(StandardCharsets.UTF_8).strip().split("\n");
    assertTrue(lines[lines.length - 1].matches(SHAPE), lines[lines.length - 1]);
    assertEquals(1, code);
    String complaint = complained.toString(StandardCharsets.UTF_8);
    assertTrue(complaint.contains("0 of 2 bots joined. Can't reach the server"), complaint);
  }

  @Test
  void refusesFlagsThatMakeNoSense() {
    PrintStream err = System.err;
    ByteArrayOutputStream complained = new ByteArrayOutputStream();
    try {
      System.setErr(new PrintStream(complained, true, StandardCharsets.UTF_8));
      assertEquals(2, BotsMain.run("--count", "0"));
      assertEquals(2, BotsMain.run("--host", "localhost:70000"));
      assertEquals(2, BotsMain.run("--colour", "red"));
    } finally {
      System.setErr(err);
    }
    assertTrue(
        complained.toString(StandardCharsets.UTF_8).contains("--count=0 is outside 1..1000"));
  }
}

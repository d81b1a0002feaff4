package carom.client.bots;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.bots.ThinDoor.Goal;
import java.io.IOException;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/**
 * Goal: thin bots go where their room is, with their seat, and no further than that. Method: a door
 * that the test speaks through, and virtual time.
 */
final class ThinFarmTest {
  private static final long MS = 1_000_000;

  private final List<Goal> goals = new CopyOnWriteArrayList<>();
  private final ThinFarm farm = new ThinFarm(this::open, "bot", "cup", 1, 1);
  private volatile ThinPicture told;
  private volatile boolean unreachable;
  private long nowNs = MS;

  private ThinDoor open(String name, Goal goal, ThinPicture picture) throws IOException {
    goals.add(goal);
    if (unreachable) {
      throw new IOException("nobody answers");
    }
    told = picture;
    return new ThinDoor() {
      @Override
      public void input(int n, int seen, int buttons, float moveX, float moveY, float aim) {}

      @Override
      public long bytesOut() {
        return 0;
      }

      @Override
      public void close() {}
    };
  }

  @AfterEach
  void close() {
    farm.close();
  }

  private void updateUntil(BooleanSupplier done) {
    for (int i = 0; !done.getAsBoolean(); i++) {
      assertTrue(i < 100_000, () -> goals + " " + farm.progress());
      nowNs += 10 * MS;
      farm.update(nowNs);
      Thread.onSpinWait();
    }
  }

  /** Lets the bot come in, and be told of a seat. */
  private void comeIn() {
    comeIn("5be1");
  }

  private void comeIn(String secret) {
    int before = goals.size();
    told = null;
    updateUntil(() -> goals.size() > before && told != null);
    told.welcome(secret);
    told.match(3, "cup");
    told.snapshot(10, 1, 0, nowNs);
    updateUntil(() -> farm.playing() == 1);
    nowNs += MS;
    farm.update(nowNs);
  }

  @Test
  void aBotThatIsSentAwayGoesThereWithItsSeat() {
    comeIn();
    assertEquals(List.of(new Goal("", "cup", "", "")), goals);
    told.standby("c:1");
    told.redirect("b:8080", "cup", "ticket");
    told.end("1000");
    comeIn();
    assertEquals(new Goal("b:8080", "cup", "5be1", "ticket"), goals.get(1));
    BotReport report = farm.report(nowNs);
    assertEquals(1, report.redirects());
    assertEquals(0, report.disconnects());
    assertEquals(2, told.snapshots(), "its figures go on");
  }

  @Test
  void aBotWhoseServerIsLostGoesToTheFollower() {
    comeIn();
    told.standby("c:1");
    told.end("the connection broke");
    comeIn();
    assertEquals(new Goal("c:1", "cup", "5be1", ""), goals.get(1));
    assertEquals(0, farm.report(nowNs).disconnects(), "it has its seat");
    assertEquals(1, farm.report(nowNs).reconnects());
  }

  @Test
  void aBotThatBeginsAnewHasLostItsSeat() {
    comeIn();
    told.end("the connection broke");
    comeIn("0a7e");
    assertEquals(1, farm.report(nowNs).disconnects());
  }

  @Test
  void aBotComesBackToALostServerSixTimesAtMost() {
    comeIn();
    unreachable = true;
    told.end("the connection broke");
    updateUntil(farm::over);
    assertEquals(1 + 6, goals.size());
    assertEquals(new Goal("", "cup", "5be1", ""), goals.get(6));
    assertEquals(0, farm.report(nowNs).rejected(), "it had joined");
    assertEquals(1, farm.report(nowNs).disconnects());
  }

  @Test
  void aBotThatIsToldToGoStaysAway() {
    comeIn();
    told.standby("c:1");
    told.refuse("KICKED");
    updateUntil(farm::over);
    assertEquals(1, goals.size());
    assertEquals(1, farm.report(nowNs).disconnects());
  }
}

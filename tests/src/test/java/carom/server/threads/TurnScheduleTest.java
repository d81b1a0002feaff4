package carom.server.threads;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.server.threads.TurnSchedule.Item;
import carom.server.threads.TurnSchedule.Line;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/**
 * Goal: every item has its turns in time, one at a time, whatever the others do, and threads sleep
 * as much as they can. Method: threads in virtual time, which wake when the schedule has said.
 */
class TurnScheduleTest {
  private static final long MS = 1_000_000;
  private static final long TICK_NS = 16_666_667;
  private static final long SEED = Long.getLong("carom.seed", 42);

  /** An item that needs a turn at each tick. */
  private static final class Ticking extends Item {
    private long nextNs;
    private boolean hasLinks;
    private boolean rests;
    private int turns;
    private int ticks;
    private long worstNs;
    private boolean running;
    private int threads; // changes of the thread
    private Sleeper last;
  }

  /** A thread in virtual time. */
  private static final class Sleeper {
    private final Line line;
    private long looksNs;
    private long backNs;
    private Ticking running;
    private int looks;

    Sleeper(Line line) {
      this.line = line;
    }
  }

  /** How long a turn takes, ns. */
  private interface Costs {
    long of(Ticking item, boolean ticks);
  }

  private final TurnSchedule schedule = new TurnSchedule();
  private final List<Sleeper> sleepers = new ArrayList<>();
  private final List<Ticking> items = new ArrayList<>();
  private long nowNs;

  private void threads(int count) {
    for (int i = 0; i < count; i++) {
      sleepers.add(new Sleeper(schedule.addLine(nowNs)));
    }
  }

  private Ticking item(long firstNs, boolean hasLinks) {
    Ticking item = new Ticking();
    item.nextNs = firstNs;
    item.hasLinks = hasLinks;
    items.add(item);
    look(schedule.add(item, firstNs, nowNs));
    return item;
  }

  private void look(Line line) {
    for (Sleeper sleeper : sleepers) {
      if (sleeper.line == line && sleeper.running == null) {
        sleeper.looksNs = nowNs;
      }
    }
  }

  /** Plays until a time: whatever happens next, the end of a turn or of a nap. */
  private void play(long untilNs, Costs costs) {
    while (true) {
      Sleeper next = null;
      for (Sleeper sleeper : sleepers) {
        if (next == null || nextNs(sleeper) < nextNs(next)) {
          next = sleeper;
        }
      }
      if (nextNs(next) > untilNs) {
        nowNs = untilNs;
        return;
      }
      nowNs = Math.max(nowNs, nextNs(next));
      if (next.running != null) {
        end(next);
      }
      begin(next, costs);
    }
  }

  private static long nextNs(Sleeper sleeper) {
    return sleeper.running != null ? sleeper.backNs : sleeper.looksNs;
  }

  private void begin(Sleeper sleeper, Costs costs) {
    sleeper.looks++;
    Ticking item = (Ticking) schedule.take(sleeper.line, nowNs);
    if (item == null) {
      long napNs = schedule.nap(sleeper.line, nowNs);
      assertTrue(napNs > 0, "a thread that may nap has no reason to look at once");
      sleeper.looksNs = napNs == TurnSchedule.NEVER ? napNs : nowNs + napNs;
      return;
    }
    assertFalse(item.running, "turns of an item overlap");
    item.running = true;
    sleeper.running = item;
    look(schedule.guard(nowNs));
    boolean ticks = item.nextNs <= nowNs;
    item.turns++;
    item.threads += item.last != null && item.last != sleeper ? 1 : 0;
    item.last = sleeper;
    if (ticks) {
      item.worstNs = Math.max(item.worstNs, nowNs - item.nextNs);
      item.ticks++;
      item.nextNs += TICK_NS;
    }
    sleeper.backNs = nowNs + costs.of(item, ticks);
  }

  private void end(Sleeper sleeper) {
    Ticking item = sleeper.running;
    item.running = false;
    sleeper.running = null;
    long napNs = item.rests ? TurnSchedule.NEVER : item.nextNs - nowNs;
    look(schedule.put(item, napNs, item.hasLinks && !item.rests, nowNs));
  }

  private void wake(Ticking item) {
    item.rests = false;
    item.nextNs = nowNs;
    item.worstNs = 0;
    look(schedule.wake(item, nowNs));
  }

  @Test
  void aSingleRoomHasTheTurnsThatAThreadOfItsOwnWouldGiveIt() {
    threads(2);
    Ticking item = item(TICK_NS, true);
    play(1_000 * MS, (i, ticks) -> ticks ? MS : 10_000);
    assertEquals(0, item.worstNs);
    assertEquals(59, item.ticks);
    assertEquals(0, item.threads);
    assertEquals(59 * 4, item.turns, 4, "the tick, and 4, 8 and 12 ms after it");
    assertEquals(1, Math.min(sleepers.get(0).looks, sleepers.get(1).looks), "the other sleeps");
  }

  @Test
  void asManyRoomsAsThreadsHaveAThreadEach() {
    threads(4);
    for (int i = 0; i < 4; i++) {
      item(TICK_NS + i * TICK_NS / 4, true);
    }
    play(10_000 * MS, (item, ticks) -> ticks ? 12 * MS : 10_000);
    for (Ticking item : items) {
      assertEquals(0, item.worstNs);
      assertEquals(0, item.threads);
    }
  }

  @Test
  void aThreadThatIsAwakeLooksForAllLinksAtOnce() {
    threads(1);
    for (int i = 0; i < 8; i++) {
      item(TICK_NS + i * 100_000L, true);
    }
    play(10_000 * MS, (item, ticks) -> ticks ? 50_000 : 5_000);
    int turns = items.stream().mapToInt(item -> item.turns).sum();
    int naps = sleepers.get(0).looks - turns;
    assertTrue(naps * 3 < turns, "naps=" + naps + " turns=" + turns);
  }

  @Test
  void aLongTickDelaysNoOtherRoomWhileAThreadIsFree() {
    threads(2);
    for (int i = 0; i < 6; i++) {
      item(TICK_NS + i * TICK_NS / 6, i % 2 == 0);
    }
    Ticking slow = items.get(2);
    play(10_000 * MS, (item, ticks) -> ticks ? item == slow ? 15 * MS : 500_000 : 10_000);
    for (Ticking item : items) {
      // Its own thread's patience, and a turn of another room that runs just then.
      assertTrue(item.worstNs <= 2 * MS, "worst=" + item.worstNs + " of " + items.indexOf(item));
      assertEquals(599, item.ticks, 1);
    }
  }

  @Test
  void aThreadThatNeverComesBackLosesItsRoomsToTheOthers() {
    threads(2);
    for (int i = 0; i < 6; i++) {
      item(TICK_NS + i * TICK_NS / 6, true);
    }
    Ticking hangs = items.get(3);
    play(10_000 * MS, (item, ticks) -> ticks && item == hangs ? Long.MAX_VALUE / 4 : 200_000);
    for (Ticking item : items) {
      assertTrue(item == hangs || item.ticks >= 598, "ticks=" + item.ticks);
    }
  }

  @Test
  void theThreadInThePlaceOfOneThatHangsHasItsRooms() {
    threads(1);
    item(TICK_NS, true);
    item(TICK_NS, true);
    Costs costs = (item, ticks) -> item == items.get(0) ? Long.MAX_VALUE / 4 : 100_000;
    play(100 * MS, costs);
    assertTrue(items.get(1).ticks <= 1);
    Sleeper hangs = sleepers.remove(0);
    schedule.replace(hangs.line, nowNs);
    sleepers.add(new Sleeper(hangs.line));
    play(1_100 * MS, costs);
    assertTrue(items.get(1).ticks >= 60, "ticks=" + items.get(1).ticks);
    // It comes back after all, and its room goes on.
    int ticks = items.get(0).ticks;
    end(hangs);
    play(2_100 * MS, (item, own) -> 100_000);
    assertTrue(items.get(0).ticks >= ticks + 59, "ticks=" + items.get(0).ticks);
  }

  @Test
  void aRoomThatRestsCostsNothingUntilItIsWoken() {
    threads(2);
    for (int i = 0; i < 512; i++) {
      item(nowNs, true).rests = true;
    }
    play(1_000 * MS, (item, ticks) -> 10_000);
    int looks = sleepers.get(0).looks + sleepers.get(1).looks;
    play(100_000 * MS, (item, ticks) -> 10_000);
    assertEquals(looks, sleepers.get(0).looks + sleepers.get(1).looks, "nobody looks");
    Ticking woken = items.get(400);
    int turns = woken.turns;
    wake(woken);
    play(101_000 * MS, (item, ticks) -> 10_000);
    assertTrue(woken.turns >= turns + 60);
    assertEquals(0, woken.worstNs);
    woken.rests = true;
    play(102_000 * MS, (item, ticks) -> 10_000);
    looks = sleepers.get(0).looks + sleepers.get(1).looks;
    play(200_000 * MS, (item, ticks) -> 10_000);
    assertEquals(looks, sleepers.get(0).looks + sleepers.get(1).looks);
  }

  @Test
  void aWakeDuringATurnGivesAnotherOne() {
    threads(1);
    Item item = new Item();
    schedule.add(item, 0, 0);
    Line line = sleepers.get(0).line;
    assertSame(item, schedule.take(line, 0));
    assertNull(schedule.wake(item, 5));
    schedule.put(item, TurnSchedule.NEVER, false, 10);
    assertSame(item, schedule.take(line, 10));
    schedule.put(item, TurnSchedule.NEVER, false, 20);
    assertNull(schedule.take(line, 20));
    assertEquals(TurnSchedule.NEVER, schedule.nap(line, 20));
    assertSame(line, schedule.wake(item, 30));
    assertNotNull(schedule.take(line, 30));
  }

  @Test
  void roomsThatWakeTogetherAreSharedOut() {
    threads(4);
    for (int i = 0; i < 100; i++) {
      item(nowNs, false).rests = true;
    }
    play(10 * MS, (item, ticks) -> 10_000);
    for (int i = 0; i < 4; i++) {
      wake(items.get(25 * i));
    }
    play(1_000 * MS, (item, ticks) -> 15 * MS);
    for (int i = 0; i < 4; i++) {
      assertEquals(0, items.get(25 * i).worstNs, 0.01 * TICK_NS);
    }
  }

  /** With time for all, no room's tick is later than the longest turn and the patience. */
  @Test
  void anyRoomsWithAnyTurnsAreInTime() {
    Random random = new Random(SEED);
    for (int round = 0; round < 60; round++) {
      items.clear();
      sleepers.clear();
      TurnScheduleTest rig = new TurnScheduleTest();
      int threads = 1 + random.nextInt(8);
      int rooms = 1 + random.nextInt(40);
      rig.threads(threads);
      for (int i = 0; i < rooms; i++) {
        rig.item(random.nextInt((int) TICK_NS), random.nextBoolean());
      }
      long mostNs = TICK_NS * threads * 6 / 10 / rooms; // so that six tenths of the time are taken
      long longNs = 2 * Math.min(mostNs, TICK_NS / 3);
      Random costs = new Random(random.nextLong());
      for (long at = 0; at < 4_000 * MS; at += 50 * MS) {
        rig.play(at, (item, ticks) -> ticks ? 1 + (long) (costs.nextDouble() * longNs) : 2_000);
        Ticking any = rig.items.get(random.nextInt(rooms));
        rig.look(rig.schedule.wake(any, rig.nowNs));
      }
      String told = "seed=" + SEED + " round=" + round + " threads=" + threads + " rooms=" + rooms;
      for (Ticking item : rig.items) {
        assertTrue(item.ticks >= 230, told + " ticks=" + item.ticks);
      }
    }
  }
}

package carom.net.snapshot.ledger;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/**
 * Goal: each section hears once of each thing that it appended, whatever the line does. Method: a
 * client behind dice that lose, repeat, delay and reorder datagrams and acknowledgements. The
 * oracle keeps a list of all datagrams and applies the definitions of {@link DatagramLedger} to
 * each of them.
 */
class DatagramLedgerTest {
  private static final int SECTIONS = 3;
  private static final Resend AGAIN = new Resend(2, 3, Resend.Again.WHEN_OVERDUE);
  private static final Resend EACH = new Resend(1, 1, Resend.Again.EACH_SNAPSHOT);
  private static final Resend ONCE = new Resend(1, 2, Resend.Again.WHEN_LOST);

  private enum Fate {
    ON_ITS_WAY,
    ACKNOWLEDGED,
    LOST
  }

  /** A datagram as the oracle knows it. */
  private static final class Sent {
    final int number;
    final int tick;
    final List<String> entries = new ArrayList<>();
    Fate fate = Fate.ON_ITS_WAY;
    boolean named;

    Sent(int number, int tick) {
      this.number = number;
      this.tick = tick;
    }
  }

  /** An acknowledgement or a datagram that is on its way, until a tick. */
  private record Flight(int arrives, int number, long older) {}

  /** What one run of the dice does. */
  private record Line(double loss, double copies, int delay, int jitter, double silence) {}

  /** A ledger, the client behind the dice, and the oracle. */
  private static final class Run {
    final Random random;
    final String name;
    final DatagramLedger ledger;
    final int maxEntries;
    final List<Sent> all = new ArrayList<>();
    final List<Flight> down = new ArrayList<>();
    final List<Flight> up = new ArrayList<>();
    final TreeSet<Integer> received = new TreeSet<>();
    final List<String> heard = new ArrayList<>();
    final List<String> expected = new ArrayList<>();
    final DatagramLedger.Section[] sections = new DatagramLedger.Section[SECTIONS];
    int tick = 1_000;
    int nextKey;
    int newestAckedTick = Integer.MIN_VALUE;
    int lost;
    int late;

    Run(long seed, int entries, int maxEntries) {
      random = new Random(seed);
      name = "seed=" + seed;
      this.maxEntries = maxEntries;
      ledger = new DatagramLedger(entries, maxEntries);
      for (int i = 0; i < SECTIONS; i++) {
        sections[i] = section(i);
      }
    }

    private DatagramLedger.Section section(int id) {
      return new DatagramLedger.Section() {
        @Override
        public void acknowledged(int at, int key, long bits) {
          heard.add(text(Fate.ACKNOWLEDGED, at, entry(id, key, bits)));
        }

        @Override
        public void lost(int at, int key, long bits) {
          heard.add(text(Fate.LOST, at, entry(id, key, bits)));
        }
      };
    }

    private String entry(int section, int key, long bits) {
      return section + " " + key + " " + bits;
    }

    private String text(Fate fate, int at, String entry) {
      return fate + " " + at + " " + entry;
    }

    /** Begins a datagram, with what sections append, and sends it down the line. */
    void send(Line line, int entries) {
      Sent sent = new Sent(all.size(), tick);
      expectRoom();
      assertEquals(sent.number & 0xffff, ledger.begin(tick, random.nextBoolean()), name);
      all.add(sent);
      for (int i = 0; i < entries; i++) {
        int section = random.nextInt(SECTIONS);
        long bits = random.nextLong();
        expectRoomInLog();
        sent.entries.add(entry(section, nextKey, bits));
        ledger.append(sections[section], nextKey++, bits);
      }
      ledger.end(1 + random.nextInt(1_200));
      compare();
      for (int i = random.nextDouble() < line.copies ? 2 : 1; i > 0; i--) {
        if (random.nextDouble() >= line.loss) {
          down.add(new Flight(arrival(line), sent.number, 0));
        }
      }
    }

    private int arrival(Line line) {
      return tick + line.delay + (line.jitter == 0 ? 0 : random.nextInt(line.jitter + 1));
    }

    /** More datagrams than the ledger has room for: the oldest is lost. */
    private void expectRoom() {
      Sent oldest = oldest();
      if (oldest != null && all.size() - oldest.number == DatagramLedger.SIZE) {
        expect(oldest, Fate.LOST);
      }
    }

    /** More entries than the log has room for: the oldest datagram is lost, until one had some. */
    private void expectRoomInLog() {
      while (true) {
        int kept = 0;
        Sent oldest = oldest();
        for (int i = oldest.number; i < all.size(); i++) {
          kept += all.get(i).entries.size();
        }
        if (kept < maxEntries) {
          return;
        }
        expect(oldest, Fate.LOST);
      }
    }

    private Sent oldest() {
      for (int i = Math.max(0, all.size() - DatagramLedger.SIZE); i < all.size(); i++) {
        if (all.get(i).fate == Fate.ON_ITS_WAY) {
          return all.get(i);
        }
      }
      return null;
    }

    private void expect(Sent sent, Fate fate) {
      sent.fate = fate;
      lost += fate == Fate.LOST ? 1 : 0;
      for (String entry : sent.entries) {
        expected.add(text(fate, sent.tick, entry));
      }
    }

    /** Passes a tick: what is due arrives, and the client acknowledges. */
    void pass(Line line) {
      tick++;
      for (Flight f : due(down)) {
        received.add(f.number);
        if (random.nextDouble() >= line.loss && random.nextDouble() >= line.silence) {
          acknowledge(line);
        }
      }
      for (Flight f : due(up)) {
        receive(f.number, f.older);
      }
    }

    private List<Flight> due(List<Flight> from) {
      List<Flight> arrived = new ArrayList<>();
      for (Flight f : from) {
        if (f.arrives <= tick) {
          arrived.add(f);
        }
      }
      from.removeAll(arrived);
      return arrived;
    }

    void acknowledge(Line line) {
      int newest = received.last();
      long older = 0;
      for (int i = 0; i < Long.SIZE; i++) {
        older |= received.contains(newest - 1 - i) ? 1L << i : 0;
      }
      up.add(new Flight(arrival(line), newest, older));
    }

    /** Hands an acknowledgement to the ledger, and to the oracle. */
    void receive(int newest, long older) {
      List<Sent> named = new ArrayList<>();
      for (int back = Long.SIZE; back >= 0; back--) {
        int number = newest - back;
        boolean set = back == 0 || (older >>> back - 1 & 1) != 0;
        if (set && number >= 0 && number < all.size()) {
          if (all.size() - number <= DatagramLedger.SIZE && !all.get(number).named) {
            named.add(all.get(number));
          }
        }
      }
      for (Sent sent : named) {
        sent.named = true;
        newestAckedTick = Math.max(newestAckedTick, sent.tick);
        late += sent.fate == Fate.LOST ? 1 : 0;
      }
      for (Sent sent : all.subList(Math.max(0, all.size() - DatagramLedger.SIZE), all.size())) {
        if (sent.fate == Fate.ON_ITS_WAY) {
          if (sent.named) {
            expect(sent, Fate.ACKNOWLEDGED);
          } else if (newestAckedTick - sent.tick >= DatagramLedger.LOST_TICKS) {
            expect(sent, Fate.LOST);
          }
        }
      }
      ledger.receive(newest & 0xffff, older, tick);
      compare();
      assertEquals(all.stream().filter(s -> s.named).count(), ledger.ackedDatagrams(), name);
    }

    /** What was heard is what the oracle expects, in its order. */
    private void compare() {
      assertEquals(expected, heard, name);
      expected.clear();
      heard.clear();
    }

    /** Whatever was sent has been told, and nothing is kept. */
    void settle() {
      Line clean = new Line(0, 0, 0, 0, 0);
      for (int i = 0; i <= DatagramLedger.LOST_TICKS; i++) {
        send(clean, 0);
        pass(clean);
      }
      assertEquals(0, ledger.entries(), name);
      assertTrue(all.stream().noneMatch(s -> s.fate == Fate.ON_ITS_WAY), name);
    }
  }

  @Test
  void eachSectionHearsOnceOfWhatItAppendedWhateverTheLineDoes() {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    Random dice = new Random(seed);
    int lost = 0;
    int late = 0;
    for (int round = 0; round < 30; round++) {
      Run run = new Run(seed + round, 4, round % 3 == 0 ? 64 : 1 << 12);
      for (int phase = 0; phase < 6; phase++) {
        boolean cut = dice.nextInt(6) == 0; // nothing arrives
        Line line =
            new Line(
                cut ? 1 : dice.nextInt(4) * 0.15,
                dice.nextInt(2) * 0.2,
                dice.nextInt(12),
                dice.nextInt(3) * 6,
                dice.nextInt(2) * 0.7);
        for (int t = 0; t < 120; t++) {
          for (int i = dice.nextInt(cut ? 8 : 4); i > 0; i--) {
            run.send(line, dice.nextInt(6));
          }
          run.pass(line);
        }
      }
      run.settle();
      lost += run.lost;
      late += run.late;
    }
    assertTrue(lost > 1_000 && late > 50, "seed=" + seed + " lost=" + lost + " late=" + late);
  }

  @Test
  void sequenceNumbersWrapAndStrangersAcknowledgeNothing() {
    Run run = new Run(1, 4, 64);
    Line line = new Line(0.1, 0.1, 2, 8, 0);
    for (int t = 0; t < 500; t++) {
      run.send(line, 1);
      run.pass(line);
    }
    run.settle();
    run.up.clear();
    // The oracle looks at the newest ones only, so the way around is quick.
    while (run.all.size() < (1 << 16) - 300) {
      run.send(new Line(1, 0, 0, 0, 0), 0);
      run.tick += run.all.size() % 64 == 0 ? 1 : 0;
    }
    run.received.clear();
    for (int t = 0; t < 600; t++) {
      run.send(line, 1);
      run.pass(line);
      if (t % 10 == 0) { // never sent, or forgotten
        int strange = run.all.size() + run.random.nextInt(20_000);
        run.ledger.receive(strange & 0xffff, 0, run.tick);
        run.ledger.receive(run.all.size() - 1 - DatagramLedger.SIZE & 0xffff, 0, run.tick);
        assertEquals(List.of(), run.heard);
      }
    }
    assertTrue(run.all.size() > 1 << 16);
    run.settle();
  }

  @Test
  void somethingIsDueAsItsRuleSays() {
    Run run = new Run(2, 4, 64);
    Line clean = new Line(0, 0, 0, 0, 0);
    for (int t = 0; t < 200; t++) { // acknowledgements take one tick
      run.send(clean, 1);
      run.pass(clean);
    }
    DatagramLedger ledger = run.ledger;
    int now = run.tick;
    for (Resend rule : new Resend[] {AGAIN, EACH, ONCE}) {
      assertTrue(ledger.isDue(rule, 0, 0, now), "never sent");
    }
    assertTrue(ledger.isDue(AGAIN, 1, now - 1, now));
    assertFalse(ledger.isDue(AGAIN, 1, now, now), "in this snapshot already");
    assertFalse(ledger.isDue(AGAIN, 2, now - 3, now));
    assertTrue(ledger.isDue(AGAIN, 2, now - 4, now), "overdue");
    assertTrue(ledger.isDue(EACH, 1, now - 1, now));
    assertFalse(ledger.isDue(EACH, 1, now, now));
    assertFalse(ledger.isDue(ONCE, 1, now - 50, now));
    assertFalse(ledger.isLossy(now));
    run.send(new Line(1, 0, 0, 0, 0), 1);
    for (int t = 0; t < 5; t++) {
      run.pass(clean);
      run.send(clean, 0);
    }
    assertTrue(ledger.isLossy(run.tick));
    assertEquals(3, ledger.copies(AGAIN, run.tick));
    assertEquals(2, ledger.copies(AGAIN, run.tick + 600));
  }
}

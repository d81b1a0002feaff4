package carom.net.snapshot.table;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.codec.BitReader;
import carom.net.codec.BitWriter;
import carom.net.snapshot.ledger.DatagramLedger;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/**
 * Goal: each client ends up with what it may know of the tables, whatever the network does, and
 * with nothing else. Method: a server's outbox and a client's inbox on a bad network in virtual
 * time.
 */
class TableChannelTest {
  private static final int DELAY = 5;
  private static final int BUDGET_BITS = 400;

  /** Three words: 7 bits from -20 on, a flag that only class 2 may know, and raw bits. */
  private static TableLayout fields(boolean urgent) {
    return new TableLayout(
        200,
        8,
        false,
        new int[] {7, 1, 32},
        new int[] {-20, 0, 0},
        new int[] {100, 0, 0},
        new int[] {0b110, 0b100, 0b110},
        urgent);
  }

  /** Rows of 25 raw words that come and go, as the constants of a joint. */
  private static TableLayout definitions() {
    int[] bits = new int[25];
    Arrays.fill(bits, 32);
    int[] audiences = new int[25];
    Arrays.fill(audiences, 2);
    return new TableLayout(500, 4, true, bits, new int[25], new int[25], audiences, false);
  }

  @SuppressWarnings("ArrayRecordComponent") // never compared
  private record Flight(int datagram, int tick, byte[] bytes, int length, int arrives) {}

  /** One client on a network that loses, delays and repeats. */
  private static final class Channel implements RowAudience {
    final Tables tables;
    final byte[][] classes;
    final DatagramLedger ledger = new DatagramLedger();
    final TableOutbox outbox;
    final TableInbox inbox;
    final Random random;
    final double loss;
    final List<Flight> down = new ArrayList<>();
    final List<Flight> up = new ArrayList<>();
    int datagram;
    long bits;
    boolean[] seen = new boolean[1 << 16];
    int sent;

    Channel(Tables tables, Random random, double loss) {
      this.tables = tables;
      this.random = random;
      this.loss = loss;
      classes = new byte[tables.count()][];
      TableLayout[] layouts = tables.layouts();
      for (int i = 0; i < layouts.length; i++) {
        classes[i] = new byte[layouts[i].keys()];
        Arrays.fill(classes[i], (byte) 1);
      }
      outbox = new TableOutbox(tables, this, ledger);
      inbox = new TableInbox(layouts);
    }

    @Override
    public long inSight(int table, int block, long keys) {
      long result = 0;
      for (long rest = keys; rest != 0; rest &= rest - 1) {
        int key = (block << 6) + Long.numberOfTrailingZeros(rest);
        result |= classes[table][key] != 0 ? Long.lowestOneBit(rest) : 0;
      }
      return result;
    }

    @Override
    public int of(int table, int key) {
      return classes[table][key];
    }

    void become(int table, int key, int audience) {
      classes[table][key] = (byte) audience;
      outbox.audienceChanged(table, key >> 6, 1L << key);
    }

    /** Sends a snapshot if there is anything to say, and moves what is on its way. */
    void tick(int tick) {
      if (outbox.hasDue(tick)) {
        byte[] bytes = new byte[1_200];
        BitWriter w = new BitWriter();
        w.reset(bytes, 0, bytes.length);
        ledger.begin(tick, false);
        outbox.write(w, tick, BUDGET_BITS);
        assertFalse(w.overflow());
        bits += w.bits();
        sent++;
        int copies = random.nextDouble() < 0.02 ? 2 : 1;
        for (int i = 0; i < copies && random.nextDouble() >= loss; i++) {
          int arrives = tick + DELAY + random.nextInt(6);
          down.add(new Flight(datagram, tick, bytes, w.bytes(), arrives));
        }
        datagram++;
      }
      for (Flight f : take(down, tick)) {
        if (!seen[f.datagram & 0xffff]) {
          seen[f.datagram & 0xffff] = true;
          BitReader r = new BitReader();
          r.reset(f.bytes, 0, f.length);
          inbox.read(r);
          assertTrue(r.finished(), "seed tells all");
          inbox.keep(f.tick);
          if (random.nextDouble() >= loss) {
            up.add(new Flight(f.datagram, f.tick, null, 0, tick + DELAY + random.nextInt(6)));
          }
        }
      }
      for (Flight f : take(up, tick)) {
        ledger.receive(f.datagram & 0xffff, 0, tick);
      }
    }

    private static List<Flight> take(List<Flight> from, int tick) {
      List<Flight> arrived = from.stream().filter(f -> f.arrives <= tick).toList();
      from.removeAll(arrived);
      return arrived;
    }

    /** Compares all that the client may know now. */
    void compare(String when) {
      for (int t = 0; t < tables.count(); t++) {
        TableRows server = tables.get(t).rows();
        TableLayout layout = tables.get(t).layout();
        for (int key = 0; key < layout.keys(); key++) {
          long may = layout.known(key, classes[t][key]);
          if (may == 0) {
            continue;
          }
          String where = when + " table=" + t + " key=" + key;
          assertEquals(server.isPresent(key), inbox.isPresent(t, key), where);
          for (int word = 0; server.isPresent(key) && word < layout.width(); word++) {
            int start = server.start(key, word);
            int expected = (may >>> word & 1) == 0 ? start : server.get(key, word);
            int identity = server.identity(key);
            int actual = inbox.get(t, key, identity, word);
            assertEquals(expected, actual, where + " word=" + word);
          }
        }
      }
    }
  }

  private static void change(Tables tables, Random random, int tick) {
    Table fields = tables.get(0);
    for (int n = random.nextInt(4); n > 0; n--) {
      int key = random.nextInt(fields.layout().keys());
      int identity = fields.rows().identity(key) + (random.nextInt(10) == 0 ? 1 : 0) & 0xff;
      boolean start = random.nextInt(3) == 0;
      int[] row = {
        start ? 100 : random.nextInt(128) - 20,
        start ? 0 : random.nextInt(2),
        start || random.nextBoolean() ? 0 : random.nextInt()
      };
      fields.put(key, identity, row, 0, tick);
    }
    Table definitions = tables.get(1);
    if (random.nextInt(10) == 0) {
      int key = random.nextInt(definitions.layout().keys());
      if (random.nextInt(3) == 0) {
        definitions.remove(key, tick);
      } else {
        int identity = random.nextInt(16);
        definitions.put(key, identity, random.ints(25).toArray(), 0, tick);
      }
    }
  }

  @Test
  void aClientEndsUpWithWhatItMayKnowWhateverTheNetworkDoes() {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    Random random = new Random(seed);
    for (int round = 0; round < 20; round++) {
      Tables tables = new Tables(List.of(new Table(fields(false)), new Table(definitions())));
      int[] placed = random.ints(25).toArray();
      tables.get(1).place(7, 3, placed, 0);
      Channel channel = new Channel(tables, random, random.nextInt(3) * 0.2);
      channel.inbox.place(1, 7, 3, placed, 0);
      int tick = 10;
      for (int phase = 0; phase < 4; phase++) {
        for (int i = 0; i < 200; i++, tick++) {
          change(tables, random, tick);
          if (random.nextInt(8) == 0) {
            channel.become(0, random.nextInt(200), random.nextInt(3));
            channel.become(1, random.nextInt(500), random.nextInt(2));
          }
          channel.tick(tick);
        }
        for (int i = 0; i < 3_000; i++, tick++) {
          channel.tick(tick);
        }
        channel.compare("seed=" + seed + " round=" + round + " phase=" + phase);
        assertEquals(0, channel.outbox.unacked(tick - 1), "seed=" + seed);
      }
    }
  }

  @Test
  void nothingIsSentWhileNothingChangesAndStartValuesCostNothing() {
    Tables tables = new Tables(List.of(new Table(fields(false)), new Table(definitions())));
    Table fields = tables.get(0);
    Channel channel = new Channel(tables, new Random(1), 0);
    for (int key = 0; key < 200; key++) {
      fields.put(key, 3, new int[] {100, 0, 0}, 0, 1);
    }
    channel.tick(1);
    assertEquals(0, channel.sent);
    fields.put(9, 3, new int[] {80, 0, 0}, 0, 2);
    for (int tick = 2; tick < 100; tick++) {
      channel.tick(tick);
    }
    assertEquals(1, channel.sent);
    assertEquals(80, channel.inbox.get(0, 9, 3, 0));
    assertEquals(100, channel.inbox.get(0, 9, 4, 0), "another user of the key");
    assertEquals(2, channel.inbox.tick(0, 9));
    assertEquals(-1, channel.inbox.tick(0, 10));
  }

  @Test
  void aChangedWordTakesFourBytes() {
    Tables tables = new Tables(List.of(new Table(fields(false)), new Table(definitions())));
    Channel channel = new Channel(tables, new Random(1), 0);
    tables.get(0).put(9, 3, new int[] {80, 0, 0}, 0, 1);
    for (int tick = 1; tick < 50; tick++) {
      channel.tick(tick);
    }
    long before = channel.bits;
    tables.get(0).put(9, 3, new int[] {60, 0, 0}, 0, 50);
    for (int tick = 50; tick < 100; tick++) {
      channel.tick(tick);
    }
    long bits = channel.bits - before;
    assertTrue(bits <= 32, "bits=" + bits);
  }

  @Test
  void aWordThatAClassMayNotKnowNeverLeavesTheServer() {
    Tables tables = new Tables(List.of(new Table(fields(false)), new Table(definitions())));
    Channel channel = new Channel(tables, new Random(1), 0);
    channel.become(0, 5, 1);
    for (int tick = 1; tick < 100; tick++) {
      tables.get(0).put(5, 0, new int[] {100, tick & 1, 0}, 0, tick);
      channel.tick(tick);
    }
    assertEquals(0, channel.inbox.get(0, 5, 1));
    channel.become(0, 5, 2);
    tables.get(0).put(5, 0, new int[] {100, 1, 0}, 0, 100);
    for (int tick = 100; tick < 130; tick++) {
      channel.tick(tick);
    }
    assertEquals(1, channel.inbox.get(0, 5, 1));
  }

  @Test
  void anUrgentRowIsInEverySnapshotUntilItIsAcked() {
    Table table = new Table(fields(true));
    Channel channel = new Channel(new Tables(List.of(table)), new Random(1), 0);
    table.put(0, 0, new int[] {1, 0, 0}, 0, 1);
    for (int tick = 1; tick < 2 * DELAY; tick++) {
      channel.tick(tick);
      assertEquals(tick, channel.sent);
    }
    for (int tick = 2 * DELAY; tick < 100; tick++) {
      channel.tick(tick);
    }
    assertTrue(channel.sent < 4 * DELAY, "sent=" + channel.sent);
  }

  @Test
  void anyBitsAreReadWithoutHarm() {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    Random random = new Random(seed);
    TableInbox inbox = new TableInbox(fields(false), definitions());
    BitReader r = new BitReader();
    int good = 0;
    for (int i = 0; i < 50_000; i++) {
      byte[] bytes = new byte[random.nextInt(200)];
      random.nextBytes(bytes);
      if (bytes.length > 0 && random.nextBoolean()) {
        bytes[0] |= 3;
      }
      r.reset(bytes, 0, bytes.length);
      inbox.read(r);
      if (!r.failed()) {
        inbox.keep(random.nextInt(1_000));
        good++;
      }
      for (int n = 0; n < inbox.touchedCount(); n++) {
        int table = inbox.touchedTable(n);
        assertTrue(inbox.touchedKey(n) < inbox.layout(table).keys(), "seed=" + seed);
      }
    }
    assertTrue(good > 100, "seed=" + seed + " good=" + good);
    assertTrue(inbox.room(0) <= 200 && inbox.room(1) <= 500, "seed=" + seed);
  }

  /** 150 words of different widths take three rows. */
  @Test
  void aTargetWithMoreWordsThanARowHasChunks() {
    int n = 150;
    int[] bits = new int[n];
    int[] audiences = new int[n];
    for (int i = 0; i < n; i++) {
      bits[i] = 1 + i % 32;
      audiences[i] = i < 100 ? 0b110 : 0b100;
    }
    TableLayout layout =
        new TableLayout(10, 0, false, bits, new int[n], new int[n], audiences, false);
    assertEquals(3, layout.chunks());
    assertEquals(30, layout.keys());
    Table table = new Table(layout);
    Channel channel = new Channel(new Tables(List.of(table)), new Random(1), 0);
    int[] words = new int[3 * TableLayout.ROW_WORDS];
    for (int i = 0; i < n; i++) {
      words[i] = (int) ((1L << bits[i]) - 1);
    }
    for (int chunk = 0; chunk < 3; chunk++) {
      table.put(3 * 7 + chunk, 0, words, chunk * TableLayout.ROW_WORDS, 1);
    }
    for (int tick = 1; tick < 100; tick++) {
      channel.tick(tick);
    }
    for (int i = 0; i < n; i++) {
      int key = 3 * 7 + i / TableLayout.ROW_WORDS;
      int expected = i < 100 ? words[i] : 0;
      assertEquals(expected, channel.inbox.get(0, key, i % TableLayout.ROW_WORDS), "word " + i);
    }
  }
}

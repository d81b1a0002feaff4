package carom.net.snapshot.relay;

import carom.net.codec.BitReader;
import carom.net.codec.BitWriter;
import carom.net.protocol.PlayerId;
import carom.net.snapshot.frame.FrameRing;
import carom.net.snapshot.frame.FrameState;
import carom.net.snapshot.frame.PlayerSet;
import carom.net.snapshot.frame.WaitingInputs;
import java.util.Arrays;

/**
 * Inputs of other players: those that the server consumed in all ticks since the baseline, so that
 * whoever holds the baseline knows them all, however many datagrams were lost in between; and those
 * that {@linkplain WaitingInputs wait} for the next ticks. Pairs of write and read that mirror each
 * other.
 */
public final class RelayCodec {
  /** A baseline that is older tells nothing; then only the newest inputs are sent. */
  public static final int MAX_WINDOW = 16;

  /** Most players relayed to one client. */
  public static final int MAX_PLAYERS = 31;

  private static final int COUNT_BITS = 5;
  private static final int WAITING_BITS = 3;
  private static final int COMMON_BUTTONS = 5;

  private RelayCodec() {}

  /**
   * How many ticks of inputs are sent to a client whose baseline is so old; 0 = the newest only.
   */
  public static int window(int age) {
    return age <= MAX_WINDOW ? age : 0;
  }

  public static void writePlayers(BitWriter w, PlayerSet players) {
    w.write(players.size(), COUNT_BITS);
    for (int p = players.next(0); p >= 0; p = players.next(p + 1)) {
      PlayerId.write(w, p);
    }
  }

  public static void readPlayers(BitReader r, PlayerSet players) {
    players.clear();
    for (int n = r.read(COUNT_BITS); n > 0; n--) {
      players.add(PlayerId.read(r));
    }
  }

  /** Whether a relayed player has the same input in all ticks of a window, and in the next. */
  public static boolean isUnchanged(FrameRing ring, FrameState newest, int window, int player) {
    long base = inputAt(ring, newest.tick() - window, player);
    for (int back = 0; back < window; back++) {
      if (inputAt(ring, newest.tick() - back, player) != base) {
        return false;
      }
    }
    WaitingInputs waiting = ring.waiting();
    for (int ahead = 1; ahead <= waiting.count(player); ahead++) {
      if (waiting.at(player, ahead) != base) {
        return false;
      }
    }
    return true;
  }

  private static long inputAt(FrameRing ring, int tick, int player) {
    FrameState frame = ring.at(tick);
    return frame == null ? 0 : frame.input(player);
  }

  /**
   * Writes the inputs of the relayed players, in ascending order of their ids.
   *
   * @param known players that the client knows the input of at the baseline
   */
  public static void write(
      BitWriter w, FrameRing ring, int window, PlayerSet known, PlayerSet players) {
    FrameState newest = ring.newest();
    for (int p = players.next(0); p >= 0; p = players.next(p + 1)) {
      if (window == 0 || !known.has(p)) {
        writeInput(w, 0, newest.input(p));
        writeWaiting(w, ring.waiting(), p, newest.input(p));
        continue;
      }
      boolean changed = !isUnchanged(ring, newest, window, p);
      w.write(changed);
      if (!changed) {
        continue;
      }
      long before = inputAt(ring, newest.tick() - window, p);
      for (int back = window - 1; back >= 0; back--) {
        before = writeNext(w, before, inputAt(ring, newest.tick() - back, p));
      }
      writeWaiting(w, ring.waiting(), p, before);
    }
  }

  private static void writeWaiting(BitWriter w, WaitingInputs waiting, int player, long before) {
    int count = waiting.count(player);
    w.write(count, WAITING_BITS);
    for (int ahead = 1; ahead <= count; ahead++) {
      before = writeNext(w, before, waiting.at(player, ahead));
    }
  }

  private static long writeNext(BitWriter w, long before, long now) {
    w.write(now != before);
    if (now != before) {
      writeInput(w, before, now);
    }
    return now;
  }

  /**
   * Reads what {@link #write} wrote: the inputs of a known player's whole window, of others that of
   * the datagram's tick, each followed by those that wait.
   *
   * @param out receives them, player by player
   * @param waiting receives by player how many of them are of later ticks
   */
  public static void read(
      BitReader r,
      RelayedInputs inputs,
      int tick,
      int window,
      PlayerSet known,
      PlayerSet players,
      long[] out,
      byte[] waiting) {
    int at = 0;
    for (int p = players.next(0); p >= 0; p = players.next(p + 1)) {
      if (window == 0 || !known.has(p)) {
        long input = readInput(r, 0);
        out[at++] = input;
        waiting[p] = (byte) r.read(WAITING_BITS);
        at = readNext(r, input, waiting[p], out, at);
        continue;
      }
      boolean changed = r.readBit();
      long before = inputs.at(p, tick - window);
      if (!changed) {
        Arrays.fill(out, at, at + window, before);
        at += window;
        waiting[p] = 0;
        continue;
      }
      at = readNext(r, before, window, out, at);
      waiting[p] = (byte) r.read(WAITING_BITS);
      at = readNext(r, out[at - 1], waiting[p], out, at);
    }
  }

  private static int readNext(BitReader r, long before, int count, long[] out, int at) {
    long input = before;
    for (int i = 0; i < count; i++) {
      input = r.readBit() ? readInput(r, input) : input;
      out[at + i] = input;
    }
    return at + count;
  }

  /** Most inputs {@link #read} gives out. */
  public static int maxInputs() {
    return MAX_PLAYERS * (MAX_WINDOW + WaitingInputs.MOST);
  }

  private static void writeInput(BitWriter w, long before, long input) {
    long changed = before ^ input;
    int buttons = (int) changed & 0xffff;
    w.write(buttons != 0);
    if (buttons != 0) {
      boolean wide = buttons >> COMMON_BUTTONS != 0;
      w.write(wide);
      w.write(buttons, wide ? 16 : COMMON_BUTTONS);
    }
    writeField(w, changed, input, 16, 8);
    writeField(w, changed, input, 24, 8);
    writeField(w, changed, input, 32, 16);
  }

  private static void writeField(BitWriter w, long changed, long input, int from, int bits) {
    boolean differs = (changed >>> from & (1L << bits) - 1) != 0;
    w.write(differs);
    if (differs) {
      w.write((int) (input >>> from), bits);
    }
  }

  private static long readInput(BitReader r, long before) {
    long input = before;
    if (r.readBit()) {
      input ^= r.readBit() ? r.read(16) : r.read(COMMON_BUTTONS);
    }
    input = readField(r, input, 16, 8);
    input = readField(r, input, 24, 8);
    return readField(r, input, 32, 16);
  }

  private static long readField(BitReader r, long input, int from, int bits) {
    if (!r.readBit()) {
      return input;
    }
    long mask = (1L << bits) - 1;
    return input & ~(mask << from) | (r.read(bits) & mask) << from;
  }
}

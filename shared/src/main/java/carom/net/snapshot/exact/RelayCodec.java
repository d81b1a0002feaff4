package carom.net.snapshot.exact;

import carom.net.codec.BitPass;
import carom.net.protocol.PlayerId;
import carom.net.snapshot.frame.FrameRing;
import carom.net.snapshot.frame.FrameState;
import carom.net.snapshot.frame.PlayerSet;
import carom.net.snapshot.frame.WaitingInputs;
import java.util.Arrays;

/**
 * The relay section: inputs of other players. It holds the inputs that the server consumed in all
 * ticks since the baseline, so that a client that holds the baseline knows them all, however many
 * datagrams were lost in between; and those that {@linkplain WaitingInputs wait} for the next
 * ticks. One player's inputs are described once, for writing and reading.
 *
 * <p>One thread; allocates nothing.
 */
final class RelayCodec {
  /** Oldest baseline that inputs are coded against, ticks; else only the newest ones are sent. */
  public static final int MAX_WINDOW = 16;

  /** Most players relayed to one client. */
  public static final int MAX_PLAYERS = 31;

  private static final int COUNT_BITS = 5;
  private static final int WAITING_BITS = 3;
  private static final int PAST_BITS = 4;
  private static final int COMMON_BUTTONS = 5;
  private static final int BUTTONS = 16;

  // Of the player that is being coded: the input at the baseline, then those of each tick of the
  // window, or of those since it is relayed, then those that wait.
  private final long[] inputs = new long[MAX_WINDOW + WaitingInputs.MOST];
  private long baseline;
  private int waiting;

  /** Creates a codec. */
  public RelayCodec() {}

  /**
   * Returns how many ticks of inputs are sent to a client whose baseline has an age in ticks; 0 =
   * the newest only.
   */
  public static int window(int age) {
    return age <= MAX_WINDOW ? age : 0;
  }

  /** Codes which players are relayed; a reader's set may hold anything before. */
  public static void players(BitPass c, PlayerSet players) {
    int count = c.plain(players.size(), COUNT_BITS);
    if (c.isReading()) {
      players.clear();
    }
    for (int i = 0, from = 0; i < count; i++) {
      int player = PlayerId.code(c, players.next(from));
      players.add(player);
      from = player + 1;
    }
  }

  /** Returns whether a relayed player has the same input in all ticks of a window and later. */
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
   * @param window ticks from the baseline to the ring's newest frame, see {@link #window}
   * @param known players whose input at the baseline the client knows
   * @param own has the players
   */
  public void write(BitPass w, FrameRing ring, int window, PlayerSet known, OwnState own) {
    int tick = ring.newest().tick();
    PlayerSet players = own.relayed;
    boolean paused = false;
    for (int p = players.next(0); p >= 0; p = players.next(p + 1)) {
      paused |= window > 0 && known.has(p) && own.relayedSince(p) > tick - window;
    }
    w.flag(paused);
    for (int p = players.next(0); p >= 0; p = players.next(p + 1)) {
      boolean isKnown = window > 0 && known.has(p);
      if (isKnown && paused) {
        isKnown = w.flag(own.relayedSince(p) <= tick - window);
      }
      int ticks = isKnown ? window : past(ring, tick, own.relayedSince(p));
      baseline = isKnown ? inputAt(ring, tick - window, p) : 0;
      for (int i = 0; i < ticks; i++) {
        inputs[i] = inputAt(ring, tick - ticks + 1 + i, p);
      }
      waiting = ring.waiting().count(p);
      for (int i = 0; i < waiting; i++) {
        inputs[ticks + i] = ring.waiting().at(p, i + 1);
      }
      player(w, isKnown, ticks);
    }
  }

  /**
   * Returns how many inputs of a player are told to a client that can't know its last ones: all
   * since it is relayed, as long as these are few. Later the newest is enough, or each datagram to
   * a client far away would tell a whole window.
   */
  private static int past(FrameRing ring, int tick, int since) {
    int ticks = tick - since < MAX_WINDOW ? tick - since + 1 : 1;
    while (ring.at(tick - ticks + 1) == null) {
      ticks--; // before the first frame
    }
    return ticks;
  }

  /**
   * Reads what {@link #write} wrote: the inputs of a known player's whole window, of others those
   * since they are relayed, each followed by those that wait.
   *
   * @param held the inputs that the client knows
   * @param tick the datagram's
   * @param out receives them, player by player; {@link #maxInputs} at most
   * @param pastOf receives by player how many of them are of ticks up to the datagram's
   * @param waitingOf receives by player how many of them are of later ticks
   */
  public void read(
      BitPass r,
      RelayedInputs held,
      int tick,
      int window,
      PlayerSet known,
      PlayerSet players,
      long[] out,
      byte[] pastOf,
      byte[] waitingOf) {
    int at = 0;
    boolean paused = r.flag(false);
    for (int p = players.next(0); p >= 0; p = players.next(p + 1)) {
      boolean isKnown = window > 0 && known.has(p) && !(paused && !r.flag(false));
      baseline = isKnown ? held.at(p, tick - window) : 0;
      int ticks = player(r, isKnown, window);
      System.arraycopy(inputs, 0, out, at, ticks + waiting);
      pastOf[p] = (byte) ticks;
      waitingOf[p] = (byte) waiting;
      at += ticks + waiting;
    }
  }

  /** Returns the most inputs that {@link #read} gives out. */
  public static int maxInputs() {
    return MAX_PLAYERS * (MAX_WINDOW + WaitingInputs.MOST);
  }

  /**
   * Codes one player's inputs.
   *
   * @param isKnown whether both sides know the baseline; else the first input is always sent
   * @param past inputs up to the datagram's tick; a reader finds out how many of an unknown player
   * @return how many these are
   */
  private int player(BitPass c, boolean isKnown, int past) {
    if (isKnown && !c.flag(isChanged(past + waiting))) {
      Arrays.fill(inputs, 0, past, baseline);
      waiting = 0;
      return past;
    }
    int ticks = past;
    int from = 0;
    if (!isKnown) {
      ticks = c.plain(past - 1, PAST_BITS) + 1;
      inputs[from++] = input(c, 0, inputs[0]);
    }
    following(c, from, ticks);
    waiting = c.plain(waiting, WAITING_BITS);
    following(c, ticks, ticks + waiting);
    return ticks;
  }

  private boolean isChanged(int count) {
    for (int i = 0; i < count; i++) {
      if (inputs[i] != baseline) {
        return true;
      }
    }
    return false;
  }

  /** Codes inputs that are mostly the same as the one before. */
  private void following(BitPass c, int from, int to) {
    for (int i = from; i < to; i++) {
      long before = i == 0 ? baseline : inputs[i - 1];
      inputs[i] = c.flag(inputs[i] != before) ? input(c, before, inputs[i]) : before;
    }
  }

  /** Codes an input against another one: the buttons that changed, and each field that did. */
  private static long input(BitPass c, long before, long input) {
    int buttons = (int) (before ^ input) & (1 << BUTTONS) - 1;
    long result = before;
    if (c.flag(buttons != 0)) {
      boolean wide = c.flag(buttons >> COMMON_BUTTONS != 0);
      result ^= c.plain(buttons, wide ? BUTTONS : COMMON_BUTTONS);
    }
    result = field(c, result, input, 16, 8);
    result = field(c, result, input, 24, 8);
    return field(c, result, input, 32, 16);
  }

  private static long field(BitPass c, long before, long input, int from, int bits) {
    long mask = (1L << bits) - 1;
    if (!c.flag(((before ^ input) >>> from & mask) != 0)) {
      return before;
    }
    return before & ~(mask << from) | (c.plain((int) (input >>> from), bits) & mask) << from;
  }
}

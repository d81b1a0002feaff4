package carom.net.snapshot.exact;

import carom.net.codec.BitReader;
import carom.net.codec.RangeDecoder;
import carom.net.protocol.PlayerId;
import carom.net.snapshot.frame.FrameRing;
import carom.net.snapshot.frame.PlayerSet;
import java.util.Arrays;

/**
 * Receives one client's own sections, with relayed inputs and near section, and holds those of the
 * last 64 ticks: later ones are coded against them. One thread; allocates nothing after
 * construction.
 */
public final class OwnInbox {
  private static final int HISTORY = FrameRing.SIZE;
  private static final int NEVER = -1;

  private final OwnState[] owns = new OwnState[HISTORY];
  private final int[] ticks = new int[HISTORY];
  private final OwnState nothing;
  private final RelayCodec relay = new RelayCodec();
  private final NearRowCodec nearRows = new NearRowCodec();
  private final RelayedInputs inputs = new RelayedInputs();
  private OwnState own;

  // A datagram is read into these first and counts only when all of it was good.
  private final OwnState readOwn;
  private final long[] readInputs = new long[RelayCodec.maxInputs()];
  private final byte[] readPast = new byte[PlayerId.MAX + 1];
  private final byte[] readWaiting = new byte[PlayerId.MAX + 1];

  /**
   * Creates an inbox that has received nothing.
   *
   * @param words number of words of the player's fields in each section
   */
  public OwnInbox(int words) {
    nothing = new OwnState(words);
    readOwn = new OwnState(words);
    own = nothing;
    Arrays.fill(ticks, NEVER);
    for (int i = 0; i < HISTORY; i++) {
      owns[i] = new OwnState(words);
    }
  }

  /** Returns whether the inbox holds the baseline of a section: that of a tick, or none. */
  public boolean hasBaseline(int tick, int age) {
    return baseline(tick, age) != null;
  }

  private OwnState baseline(int tick, int age) {
    int wanted = tick - age;
    int at = wanted & (HISTORY - 1);
    if (age == 0) {
      return nothing;
    }
    return wanted >= 0 && ticks[at] == wanted ? owns[at] : null;
  }

  /**
   * Reads a section whose baseline the inbox holds.
   *
   * @param tick the datagram's
   * @param age of the baseline, ticks
   * @return whether the own body makes sense
   */
  public boolean read(BitReader r, int tick, int age) {
    OwnState baseline = baseline(tick, age);
    OwnCodec.code(r, baseline, readOwn);
    if (!readOwn.isSane()) {
      return false;
    }
    PlayerSet players = readOwn.relayed;
    int window = RelayCodec.window(age);
    PlayerSet known = baseline.relayed;
    relay.read(r, inputs, tick, window, known, players, readInputs, readPast, readWaiting);
    NearCodec.code(r, baseline.near, readOwn.near);
    return true;
  }

  /** Reads the rows of the section that was read last, if it has any. */
  public void readRows(RangeDecoder range) {
    if (readOwn.near.updating) {
      nearRows.part(range, readOwn);
    }
  }

  /** Accepts what was read last: the whole datagram was good. */
  public void keep(int tick) {
    int at = tick & (HISTORY - 1);
    owns[at].set(readOwn);
    ticks[at] = tick;
    own = owns[at];
    keepInputs(tick);
  }

  private void keepInputs(int tick) {
    PlayerSet players = readOwn.relayed;
    int at = 0;
    for (int p = players.next(0); p >= 0; p = players.next(p + 1)) {
      for (int i = 1 - readPast[p]; i <= readWaiting[p]; i++) {
        inputs.put(p, tick + i, readInputs[at++]);
      }
    }
  }

  /** Returns the section that was kept last. */
  public OwnState own() {
    return own;
  }

  /** Returns the inputs of other players that were received; always the same object. */
  public RelayedInputs inputs() {
    return inputs;
  }
}

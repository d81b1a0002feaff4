package carom.net.snapshot.exact;

import carom.net.codec.BitWriter;
import carom.net.snapshot.frame.FrameRing;
import carom.net.snapshot.frame.FrameState;
import carom.net.snapshot.frame.PlayerSet;
import carom.net.snapshot.ledger.DatagramLedger;

/**
 * The own sections that were sent to one client, and the newest one that it has acked. The acked
 * one is the baseline of the next. One thread, no allocation in the steady state.
 */
public final class OwnAcks implements DatagramLedger.Section {
  private static final int MASK = FrameRing.SIZE - 1;

  private final FrameRing ring;
  private final DatagramLedger ledger;
  private final RelayCodec relay = new RelayCodec();
  private final OwnState[] sent = new OwnState[FrameRing.SIZE];
  private final OwnState now = new OwnState();
  private final OwnState acked = new OwnState();
  private final OwnState nothing = new OwnState();
  private int ackedTick = -1;

  /**
   * Creates a history without acks.
   *
   * @param ring the room's frames
   * @param ledger of the datagrams that own sections are written into
   */
  public OwnAcks(FrameRing ring, DatagramLedger ledger) {
    this.ring = ring;
    this.ledger = ledger;
    for (int i = 0; i < sent.length; i++) {
      sent[i] = new OwnState();
    }
  }

  @Override
  public void acknowledged(int tick, int key, long bits) {
    if (tick > ackedTick && ring.newest().tick() - tick < FrameRing.SIZE) {
      acked.setBaseline(sent[tick & MASK]);
      ackedTick = tick;
    }
  }

  /**
   * Returns whether the client has already acked everything in an own section and the inputs
   * relayed with it.
   */
  public boolean isKnown(OwnState own, FrameState newest) {
    if (ackedTick < 0
        || !own.sameSection(acked)
        || !own.near.sameAs(acked.near)
        || own.near.updating
        || own.near.rulings > 0) {
      return false;
    }
    int window = newest.tick() - ackedTick;
    PlayerSet relayed = own.relayed;
    if (window > RelayCodec.MAX_WINDOW && relayed.next(0) >= 0) {
      return false;
    }
    for (int p = relayed.next(0); p >= 0; p = relayed.next(p + 1)) {
      boolean paused = own.relayedSince(p) > ackedTick;
      if (paused || !RelayCodec.isUnchanged(ring, newest, window, p)) {
        return false;
      }
    }
    return true;
  }

  /** Copies the section that will be sent with the newest frame. */
  public void begin(OwnState own, int tick) {
    now.set(own);
    sent[tick & MASK].setBaseline(own);
  }

  /** Returns the section that will be sent. */
  public OwnState now() {
    return now;
  }

  /**
   * Returns the age in ticks of the baseline that the section is coded against, or 0 if there is
   * none.
   */
  public int age(int tick) {
    int age = tick - ackedTick;
    return ackedTick >= 0 && age > 0 && age < FrameRing.SIZE ? age : 0;
  }

  /**
   * Writes the own section, the relayed inputs and the near section.
   *
   * @param age see {@link #age}
   * @return bytes of the near section, rounded
   */
  public int write(BitWriter w, int age) {
    ledger.append(this, 0, 0);
    nothing.setWords(now.words());
    OwnState baseline = age > 0 ? acked : nothing;
    OwnCodec.code(w, baseline, now);
    relay.write(w, ring, RelayCodec.window(age), baseline.relayed, now);
    int before = w.bytes();
    NearCodec.code(w, baseline.near, now.near);
    return w.bytes() - before;
  }
}

package carom.net.snapshot;

import carom.net.snapshot.exact.OwnState;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** Good datagrams of a made-up world, for a fuzzer to begin with. */
public final class SnapshotSeeds {
  /** Slots of the world. */
  public static final int SLOTS = 60;

  /** Key of the datagrams' checks. */
  public static final int EPOCH = 0;

  /** Ticks a second of the world. */
  public static final int TICK_RATE = Scene.TICK_RATE;

  private SnapshotSeeds() {}

  /** Returns the datagrams of so many ticks, each acknowledged. */
  public static List<byte[]> datagrams(long seed, int ticks) {
    Scene scene = new Scene(SLOTS, 0, seed);
    SnapshotEncoder encoder = new SnapshotEncoder(scene.ring, EPOCH, TICK_RATE);
    SnapshotDecoder decoder =
        new SnapshotDecoder(
            SLOTS, EPOCH, 0, TICK_RATE, 4, new carom.net.snapshot.table.TableInbox());
    InputFeedback feedback = new InputFeedback();
    feedback.present = true;
    OwnState own = new OwnState(4);
    byte[] buffer = new byte[SnapshotEncoder.MAX_DATAGRAM_BYTES];
    List<byte[]> datagrams = new ArrayList<>();
    for (int i = 0; i < ticks; i++) {
      scene.step();
      Scene.own(scene.tick, own);
      encoder.begin(feedback, own, Integer.MAX_VALUE);
      byte[] bytes = Arrays.copyOf(buffer, encoder.next(buffer));
      datagrams.add(bytes);
      decoder.decode(bytes, 0, bytes.length);
      encoder.receiveAck(decoder.ackSequence(), decoder.ackBits());
    }
    return datagrams;
  }
}

package carom.server.checkpoint;

import carom.fuzz.FuzzTarget;
import carom.net.snapshot.frame.EventRing;
import carom.server.account.AccountValues;
import carom.server.account.PlayerSkill;
import carom.server.account.Stay;
import carom.server.session.Session;
import carom.sim.SimState;
import carom.sim.field.Field;
import carom.sim.field.Schema;
import carom.sim.field.Scope;
import carom.sim.outbox.NextMatch;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.List;
import java.util.zip.CRC32;

/**
 * Files of seats: once as they are, and once under the right head and checksum. A file is refused
 * with a reason, or it reads as the same when it is written again.
 */
public final class SavedRoomTarget implements FuzzTarget {
  private static final int HEAD_BYTES = 20;
  private static final int SUM_AT = 12;

  private final byte[] head = Arrays.copyOf(room(List.of()), HEAD_BYTES);

  @Override
  public void take(byte[] data) {
    read(data);
    read(withHead(data));
  }

  private byte[] withHead(byte[] body) {
    CRC32 sum = new CRC32();
    sum.update(body);
    return ByteBuffer.allocate(HEAD_BYTES + body.length)
        .put(head)
        .putLong(SUM_AT, sum.getValue())
        .put(body)
        .array();
  }

  private static void read(byte[] file) {
    try {
      byte[] written = SavedRoom.parse(file).toBytes();
      if (!Arrays.equals(written, SavedRoom.parse(written).toBytes())) {
        throw new AssertionError("seats changed when they were written and read");
      }
    } catch (SlotException e) {
      FuzzTarget.requirePrintable(e.getMessage());
    }
  }

  private static byte[] room(List<SavedSeat> seats) {
    return new SavedRoom(
            1,
            SimState.LAYOUT,
            "room=1",
            -1,
            4,
            2,
            seats.isEmpty() ? null : NextMatch.level("commons").keepingTeams(),
            1_000,
            42,
            SavedEvents.of(new EventRing(), new Session[1]),
            seats,
            List.of())
        .toBytes();
  }

  @Override
  public List<byte[]> seeds() {
    Schema schema = Schema.of(List.of(Field.count("wins").of(Scope.ACCOUNT)));
    Stay stay = new Stay("4711", 1, AccountValues.NONE.with("duel", schema, new int[] {7}));
    byte[] full =
        room(
            List.of(
                new SavedSeat(
                    3,
                    "Ann",
                    "Ann (2)",
                    "4711",
                    "trio",
                    1_700,
                    -77,
                    true,
                    1_234,
                    5,
                    1,
                    true,
                    8,
                    stay,
                    new int[0]),
                new SavedSeat(
                    4,
                    "Zo\u00eb",
                    "Zo\u00eb",
                    "",
                    "",
                    PlayerSkill.NO_CLAIM,
                    5,
                    false,
                    -1,
                    9,
                    0,
                    false,
                    0,
                    null,
                    new int[0])));
    byte[] empty = room(List.of());
    return List.of(
        full,
        Arrays.copyOfRange(full, HEAD_BYTES, full.length),
        Arrays.copyOfRange(empty, HEAD_BYTES, empty.length));
  }
}

package carom.server.thin.web;

import carom.server.thin.ThinClientMessage;
import carom.server.thin.ThinSnapshot;
import java.util.Arrays;

/**
 * The compact form of snapshots and inputs, see docs/protocol/THIN.md. On a stream, what was sent
 * last is what the client has, so a pose is told as the difference to the last one of the same
 * body. One instance for each link; its lock guards it.
 */
final class BinaryForm {
  /** First byte of a snapshot. */
  static final int SNAPSHOT = 1;

  /** First byte of an input. */
  static final int INPUT = 2;

  private static final int INPUT_BYTES = 6;
  private static final int MAX_VARINT_BYTES = 5;

  // Poses that the client has, by the body's id.
  private int[] x = {};
  private int[] y = {};
  private int[] angle = {};

  /** Creates the form for a client that knows no body. */
  BinaryForm() {}

  /** Writes a snapshot, and notes that the client has it. */
  void write(ThinSnapshot snapshot, Bytes out) {
    out.put(SNAPSHOT).varint(snapshot.tick).varint(snapshot.input + 1);
    out.varint(snapshot.goneCount);
    int before = 0;
    for (int i = 0; i < snapshot.goneCount; i++) {
      out.varint(snapshot.gone[i] - before);
      before = snapshot.gone[i];
    }
    out.varint(snapshot.count);
    before = 0;
    for (int i = 0; i < snapshot.count; i++) {
      int id = snapshot.id[i];
      boolean isNew = snapshot.archetype[i] >= 0;
      reserve(id);
      if (isNew) {
        x[id] = 0;
        y[id] = 0;
        angle[id] = 0;
      }
      out.varint(id - before << 1 | (isNew ? 1 : 0));
      out.signed(snapshot.x[i] - x[id]).signed(snapshot.y[i] - y[id]);
      out.signed(turn(snapshot.angle[i] - angle[id]));
      if (isNew) {
        out.varint(snapshot.archetype[i]).varint(snapshot.owner[i] + 1);
      }
      x[id] = snapshot.x[i];
      y[id] = snapshot.y[i];
      angle[id] = snapshot.angle[i];
      before = id;
    }
  }

  /** Returns the shortest way of a turn, -512..511 steps. */
  private static int turn(int steps) {
    int half = ThinSnapshot.STEPS_PER_TURN / 2;
    return (steps + half & ThinSnapshot.STEPS_PER_TURN - 1) - half;
  }

  private void reserve(int id) {
    if (id >= x.length) {
      int size = Math.max(64, Math.max(id + 1, 2 * x.length));
      x = Arrays.copyOf(x, size);
      y = Arrays.copyOf(y, size);
      angle = Arrays.copyOf(angle, size);
    }
  }

  /**
   * Reads an input.
   *
   * @throws BadMessage if it is none; says why
   */
  static ThinClientMessage.Input readInput(byte[] bytes) throws BadMessage {
    if (bytes.length == 0 || bytes[0] != INPUT) {
      throw new BadMessage("a binary message begins with " + INPUT + ", and is an input");
    }
    int at = 1;
    int[] head = new int[2];
    for (int i = 0; i < head.length; i++) {
      int read = 0;
      int next;
      do {
        if (at == bytes.length || read == MAX_VARINT_BYTES) {
          throw new BadMessage("binary input: " + (i == 0 ? "count" : "seen") + " is no varint");
        }
        next = bytes[at++];
        head[i] |= (next & 0x7f) << 7 * read++;
      } while (next < 0);
    }
    int left = bytes.length - at;
    int inputs = left / INPUT_BYTES;
    if (left % INPUT_BYTES != 0 || inputs < 1 || inputs > ThinClientMessage.MAX_INPUTS) {
      throw new BadMessage(
          "binary input: bytes="
              + left
              + " after count and seen must be 6, 12 or 18, as an input has six");
    }
    long[] packed = new long[inputs];
    for (int i = 0; i < inputs; i++) {
      for (int k = 0; k < INPUT_BYTES; k++) {
        packed[i] |= (bytes[at++] & 0xffL) << 8 * k;
      }
    }
    return new ThinClientMessage.Input(head[0], head[1] - 1, packed);
  }
}

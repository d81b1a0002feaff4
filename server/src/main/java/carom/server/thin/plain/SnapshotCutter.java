package carom.server.thin.plain;

import carom.server.thin.ThinSnapshot;
import java.util.Arrays;

/**
 * Encodes snapshots as one or more messages of {@code carom.plain.Snapshot}, each of a bounded size
 * and decodable alone. One thread.
 */
final class SnapshotCutter {
  private static final float METRES = 1f / ThinSnapshot.STEPS_PER_METRE;
  private static final float RADIANS = (float) (2 * Math.PI / ThinSnapshot.STEPS_PER_TURN);

  /** Bytes around the lists: class number, two lengths, and five numbers. */
  private static final int HEAD_BYTES = 1 + 3 + 3 + 5 + 5 + 3 + 3 + 5;

  private static final int MAX_ID_BYTES = 3;
  private static final int REALS_BYTES = 12;

  private ThinSnapshot snapshot;
  private int parts;
  private int[] bodyEnds = new int[4];
  private int[] goneEnds = new int[4];

  /**
   * Takes a snapshot, whose parts are then to be {@linkplain #write written}.
   *
   * @param maxBytes of each part
   * @return the number of parts, at least 1
   */
  int cut(ThinSnapshot newSnapshot, int maxBytes) {
    snapshot = newSnapshot;
    parts = 0;
    int left = maxBytes - HEAD_BYTES;
    for (int i = 0; i < snapshot.count; i++) {
      int size = sizeOfBody(i);
      if (size > left) {
        endPart(i, 0);
        left = maxBytes - HEAD_BYTES;
      }
      left -= size;
    }
    for (int i = 0; i < snapshot.goneCount; i++) {
      if (MAX_ID_BYTES > left) {
        endPart(snapshot.count, i);
        left = maxBytes - HEAD_BYTES;
      }
      left -= MAX_ID_BYTES;
    }
    endPart(snapshot.count, snapshot.goneCount);
    return parts;
  }

  private void endPart(int bodyEnd, int goneEnd) {
    if (parts == bodyEnds.length) {
      bodyEnds = Arrays.copyOf(bodyEnds, 2 * parts);
      goneEnds = Arrays.copyOf(goneEnds, 2 * parts);
    }
    bodyEnds[parts] = bodyEnd;
    goneEnds[parts] = goneEnd;
    parts++;
  }

  private int sizeOfBody(int i) {
    return 1
        + REALS_BYTES
        + KryoOutput.sizeOf(snapshot.archetype[i])
        + KryoOutput.sizeOf(snapshot.id[i])
        + KryoOutput.sizeOf(snapshot.owner[i]);
  }

  /** Appends a part of a snapshot of the match with this number. */
  void write(KryoOutput out, int match, int part) {
    int firstBody = part == 0 ? 0 : bodyEnds[part - 1];
    int firstGone = part == 0 ? 0 : goneEnds[part - 1];
    out.count(PlainIds.SNAPSHOT);
    out.count(bodyEnds[part] - firstBody + 1);
    for (int i = firstBody; i < bodyEnds[part]; i++) {
      out.flag(true); // it isn't null
      out.real(snapshot.angle[i] * RADIANS);
      out.whole(snapshot.archetype[i]);
      out.whole(snapshot.id[i]);
      out.whole(snapshot.owner[i]);
      out.real(snapshot.x[i] * METRES);
      out.real(snapshot.y[i] * METRES);
    }
    out.count(goneEnds[part] - firstGone + 1);
    for (int i = firstGone; i < goneEnds[part]; i++) {
      out.whole(snapshot.gone[i]);
    }
    out.whole(snapshot.input);
    out.whole(match);
    out.whole(part);
    out.whole(parts);
    out.whole(snapshot.tick);
  }
}

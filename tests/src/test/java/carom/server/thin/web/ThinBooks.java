package carom.server.thin.web;

import carom.text.Json;
import java.nio.ByteBuffer;
import java.util.Map;
import java.util.TreeMap;

/** What a client knows that follows docs/protocol/THIN.md: bodies by id, of either form. */
final class ThinBooks {
  /** A body as it is told, in steps. */
  record Body(int x, int y, int angle, int archetype, int owner) {}

  final Map<Integer, Body> bodies = new TreeMap<>();
  int tick = -1;
  int input = -1;

  /** Takes a snapshot over that is told as JSON. */
  void text(Json snapshot) {
    tick = (int) snapshot.fields.get("tick").number;
    input = (int) snapshot.fields.get("input").number;
    for (Json told : snapshot.fields.get("bodies").items) {
      int id = (int) told.items.get(0).number;
      Body before = bodies.get(id);
      boolean isNew = told.items.size() == 6;
      bodies.put(
          id,
          new Body(
              (int) Math.round(told.items.get(1).number * 512),
              (int) Math.round(told.items.get(2).number * 512),
              (int) Math.round(told.items.get(3).number * 1_024 / (2 * Math.PI)) & 1_023,
              isNew ? (int) told.items.get(4).number : before.archetype,
              isNew ? (int) told.items.get(5).number : before.owner));
    }
    snapshot.fields.get("gone").items.forEach(id -> bodies.remove((int) id.number));
  }

  /** Takes a snapshot over that is told as bytes. */
  void bytes(ByteBuffer in) {
    if (in.get() != 1) {
      throw new AssertionError("no snapshot");
    }
    tick = varint(in);
    input = varint(in) - 1;
    int id = 0;
    for (int left = varint(in); left > 0; left--) {
      id += varint(in);
      bodies.remove(id);
    }
    id = 0;
    for (int left = varint(in); left > 0; left--) {
      int head = varint(in);
      boolean isNew = (head & 1) != 0;
      id += head >>> 1;
      Body before = isNew ? new Body(0, 0, 0, -1, -1) : bodies.get(id);
      int x = before.x + signed(in);
      int y = before.y + signed(in);
      int angle = before.angle + signed(in) & 1_023;
      int archetype = isNew ? varint(in) : before.archetype;
      bodies.put(id, new Body(x, y, angle, archetype, isNew ? varint(in) - 1 : before.owner));
    }
    if (in.hasRemaining()) {
      throw new AssertionError("bytes=" + in.remaining() + " are left over");
    }
  }

  private static int varint(ByteBuffer in) {
    int value = 0;
    for (int shift = 0; ; shift += 7) {
      int next = in.get();
      value |= (next & 0x7f) << shift;
      if (next >= 0) {
        return value;
      }
    }
  }

  private static int signed(ByteBuffer in) {
    int value = varint(in);
    return value >>> 1 ^ -(value & 1);
  }
}

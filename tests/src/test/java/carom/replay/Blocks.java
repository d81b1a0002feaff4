package carom.replay;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** A recording in memory, which tests can tamper with and write to a file. */
final class Blocks implements BlockSink {
  /** One block, before compression. */
  static final class Raw {
    private final Block type;
    private final byte[] bytes;

    Raw(Block type, byte[] bytes) {
      this.type = type;
      this.bytes = bytes;
    }

    Block type() {
      return type;
    }

    byte[] bytes() {
      return bytes;
    }
  }

  final List<Raw> blocks = new ArrayList<>();

  /** Blocks that are still taken. */
  int capacity = Integer.MAX_VALUE;

  @Override
  public boolean take(Block type, byte[] bytes, int length) {
    if (blocks.size() >= capacity) {
      return false;
    }
    blocks.add(new Raw(type, Arrays.copyOf(bytes, length)));
    return true;
  }

  Path write(Path file) throws IOException {
    try (BlockWriter writer = new BlockWriter(Files.newOutputStream(file))) {
      for (Raw block : blocks) {
        writer.write(block.type(), block.bytes(), block.bytes().length);
      }
    }
    return file;
  }

  /**
   * A copy in which one player's input has other bits, from a tick on.
   *
   * @param flip bits that change
   */
  Blocks withInput(int tick, int player, long flip) throws RecordingException {
    Blocks copy = new Blocks();
    int[] at = {0};
    for (Raw block : blocks) {
      copy.blocks.add(
          block.type() == Block.TICKS
              ? new Raw(Block.TICKS, tamper(block.bytes(), at, tick, player, flip))
              : block);
    }
    return copy;
  }

  private static byte[] tamper(byte[] bytes, int[] at, int tick, int player, long flip)
      throws RecordingException {
    ByteSource in = new ByteSource();
    in.set(bytes, bytes.length);
    ByteSink out = new ByteSink();
    while (!in.isEmpty()) {
      int tag = in.u8();
      out.u8(tag);
      switch (tag) {
        case Block.JOIN:
          out.u8(in.u8());
          out.text(in.text("name", 256));
          break;
        case Block.LEAVE:
          out.u8(in.u8());
          break;
        case Block.TICK:
          at[0]++;
          copyInputs(in, out, at[0] == tick ? player : -1, flip);
          break;
        default:
          out.i64(in.i64());
          for (int i = 0; i < 2 + Fingerprint.FIELDS; i++) {
            out.varint(in.varint());
          }
      }
    }
    return Arrays.copyOf(out.array(), out.length());
  }

  private static void copyInputs(ByteSource in, ByteSink out, int player, long flip)
      throws RecordingException {
    int count = in.varint("count", 0, 256);
    int[] ids = new int[count + 1];
    long[] changes = new long[count + 1];
    long[] delays = new long[count + 1];
    boolean found = player < 0;
    for (int i = 0; i < count; i++) {
      ids[i] = in.u8();
      changes[i] = in.varint();
      delays[i] = in.varint();
      if (ids[i] == player) {
        changes[i] ^= flip;
        found = true;
      }
    }
    if (!found) {
      ids[count] = player;
      changes[count] = flip;
      count++;
    }
    out.varint(count);
    for (int i = 0; i < count; i++) {
      out.u8(ids[i]);
      out.varint(changes[i]);
      out.varint(delays[i]);
    }
  }
}

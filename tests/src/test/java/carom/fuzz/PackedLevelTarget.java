package carom.fuzz;

import carom.net.protocol.PackedLevel;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;

/** A packed level as a server sends it: three bytes of its size, then the packed file. */
final class PackedLevelTarget implements FuzzTarget {
  private static final int MOST = 1 << 16; // so that a run fits into its time

  @Override
  public void take(byte[] data) {
    if (data.length < 4) {
      return;
    }
    int size = ByteBuffer.wrap(data).getInt() % MOST;
    byte[] level = PackedLevel.unpack(Arrays.copyOfRange(data, 4, data.length), size);
    if (level != null) {
      byte[] again = PackedLevel.unpack(PackedLevel.pack(level), size);
      if (!Arrays.equals(level, again)) {
        throw new AssertionError("a level of size=" + size + " changed when it was packed");
      }
    }
  }

  @Override
  public List<byte[]> seeds() {
    byte[] level = "{\"name\": \"a level\"}".repeat(9).getBytes(StandardCharsets.UTF_8);
    byte[] packed = PackedLevel.pack(level);
    return List.of(ByteBuffer.allocate(4 + packed.length).putInt(level.length).put(packed).array());
  }
}

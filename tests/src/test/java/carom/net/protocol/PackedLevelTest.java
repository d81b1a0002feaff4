package carom.net.protocol;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;

class PackedLevelTest {
  private static final long SEED = 11;

  @Test
  void anyFileSurvives() {
    Random random = new Random(SEED);
    for (int size : new int[] {0, 1, 2, 1_023, 1_024, 1_025, 100_000}) {
      byte[] file = new byte[size];
      random.nextBytes(file);
      assertArrayEquals(file, PackedLevel.unpack(PackedLevel.pack(file), size), "size=" + size);
      Arrays.fill(file, (byte) ' ');
      byte[] packed = PackedLevel.pack(file);
      assertArrayEquals(file, PackedLevel.unpack(packed, size), "size=" + size);
      assertTrue(packed.length < 200, "packed=" + packed.length);
    }
  }

  @Test
  void whatIsNotExactlyOneFileOfThatSizeIsRefused() {
    byte[] file =
        "{\"a\": 1, \"b\": [2, 3, 4, 5, 6, 7, 8]}".repeat(50).getBytes(StandardCharsets.UTF_8);
    byte[] packed = PackedLevel.pack(file);
    assertNull(PackedLevel.unpack(packed, file.length - 1), "longer than said");
    assertNull(PackedLevel.unpack(packed, file.length + 1), "shorter than said");
    assertNull(PackedLevel.unpack(packed, -1));
    assertNull(PackedLevel.unpack(packed, ProtocolLimits.MAX_LEVEL_BYTES + 1));
    assertNull(PackedLevel.unpack(new byte[0], file.length));
    assertNull(PackedLevel.unpack(Arrays.copyOf(packed, packed.length + 1), file.length));
    for (int cut = 0; cut < packed.length; cut++) {
      assertNull(PackedLevel.unpack(Arrays.copyOf(packed, cut), file.length), "cut=" + cut);
    }
    Random random = new Random(SEED);
    for (int i = 0; i < 5_000; i++) {
      byte[] bad = packed.clone();
      for (int n = 1 + random.nextInt(3); n > 0; n--) {
        bad[random.nextInt(bad.length)] ^= (byte) (1 + random.nextInt(255));
      }
      byte[] read = PackedLevel.unpack(bad, file.length);
      assertTrue(read == null || Arrays.equals(read, file), "seed=" + SEED + " i=" + i);
    }
  }
}

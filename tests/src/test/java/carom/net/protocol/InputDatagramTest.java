package carom.net.protocol;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;

class InputDatagramTest {

  private static final long SEED = 77;

  private static void fill(InputDatagram d, Random random) {
    d.key = random.nextInt();
    d.sequence = random.nextInt(65_536);
    d.hasAck = random.nextInt(4) != 0;
    d.ackSequence = d.hasAck ? random.nextInt(65_536) : 0;
    d.ackBits = d.hasAck ? random.nextLong() : 0;
    d.count = random.nextInt(Limits.MAX_INPUTS + 1);
    d.newestTick = d.count > 0 ? random.nextInt() : 0;
    d.viewDelay = random.nextInt(InputDatagram.MAX_VIEW_DELAY + 1);
    for (int i = 0; i < d.count; i++) {
      boolean same = i > 0 && random.nextBoolean();
      d.inputs[i] = same ? d.inputs[i - 1] : random.nextLong() & 0xffff_ffff_ffffL;
    }
  }

  @Test
  void datagramsComeBackAndAreBounded() {
    Random random = new Random(SEED);
    InputDatagram out = new InputDatagram();
    InputDatagram in = new InputDatagram();
    byte[] bytes = new byte[InputDatagram.MAX_BYTES + 2];
    for (int i = 0; i < 20_000; i++) {
      fill(out, random);
      int length = out.encode(bytes, 2);
      assertTrue(length <= InputDatagram.MAX_BYTES);
      assertTrue(in.decode(bytes, 2, length), "seed=" + SEED + " i=" + i);
      assertEquals(out.key, in.key);
      assertEquals(out.key, InputDatagram.peekKey(bytes, 2, length));
      assertEquals(out.sequence, in.sequence);
      assertEquals(out.hasAck, in.hasAck);
      assertEquals(out.ackSequence, in.ackSequence);
      assertEquals(out.ackBits, in.ackBits);
      assertEquals(out.newestTick, in.newestTick);
      assertEquals(out.count, in.count);
      assertEquals(out.count > 0 ? out.viewDelay : 0, in.viewDelay);
      assertArrayEquals(Arrays.copyOf(out.inputs, out.count), Arrays.copyOf(in.inputs, in.count));
    }
  }

  @Test
  void sixteenEqualInputsCostHardlyMoreThanOne() {
    InputDatagram d = new InputDatagram();
    byte[] bytes = new byte[InputDatagram.MAX_BYTES];
    Arrays.fill(d.inputs, 0x123456789abcL);
    d.count = 1;
    int one = d.encode(bytes, 0);
    d.count = 16;
    assertTrue(d.encode(bytes, 0) <= one + 2);
  }

  @Test
  void cutLengthenedAndRandomBytesAreRefusedQuietly() {
    Random random = new Random(SEED);
    InputDatagram d = new InputDatagram();
    InputDatagram in = new InputDatagram();
    byte[] bytes = new byte[InputDatagram.MAX_BYTES];
    for (int i = 0; i < 500; i++) {
      fill(d, random);
      int length = d.encode(bytes, 0);
      for (int cut = 0; cut < length; cut++) {
        assertFalse(in.decode(bytes, 0, cut), "seed=" + SEED + " cut=" + cut);
      }
      if (length < bytes.length) {
        bytes[length] = 0;
        assertFalse(in.decode(bytes, 0, length + 1), "one byte too many");
      }
    }
    for (int i = 0; i < 100_000; i++) {
      byte[] noise = new byte[random.nextInt(140)];
      random.nextBytes(noise);
      if (in.decode(noise, 0, noise.length)) {
        assertTrue(in.count >= 0 && in.count <= Limits.MAX_INPUTS);
      }
    }
    assertEquals(0, InputDatagram.peekKey(bytes, 0, 3));
    d.viewDelay = InputDatagram.MAX_VIEW_DELAY + 1;
    d.count = 1;
    assertThrows(IllegalArgumentException.class, () -> d.encode(bytes, 0));
    d.viewDelay = 0;
    d.count = 17;
    assertThrows(IllegalArgumentException.class, () -> d.encode(bytes, 0));
  }
}

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
    d.epoch = random.nextInt(8);
    d.sequence = random.nextInt(65_536);
    d.hasAck = random.nextInt(4) != 0;
    d.ackSequence = d.hasAck ? random.nextInt(65_536) : 0;
    d.ackBits = d.hasAck ? random.nextLong() : 0;
    d.count = random.nextInt(ProtocolLimits.MAX_INPUTS + 1);
    d.newestTick = d.count > 0 ? random.nextInt() : 0;
    d.viewDelay = random.nextInt(InputDatagram.MAX_VIEW_DELAY + 1);
    d.holdTicks = random.nextInt(InputDatagram.MAX_HOLD_TICKS + 1);
    d.near = random.nextInt(InputDatagram.NEAR_ALL + 1);
    d.disagrees = random.nextBoolean();
    d.disagreedTick = random.nextInt(65_536);
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
      assertMeansSame(out, in, "seed=" + SEED + " i=" + i);
    }
  }

  /** What counts: a comparison only of what is near, delays only with inputs. */
  private static void assertMeansSame(InputDatagram out, InputDatagram in, String which) {
    boolean disagrees = out.near != InputDatagram.NEAR_NONE && out.disagrees;
    assertEquals(out.epoch, in.epoch, which);
    assertEquals(out.sequence, in.sequence, which);
    assertEquals(out.hasAck, in.hasAck, which);
    assertEquals(out.ackSequence, in.ackSequence, which);
    assertEquals(out.ackBits, in.ackBits, which);
    assertEquals(out.near, in.near, which);
    assertEquals(disagrees, in.disagrees, which);
    assertEquals(disagrees ? out.disagreedTick : 0, in.disagreedTick, which);
    assertEquals(out.newestTick, in.newestTick, which);
    assertEquals(out.count, in.count, which);
    assertEquals(out.count > 0 ? out.viewDelay : 0, in.viewDelay, which);
    assertEquals(out.count > 0 ? out.holdTicks : 0, in.holdTicks, which);
    assertArrayEquals(
        Arrays.copyOf(out.inputs, out.count), Arrays.copyOf(in.inputs, in.count), which);
  }

  @Test
  void flippedBitsAreRefusedOrMeanWhatTheySay() {
    long seed = new Random().nextLong();
    Random random = new Random(seed);
    InputDatagram d = new InputDatagram();
    InputDatagram in = new InputDatagram();
    InputDatagram again = new InputDatagram();
    byte[] bytes = new byte[InputDatagram.MAX_BYTES];
    int accepted = 0;
    for (int i = 0; i < 50_000; i++) {
      String which = "seed=" + seed + " i=" + i;
      fill(d, random);
      int length = d.encode(bytes, 0);
      for (int flips = 1 + random.nextInt(3); flips > 0; flips--) {
        bytes[random.nextInt(length)] ^= (byte) (1 << random.nextInt(8));
      }
      if (!in.decode(bytes, 0, length)) {
        continue;
      }
      accepted++;
      assertTrue(in.count >= 0 && in.count <= ProtocolLimits.MAX_INPUTS, which);
      assertTrue(in.viewDelay >= 0 && in.viewDelay <= InputDatagram.MAX_VIEW_DELAY, which);
      assertTrue(in.holdTicks >= 0 && in.holdTicks <= InputDatagram.MAX_HOLD_TICKS, which);
      assertTrue(in.near >= 0 && in.near <= InputDatagram.NEAR_ALL, which);
      assertTrue(in.disagreedTick >= 0 && in.disagreedTick < 65_536, which);
      assertTrue(again.decode(bytes, 0, in.encode(bytes, 0)), which);
      assertMeansSame(in, again, which);
    }
    assertTrue(accepted > 1_000, "seed=" + seed + " accepted=" + accepted);
  }

  @Test
  void aRequestForAPredictedSetThatDoesNotExistIsRefused() {
    InputDatagram d = new InputDatagram();
    byte[] bytes = new byte[InputDatagram.MAX_BYTES];
    for (int near = 0; near <= InputDatagram.NEAR_ALL; near++) {
      d.near = near;
      assertTrue(d.decode(bytes, 0, d.encode(bytes, 0)), "near=" + near);
      assertEquals(near, d.near);
    }
    int length = d.encode(bytes, 0); // 4 bits of mark, 16 of sequence, none of acks, then near = 2
    bytes[2] |= 0b10_0000;
    assertFalse(d.decode(bytes, 0, length));
    d.near = InputDatagram.NEAR_ALL + 1;
    assertThrows(IllegalArgumentException.class, () -> d.encode(bytes, 0));
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
        assertTrue(in.count >= 0 && in.count <= ProtocolLimits.MAX_INPUTS);
      }
    }
    d.epoch = 8;
    assertThrows(IllegalArgumentException.class, () -> d.encode(bytes, 0));
    d.epoch = 0;
    d.viewDelay = InputDatagram.MAX_VIEW_DELAY + 1;
    d.count = 1;
    assertThrows(IllegalArgumentException.class, () -> d.encode(bytes, 0));
    d.viewDelay = 0;
    d.holdTicks = InputDatagram.MAX_HOLD_TICKS + 1;
    assertThrows(IllegalArgumentException.class, () -> d.encode(bytes, 0));
    d.holdTicks = 0;
    d.count = 17;
    assertThrows(IllegalArgumentException.class, () -> d.encode(bytes, 0));
  }
}

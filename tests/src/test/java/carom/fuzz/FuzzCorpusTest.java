package carom.fuzz;

import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Whatever a fuzzer found is read again: good inputs and the corpus, and then a fresh handful of
 * them, cut and damaged.
 */
final class FuzzCorpusTest {
  private static final int MOST_DAMAGED = 1_000;
  private static final long MOST_NS = 1_000_000_000L;

  static List<String> targets() {
    return FuzzTargets.names();
  }

  @ParameterizedTest
  @MethodSource("targets")
  void whatAFuzzerFoundIsStillStood(String name) throws Exception {
    FuzzTarget target = FuzzTargets.create(name);
    List<byte[]> inputs = FuzzTargets.inputs(name);
    assertTrue(inputs.size() >= target.seeds().size() && !inputs.isEmpty(), "no inputs of " + name);
    for (byte[] input : inputs) {
      take(target, name, input);
    }
  }

  @ParameterizedTest
  @MethodSource("targets")
  void damagedInputsAreStood(String name) throws Exception {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    System.out.println("fuzz target=" + name + " seed=" + seed);
    Random random = new Random(seed);
    FuzzTarget target = FuzzTargets.create(name);
    List<byte[]> inputs = FuzzTargets.inputs(name);
    long startNs = System.nanoTime();
    for (int i = 0; i < MOST_DAMAGED && System.nanoTime() - startNs < MOST_NS; i++) {
      take(target, name + ", seed=" + seed, damaged(inputs, random));
    }
  }

  /** Returns an input with some bytes changed, cut out, or taken from another input. */
  private static byte[] damaged(List<byte[]> inputs, Random random) {
    byte[] bytes = inputs.get(random.nextInt(inputs.size())).clone();
    for (int changes = 1 + random.nextInt(4); changes > 0 && bytes.length > 0; changes--) {
      int at = random.nextInt(bytes.length);
      int end = Math.min(bytes.length, at + 1 + random.nextInt(16));
      switch (random.nextInt(4)) {
        case 0 -> bytes[at] ^= (byte) (1 << random.nextInt(8));
        case 1 -> bytes[at] = (byte) (random.nextBoolean() ? -1 : random.nextInt(256));
        case 2 -> bytes = joined(Arrays.copyOf(bytes, at), bytes, end);
        default -> {
          byte[] other = inputs.get(random.nextInt(inputs.size()));
          bytes = joined(Arrays.copyOf(bytes, at), other, Math.min(other.length, at));
        }
      }
    }
    return bytes;
  }

  private static byte[] joined(byte[] head, byte[] tail, int from) {
    byte[] all = Arrays.copyOf(head, head.length + tail.length - from);
    System.arraycopy(tail, from, all, head.length, tail.length - from);
    return all;
  }

  private static void take(FuzzTarget target, String what, byte[] input) {
    try {
      target.take(input.clone());
    } catch (Exception | AssertionError | StackOverflowError | OutOfMemoryError e) {
      fail(what + " failed at " + HexFormat.of().formatHex(input), e);
    }
  }
}

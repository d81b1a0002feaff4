package carom.fuzz;

import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.util.HexFormat;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Whatever a fuzzer found is read again: good inputs, the corpus, and each cut and damaged. */
final class FuzzCorpusTest {
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
      try {
        target.take(input.clone());
      } catch (Exception | AssertionError | StackOverflowError | OutOfMemoryError e) {
        fail(name + " failed at " + HexFormat.of().formatHex(input), e);
      }
    }
  }
}

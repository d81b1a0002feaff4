package carom.fuzz;

import java.util.List;

/**
 * Reads bytes that somebody else wrote, and checks what must hold whatever they are. A target fails
 * by throwing. It has no state between two inputs, so that an input alone reproduces a failure.
 */
interface FuzzTarget {
  /** Reads the bytes. Anything thrown is a finding. */
  void take(byte[] data) throws Exception;

  /** Returns good inputs to begin with, which a fuzzer wouldn't find soon. */
  List<byte[]> seeds() throws Exception;
}

package carom.fuzz;

import carom.text.Texts;
import java.util.List;

/**
 * Reads bytes that somebody else wrote, and checks what must hold whatever they are. A target fails
 * by throwing. It has no state between two inputs, so that an input alone reproduces a failure.
 */
public interface FuzzTarget {
  /** Reads the bytes. Anything thrown is a finding. */
  void take(byte[] data) throws Exception;

  /** Returns good inputs to begin with, which a fuzzer wouldn't find soon. */
  List<byte[]> seeds() throws Exception;

  /** Fails if a text has characters that a terminal would obey or nobody can see. */
  static void requirePrintable(String text) {
    if (!Texts.clean(text).equals(text)) {
      throw new AssertionError("a text for people has hidden characters: " + text);
    }
  }
}

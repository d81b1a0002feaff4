package carom.fuzz;

/** Jazzer's way in: it calls the method of this name for each input. */
public final class FuzzEntry {
  /** Property with the name of the target. */
  static final String TARGET = "carom.fuzz.target";

  private static final FuzzTarget CHOSEN = FuzzTargets.create(System.getProperty(TARGET));

  private FuzzEntry() {}

  /** Gives an input to the target that the property names. */
  public static void fuzzerTestOneInput(byte[] data) throws Exception {
    CHOSEN.take(data);
  }
}

package carom.net.kryo;

import com.esotericsoftware.minlog.Log;

/** Process-wide settings of Kryo and KryoNet, made before their first class loads. */
public final class Setup {

  static {
    // Kryo's use of sun.misc.Unsafe makes newer JDKs print warnings, and Carom doesn't need it.
    if (System.getProperty("kryo.unsafe") == null) {
      System.setProperty("kryo.unsafe", "false");
    }
    // KryoNet logs a stack trace for each bad datagram: 900 bytes of log for an attack of 4 bytes.
    // The counters keep what matters.
    Log.set(Log.LEVEL_NONE);
  }

  private Setup() {}

  /**
   * Runs the settings. The static initialiser of each class that touches Kryo or KryoNet first
   * calls it.
   */
  public static void ensure() {
    // the static initialiser does it
  }
}

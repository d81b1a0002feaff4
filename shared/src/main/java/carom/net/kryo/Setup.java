package carom.net.kryo;

import com.esotericsoftware.minlog.Log;

/** Process-wide switches of Kryo and KryoNet, set before their first class loads. */
final class Setup {

  static {
    // Kryo's use of sun.misc.Unsafe makes newer JDKs print warnings, and we don't need it.
    if (System.getProperty("kryo.unsafe") == null) {
      System.setProperty("kryo.unsafe", "false");
    }
    // KryoNet logs a stack trace for each bad datagram: 900 bytes of log for 4 bytes of attack.
    // What matters is in the counters.
    Log.set(Log.LEVEL_NONE);
  }

  private Setup() {}

  /** Call from the static initialiser of each class that touches Kryo or KryoNet first. */
  static void ensure() {
    // the static initialiser did it
  }
}

package carom.client.look;

import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.InputStream;

/** Reads files that lie beside a game's view. */
public final class LookFiles {
  private LookFiles() {}

  /**
   * Returns the bytes of a file.
   *
   * @param home the view's class; null for no view, which has no files
   * @param file its name, as {@link Class#getResource} finds it
   * @param most its largest size, bytes
   * @throws IOException if it isn't there, is larger, or can't be read
   */
  public static byte[] read(Class<?> home, String file, int most) throws IOException {
    try (InputStream in = home == null ? null : home.getResourceAsStream(file)) {
      if (in == null) {
        throw new FileNotFoundException(file + " isn't in the game's jar");
      }
      byte[] bytes = in.readNBytes(most + 1);
      if (bytes.length > most) {
        throw new IOException(file + " is larger than " + most + " bytes");
      }
      return bytes;
    }
  }
}

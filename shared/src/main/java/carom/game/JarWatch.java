package carom.game;

import java.io.IOException;

/**
 * Takes the jars of {@link GameJars} anew when they have changed: for {@code --dev}. It acts when
 * they were the same at two looks, so that it reads none that is half written. One thread.
 */
public final class JarWatch {
  private String seen = "";
  private String refused = "";

  /** Creates a watch that takes what has changed since the jars were taken last. */
  public JarWatch() {}

  /**
   * Looks at the jars; a few times a second.
   *
   * @return whether they are new, so that games, views and brains made from now on are
   * @throws IOException if one can't be read; all stays as it is, and it isn't tried again before
   *     they change
   */
  public boolean look() throws IOException {
    try {
      String before = seen;
      seen = GameJars.state();
      return seen.equals(before) && !seen.equals(refused) && GameJars.refresh();
    } catch (IOException e) { // or one goes while it is looked at
      refused = seen;
      throw e;
    }
  }
}

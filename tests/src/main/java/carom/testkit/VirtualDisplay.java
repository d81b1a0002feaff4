package carom.testkit;

import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/**
 * A virtual screen: an Xvfb process on a display number that it chooses. Needs Xvfb; call {@link
 * #available} first.
 */
public final class VirtualDisplay implements AutoCloseable {
  private final Process xvfb;
  private final String name;

  private VirtualDisplay(Process xvfb, String name) {
    this.xvfb = xvfb;
    this.name = name;
  }

  /** Returns whether this machine has Xvfb on its PATH. */
  public static boolean available() {
    String path = System.getenv().getOrDefault("PATH", "");
    return Stream.of(path.split(File.pathSeparator))
        .anyMatch(folder -> new File(folder, "Xvfb").canExecute());
  }

  /**
   * Starts a display of 1280 x 720 at 24 bits.
   *
   * @throws IOException when Xvfb can't be started or announces no display
   */
  public static VirtualDisplay open() throws IOException {
    return open(1_280, 720);
  }

  /**
   * Starts a display of another size, pixels.
   *
   * @throws IOException as {@link #open()}
   */
  public static VirtualDisplay open(int width, int height) throws IOException {
    String screen = width + "x" + height + "x24";
    Process xvfb =
        new ProcessBuilder("Xvfb", "-displayfd", "1", "-screen", "0", screen, "-nolisten", "tcp")
            .redirectError(ProcessBuilder.Redirect.DISCARD)
            .start();
    BufferedReader out =
        new BufferedReader(new InputStreamReader(xvfb.getInputStream(), StandardCharsets.UTF_8));
    String number = out.readLine();
    if (number == null) {
      throw new IOException("Xvfb ended with exit code " + xvfb.onExit().join().exitValue());
    }
    return new VirtualDisplay(xvfb, ":" + number.strip());
  }

  /** Returns the value for the environment variable DISPLAY. */
  public String name() {
    return name;
  }

  @Override
  public void close() {
    xvfb.destroy();
    try {
      if (!xvfb.waitFor(5, TimeUnit.SECONDS)) {
        xvfb.destroyForcibly();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      xvfb.destroyForcibly();
    }
  }
}

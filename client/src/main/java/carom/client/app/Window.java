package carom.client.app;

/**
 * A window to play in. This package knows no toolkit: {@link java.util.ServiceLoader} finds the
 * implementation that {@code META-INF/services} names.
 */
public interface Window {
  /**
   * Opens the window and blocks until it is closed.
   *
   * @param options from the command line
   * @return exit code of the program: 0 = closed by the player
   */
  int launch(ClientOptions options);

  /**
   * Draws a clip of a recording to files, and blocks until it is done.
   *
   * @return exit code of the program: 0 = done
   */
  int render(RenderJob job);
}

package carom.client.app;

/**
 * A window a client can be played in. {@code carom.client} knows no toolkit: the implementation is
 * found by {@link java.util.ServiceLoader} and named in {@code META-INF/services}.
 */
public interface Window {
  /**
   * Opens the window and blocks until it is closed.
   *
   * @param options what the player asked for on the command line
   * @return exit code of the program: 0 = closed by the player
   */
  int launch(ClientOptions options);
}

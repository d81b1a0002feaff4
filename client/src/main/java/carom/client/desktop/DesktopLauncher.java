package carom.client.desktop;

import carom.client.ClientOptions;
import carom.client.Window;

/** Opens the client's window; found by {@code ServiceLoader} as {@link Window}. */
public final class DesktopLauncher implements Window {
  /** Called by the service loader. */
  public DesktopLauncher() {}

  @Override
  public int launch(ClientOptions options) {
    System.err.println("no window in this build; start with --headless");
    return 1;
  }
}

package carom.client.desktop;

import carom.client.ClientOptions;
import carom.client.ImpairedTransport;
import carom.client.Window;
import carom.net.kryo.KryoClientTransport;
import carom.net.transport.ClientTransport;
import com.badlogic.gdx.backends.lwjgl3.Lwjgl3Application;
import com.badlogic.gdx.backends.lwjgl3.Lwjgl3ApplicationConfiguration;

/** Opens the client's window; found by {@code ServiceLoader} as {@link Window}. */
public final class DesktopLauncher implements Window {
  private static final int WIDTH = 1_280;
  private static final int HEIGHT = 720;
  private static final int SAMPLES = 4;
  private static final int MAX_FPS = 144;

  /** Called by the service loader. */
  public DesktopLauncher() {}

  @Override
  public int launch(ClientOptions options) {
    Lwjgl3ApplicationConfiguration window = new Lwjgl3ApplicationConfiguration();
    window.setTitle("Carom");
    window.setWindowedMode(WIDTH, HEIGHT);
    window.setWindowSizeLimits(640, 360, -1, -1);
    window.setBackBufferConfig(8, 8, 8, 8, 16, 0, SAMPLES);
    window.useVsync(true);
    window.setForegroundFPS(MAX_FPS);
    window.disableAudio(true);
    try (ClientTransport transport =
        new ImpairedTransport(new KryoClientTransport(), options.impairment(), System::nanoTime)) {
      new Lwjgl3Application(new CaromWindow(options, transport), window);
      return 0;
    } catch (RuntimeException | UnsatisfiedLinkError e) {
      System.err.println(
          "carom-client: can't open a window: "
              + e.getMessage()
              + "\nA window needs a display (DISPLAY="
              + System.getenv("DISPLAY")
              + ") and OpenGL. Without one, play headless with --headless, or on Linux start it"
              + " under xvfb-run.");
      return 1;
    }
  }
}

package carom.client.desktop;

import carom.client.app.ClientOptions;
import carom.client.app.RenderJob;
import carom.client.app.Window;
import carom.client.desktop.game.AudioDevice;
import carom.client.settings.PlayerSettings;
import carom.game.GameFault;
import carom.net.kryo.KryoClientTransport;
import carom.net.kryo.KryoMessageCodec;
import carom.net.transport.ClientTransport;
import carom.net.transport.ImpairedClientTransport;
import com.badlogic.gdx.backends.lwjgl3.Lwjgl3Application;
import com.badlogic.gdx.backends.lwjgl3.Lwjgl3ApplicationConfiguration;
import com.badlogic.gdx.backends.lwjgl3.Lwjgl3WindowAdapter;
import com.badlogic.gdx.utils.GdxRuntimeException;

/** Opens the client's window; found by {@code ServiceLoader} as {@link Window}. */
public final class DesktopLauncher implements Window {
  private static final int MAX_FPS = 144;

  /** Creates a launcher; the service loader calls this. */
  public DesktopLauncher() {}

  @Override
  public int launch(ClientOptions options) {
    if (!hasDisplay()) {
      return refuse("neither DISPLAY nor WAYLAND_DISPLAY is set");
    }
    Lwjgl3ApplicationConfiguration window = new Lwjgl3ApplicationConfiguration();
    window.setTitle("Carom");
    PlayerSettings settings = options.settings().settings();
    window.setWindowedMode(
        settings.get(PlayerSettings.WINDOW).width(), settings.get(PlayerSettings.WINDOW).height());
    if (settings.get(PlayerSettings.FULLSCREEN)) {
      window.setFullscreenMode(Lwjgl3ApplicationConfiguration.getDisplayMode());
    }
    window.setWindowSizeLimits(640, 360, -1, -1);
    window.setBackBufferConfig(8, 8, 8, 8, 0, 0, 0); // the canvas smooths edges itself
    window.useVsync(settings.get(PlayerSettings.VSYNC));
    window.setForegroundFPS(MAX_FPS);
    boolean hasSound = CaromWindow.wantsSound(options) && AudioDevice.mayExist();
    window.disableAudio(!hasSound);
    try (ClientTransport transport =
        new ImpairedClientTransport(
            new KryoClientTransport(options.trust(), options.impairment()),
            options.impairment(),
            new KryoMessageCodec(),
            System::nanoTime)) {
      return run(new CaromWindow(options, transport, hasSound), window);
    }
  }

  private static int run(CaromWindow window, Lwjgl3ApplicationConfiguration settings) {
    try {
      settings.setWindowListener(
          new Lwjgl3WindowAdapter() {
            @Override
            public boolean closeRequested() {
              return !window.asksToStay();
            }
          });
      new Lwjgl3Application(window, settings);
      return 0;
    } catch (RuntimeException | Error e) {
      if (!window.isOpen()) {
        return refuse(e.getMessage());
      }
      Throwable cause = e instanceof GdxRuntimeException && e.getCause() != null ? e.getCause() : e;
      System.err.println("carom-client: the window failed: " + GameFault.describe(cause));
      cause.printStackTrace();
      return 1;
    }
  }

  @Override
  public int render(RenderJob job) {
    if (!hasDisplay()) {
      return refuse("neither DISPLAY nor WAYLAND_DISPLAY is set");
    }
    Lwjgl3ApplicationConfiguration window = new Lwjgl3ApplicationConfiguration();
    window.setWindowedMode(job.width(), job.height());
    window.setInitialVisible(false);
    window.setBackBufferConfig(8, 8, 8, 8, 0, 0, 0);
    window.useVsync(false);
    window.setForegroundFPS(0);
    window.disableAudio(true);
    FilmMaker film = new FilmMaker(job);
    try {
      new Lwjgl3Application(film, window);
      return film.problem().isEmpty() ? 0 : 1;
    } catch (GdxRuntimeException | UnsatisfiedLinkError e) {
      return refuse(e.getMessage());
    }
  }

  /** Returns whether there is a display. Without one the toolkit prints a page of stack trace. */
  private static boolean hasDisplay() {
    return !System.getProperty("os.name").startsWith("Linux")
        || System.getenv("DISPLAY") != null
        || System.getenv("WAYLAND_DISPLAY") != null;
  }

  private static int refuse(String why) {
    System.err.println(
        "carom-client: can't open a window: "
            + why
            + ".\nA window needs a display and OpenGL. Without them: carom-client --headless, or on"
            + " Linux xvfb-run carom-client.");
    return 1;
  }
}

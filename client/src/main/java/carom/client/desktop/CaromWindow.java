package carom.client.desktop;

import carom.client.ClientConfig;
import carom.client.GameClient;
import carom.client.app.ClientOptions;
import carom.client.desktop.paint.Canvas;
import carom.client.desktop.paint.Fonts;
import carom.client.desktop.scene.SceneScreen;
import carom.client.desktop.sound.AudioDevice;
import carom.client.desktop.sound.EventSounds;
import carom.client.link.RoomBrowser;
import carom.client.link.ServerAddress;
import carom.client.replay.ReplayClient;
import carom.client.replay.SpectatorThread;
import carom.net.transport.ClientTransport;
import com.badlogic.gdx.Application;
import com.badlogic.gdx.ApplicationAdapter;
import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.Input.Keys;
import com.badlogic.gdx.Screen;
import com.badlogic.gdx.graphics.Pixmap;
import com.badlogic.gdx.graphics.PixmapIO;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;

/** The application: shows one screen at a time. Render thread only. */
final class CaromWindow extends ApplicationAdapter {
  private final ClientOptions options;
  private final ClientTransport transport;
  private final boolean hasSound;
  private ClientConfig config;
  private Fonts fonts;
  private Canvas canvas;
  private AudioDevice audio;
  private EventSounds sounds;
  private Screen screen;
  private double seconds;

  /**
   * Creates it; nothing opens.
   *
   * @param hasSound whether the toolkit was asked for sound
   */
  CaromWindow(ClientOptions options, ClientTransport transport, boolean hasSound) {
    this.options = options;
    this.hasSound = hasSound;
    this.transport = transport;
    config = options.config();
  }

  @Override
  public void create() {
    Gdx.app.setLogLevel(Application.LOG_ERROR); // the toolkit tells of each device it finds
    fonts = new Fonts(1);
    fonts.fit(Gdx.graphics.getWidth(), Gdx.graphics.getHeight());
    canvas = new Canvas();
    audio = new AudioDevice(hasSound);
    sounds = new EventSounds(audio, options.volume());
    if (wantsSound(options) && !audio.works()) {
      System.err.println("carom-client: no audio device: plays without sound");
    }
    if (options.replay() != null) {
      replay();
    } else if (options.scene() != null) {
      SceneScreen viewer = new SceneScreen(canvas, fonts, () -> Gdx.app.exit());
      viewer.debug(options.debug());
      viewer.open(options.scene());
      show(viewer);
    } else if (options.connectAtOnce()) {
      play();
    } else {
      ask("");
    }
  }

  /** Returns whether there is anything to hear; scenes are silent. */
  static boolean wantsSound(ClientOptions options) {
    return options.volume() > 0 && options.scene() == null;
  }

  private void replay() {
    try {
      ReplayClient recording = new ReplayClient(options.replay());
      SpectatorThread spectator = options.spectator();
      ReplayScreen player =
          new ReplayScreen(
              canvas,
              fonts,
              sounds,
              recording,
              spectator == null ? "REPLAY" : "WATCHING",
              spectator == null ? () -> "" : spectator::end,
              () -> Gdx.app.exit());
      player.debug(options.debug());
      if (spectator != null) {
        recording.seek(Integer.MAX_VALUE);
      }
      show(player);
    } catch (IOException e) {
      throw new UncheckedIOException(e); // it could be opened a moment ago
    }
  }

  private void ask(String message) {
    ConnectScreen ask =
        new ConnectScreen(
            fonts,
            new ConnectScreen.Target() {
              @Override
              public void connect(ServerAddress server, String name, String room) {
                config =
                    config
                        .withServer(server.host(), server.tcpPort(), server.udpPort())
                        .withName(name)
                        .withRoom(room.isEmpty() ? options.config().room() : room);
                Gdx.app.postRunnable(CaromWindow.this::play);
              }

              @Override
              public RoomBrowser browse(ServerAddress server) {
                return new RoomBrowser(server, transport);
              }
            },
            config.host(),
            config.tcpPort(),
            config.udpPort(),
            config.name());
    ask.message(message);
    show(ask);
  }

  private void play() {
    GameScreen game =
        new GameScreen(canvas, fonts, sounds, reason -> Gdx.app.postRunnable(() -> left(reason)));
    game.client(new GameClient(config, transport, game.devices()));
    game.netGraph(options.netGraph());
    game.debug(options.debug());
    show(game);
  }

  private void left(String reason) {
    if (screen instanceof GameScreen) {
      ask(reason);
    }
  }

  private void show(Screen next) {
    if (screen != null) {
      screen.hide();
      screen.dispose();
    }
    screen = next;
    screen.show();
    screen.resize(Gdx.graphics.getWidth(), Gdx.graphics.getHeight());
  }

  @Override
  public void render() {
    float delta = Gdx.graphics.getDeltaTime();
    seconds += delta;
    screen.render(delta);
    boolean over = options.seconds() > 0 && seconds >= options.seconds();
    if (Gdx.input.isKeyJustPressed(Keys.F12)) {
      save("carom-" + System.currentTimeMillis() + ".png");
    }
    if (over) {
      if (!options.screenshot().isEmpty()) {
        save(options.screenshot());
      }
      Gdx.app.exit();
    }
  }

  /** Writes what the window shows to a PNG file. */
  private static void save(String file) {
    Pixmap picture =
        Pixmap.createFromFrameBuffer(
            0, 0, Gdx.graphics.getBackBufferWidth(), Gdx.graphics.getBackBufferHeight());
    Pixmap opaque = new Pixmap(picture.getWidth(), picture.getHeight(), Pixmap.Format.RGB888);
    opaque.setBlending(
        Pixmap.Blending.None); // panels are seen through in the window, not in a file
    opaque.drawPixmap(picture, 0, 0);
    PixmapIO.writePNG(
        Gdx.files.absolute(Path.of(file).toAbsolutePath().toString()), opaque, 6, true);
    opaque.dispose();
    picture.dispose();
    System.err.println("screenshot saved: " + file);
  }

  @Override
  public void resize(int width, int height) {
    fonts.fit(width, height);
    screen.resize(width, height);
  }

  @Override
  public void dispose() {
    if (screen != null) {
      screen.dispose();
    }
    audio.dispose();
    canvas.dispose();
    fonts.dispose();
  }
}

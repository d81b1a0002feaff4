package carom.client.desktop;

import carom.client.ClientConfig;
import carom.client.GameClient;
import carom.client.LevelSender;
import carom.client.app.ClientOptions;
import carom.client.app.LocalGames;
import carom.client.desktop.game.AudioDevice;
import carom.client.desktop.game.EventSounds;
import carom.client.desktop.game.SceneScreen;
import carom.client.desktop.menu.KeyMap;
import carom.client.desktop.menu.SettingsHost;
import carom.client.desktop.menu.StartScreen;
import carom.client.desktop.menu.StartTarget;
import carom.client.desktop.menu.Widgets;
import carom.client.desktop.paint.Canvas;
import carom.client.desktop.paint.Fonts;
import carom.client.desktop.paint.LevelPictures;
import carom.client.desktop.paint.UiColours;
import carom.client.edit.EditFile;
import carom.client.link.LanSearch;
import carom.client.link.RoomBrowser;
import carom.client.link.ServerAddress;
import carom.client.replay.ReplayClient;
import carom.client.replay.SpectatorThread;
import carom.client.settings.PlayerSettings;
import carom.game.GameFault;
import carom.net.protocol.ServerMessage.RoomEntry;
import carom.net.transport.ClientTransport;
import carom.sim.level.Level;
import carom.sim.scene.Scene;
import carom.text.FileErrors;
import com.badlogic.gdx.Application;
import com.badlogic.gdx.ApplicationAdapter;
import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.Graphics;
import com.badlogic.gdx.Input.Keys;
import com.badlogic.gdx.Screen;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The application: shows one screen at a time, and keeps what outlives a screen: fonts, sound,
 * settings, a game of this machine. Render thread only.
 */
final class CaromWindow extends ApplicationAdapter implements SettingsHost, StartTarget, EditHost {
  /** Time between two looks at a recording that begins to arrive. */
  private static final float LOOK_SECONDS = 0.1f;

  private static final Logger LOG = LoggerFactory.getLogger(CaromWindow.class);

  private final ClientOptions options;
  private final ClientTransport sockets;
  private final boolean hasSound;
  private final LocalGames games = LocalGames.find();
  private final KeyMap keys;
  private final List<Level> levels = new ArrayList<>();
  private ClientConfig config;

  /**
   * The name by the command line, until the player types another; null for that of the settings.
   */
  private String givenName;

  private String givenParty; // as givenName

  private Fonts fonts;
  private Widgets widgets;
  private Canvas canvas;
  private LevelPictures pictures;
  private AudioDevice audio;
  private EventSounds sounds;
  private Screen screen;

  /** The level that is edited, also while it is played; null without. */
  private EditScreen edited;

  private LocalGames.LocalGame local;

  /** The server is among those played on lately, or needn't be. */
  private boolean noted;

  private SpectatorThread spectator;

  /** Downloads from the server to which the one that is watched has sent us; null without. */
  private SpectatorThread next;

  /** Action that leaves the film that is shown. */
  private Runnable leaveFilm = () -> {};

  private float untilLook;
  private double seconds;
  private boolean open;

  /**
   * Creates it; nothing opens.
   *
   * @param sockets opens links to servers
   * @param hasSound whether the toolkit was asked for sound
   */
  CaromWindow(ClientOptions options, ClientTransport sockets, boolean hasSound) {
    this.options = options;
    givenName = options.named() ? options.config().get(ClientConfig.NAME) : null;
    String party = options.config().get(ClientConfig.PARTY);
    givenParty = party.isEmpty() ? null : party;
    this.hasSound = hasSound;
    this.sockets = sockets;
    config = options.config();
    keys = new KeyMap(settings());
  }

  @Override
  public void create() {
    Gdx.app.setLogLevel(Application.LOG_ERROR); // the toolkit tells of each device it finds
    fonts = new Fonts(settings().get(PlayerSettings.TEXT_SIZE) / 100f);
    fonts.fit(Gdx.graphics.getWidth(), Gdx.graphics.getHeight());
    widgets = new Widgets(fonts);
    canvas = new Canvas();
    pictures = new LevelPictures(canvas);
    audio = new AudioDevice(hasSound);
    sounds = new EventSounds(audio, volume(options) / 100f);
    UiColours.palette(settings().get(PlayerSettings.PALETTE));
    if (!keys.unknown().isEmpty()) {
      System.err.println("carom-client: unknown keys in the settings: " + keys.unknown());
    }
    if (wantsSound(options) && !audio.works()) {
      System.err.println("carom-client: no audio device: plays without sound");
    }
    if (options.replay() != null) {
      String problem = show(options.replay(), options.spectator(), () -> Gdx.app.exit());
      if (!problem.isEmpty()) {
        throw new IllegalStateException(problem); // it could be opened a moment ago
      }
    } else if (options.scene() != null) {
      show(options.scene(), () -> Gdx.app.exit());
    } else if (options.edit() != null) {
      String problem = edit(options.edit());
      if (!problem.isEmpty()) {
        throw new IllegalStateException(problem); // it could be opened a moment ago
      }
    } else if (options.here() != null) {
      playHere(options.here());
    } else if (options.connectAtOnce()) {
      play();
    } else {
      start("");
    }
    open = true;
  }

  /** Returns whether the window is open: what fails from then on has nothing to do with opening. */
  boolean isOpen() {
    return open;
  }

  /** Returns whether there is anything to hear; scenes are silent. */
  static boolean wantsSound(ClientOptions options) {
    return volume(options) > 0 && options.scene() == null;
  }

  private static int volume(ClientOptions options) {
    return options.volume() >= 0
        ? options.volume()
        : options.settings().settings().get(PlayerSettings.VOLUME);
  }

  // ---- screens

  private void start(String message) {
    endLocalGame();
    endWatching();
    keys.game("", List.of());
    EditScreen left = edited;
    edited = null;
    if (left != null && left != screen) {
      left.dispose();
    }
    StartScreen start = new StartScreen(widgets, this, this, games, pictures, server().toText());
    start.message(message);
    show(start);
  }

  private ServerAddress server() {
    return new ServerAddress(
        config.get(ClientConfig.SERVER).host(),
        config.get(ClientConfig.SERVER).tcpPort(),
        config.get(ClientConfig.SERVER).udpPort());
  }

  private void play() {
    config =
        config
            .with(ClientConfig.NAME, playerName())
            .with(ClientConfig.PARTY, local == null ? party() : "");
    ClientConfig visit =
        config.with(
            ClientConfig.MIN_INTERPOLATION_MS, settings().get(PlayerSettings.INTERPOLATION));
    GameScreen game =
        new GameScreen(
            canvas, this::levelOf, pictures, fonts, sounds, keys, widgets, this, this::leave);
    ClientTransport transport = local == null ? sockets : local.transport();
    game.client(new GameClient(visit, transport, game.devices()));
    game.colour(settings().get(PlayerSettings.COLOUR));
    game.netGraph(options.netGraph());
    game.debug(options.debug());
    game.adviceAlone(AloneAdvice.of(local != null, server()));
    noted = local != null;
    if (local == null) {
      game.sender(level -> new LevelSender(visit, level, sockets));
    }
    if (edited != null) {
      game.escape(() -> leave(""));
    }
    show(game);
    if (local != null && !local.invitation().isEmpty()) {
      game.announce(local.invitation());
    }
  }

  /** Plays a game of this machine at once; says on the start screen why it can't be started. */
  private void playHere(LocalGames.GameChoice choice) {
    try {
      local = games.start(choice);
      play();
    } catch (IllegalStateException e) {
      start(e.getMessage());
    }
  }

  /** Returns the level of a room if this machine has it, or null. */
  private Level levelOf(RoomEntry room) {
    if (levels.isEmpty() && games != null) {
      games.levels().forEach(name -> levels.add(games.level(name)));
    }
    return levels.stream()
        .filter(level -> level.name().equals(room.level()) && level.gameName().equals(room.game()))
        .findFirst()
        .orElse(null);
  }

  /** Leaves a game after the present frame. If no server was there, offers to start one. */
  private void leave(String reason) {
    if (!(screen instanceof GameScreen left)) {
      return; // two reasons in one frame
    }
    if (edited != null) {
      later(() -> backToEditor(reason));
      return;
    }
    boolean offers = games != null && local == null && !reason.isEmpty() && !left.hasPlayed();
    later(
        () -> {
          if (screen == left) {
            start(reason);
            if (offers && screen instanceof StartScreen start) {
              start.offer(reason);
            }
          }
        });
  }

  private void later(Runnable next) {
    Gdx.app.postRunnable(next);
  }

  /** Shows a recording. Returns why it can't, or an empty text. */
  private String show(Path file, SpectatorThread download, Runnable exit) {
    leaveFilm = exit;
    ReplayClient recording;
    try {
      recording = new ReplayClient(file);
    } catch (IOException e) {
      return String.valueOf(e.getMessage());
    }
    ReplayScreen player =
        new ReplayScreen(
            canvas,
            fonts,
            sounds,
            recording,
            download == null ? "REPLAY" : "WATCHING",
            download == null ? () -> "" : download::end,
            exit);
    player.debug(options.debug());
    if (download != null) {
      recording.seek(Integer.MAX_VALUE);
    }
    if (screen == null) {
      show(player);
    } else {
      later(() -> show(player)); // not while the start screen handles a key
    }
    return "";
  }

  private void show(Scene scene, Runnable exit) {
    SceneScreen viewer = new SceneScreen(canvas, fonts, exit);
    viewer.debug(options.debug());
    viewer.open(scene);
    show(viewer);
  }

  private void show(Screen next) {
    if (screen != null) {
      screen.hide();
      if (screen != edited) {
        screen.dispose();
      }
    }
    screen = next;
    screen.show();
    screen.resize(Gdx.graphics.getWidth(), Gdx.graphics.getHeight());
  }

  // ---- the editor

  @Override
  public String edit(Path file) {
    try {
      EditScreen editor =
          new EditScreen(canvas, fonts, widgets, new EditFile(file), options.bots(), this);
      if (screen == null) {
        edit(editor);
      } else {
        later(() -> edit(editor)); // not while the start screen handles a key
      }
      return "";
    } catch (IOException e) {
      return e.getMessage();
    }
  }

  @Override
  public void play(Level level, int bots) {
    if (games == null) {
      throw new IllegalStateException("This build can't start games; it lacks carom-launcher.");
    }
    local = games.start(level, bots);
    later(this::play);
  }

  private void edit(EditScreen editor) {
    edited = editor;
    show(editor);
  }

  @Override
  public List<String> servers() {
    PlayerSettings s = settings();
    Set<String> servers = new LinkedHashSet<>(s.get(PlayerSettings.RECENT));
    servers.addAll(s.get(PlayerSettings.FAVOURITES));
    servers.add(server().toText());
    return List.copyOf(servers);
  }

  @Override
  public LevelSender send(String server, byte[] level) {
    ServerAddress to = ServerAddress.parse(server);
    ClientConfig by =
        config
            .withServer(to.host(), to.tcpPort(), to.udpPort())
            .with(ClientConfig.NAME, playerName());
    if (!to.equals(server())) { // a password is shown to no other server
      by = by.with(ClientConfig.PASSWORD, "");
    }
    return new LevelSender(by, level, sockets);
  }

  @Override
  public String warning(Level level) {
    List<String> warnings = games == null ? List.of() : games.warnings(level);
    String more = warnings.size() > 1 ? " (and " + (warnings.size() - 1) + " more)" : "";
    return warnings.isEmpty() ? "" : warnings.get(0) + more;
  }

  private void backToEditor(String reason) {
    if (screen == edited) {
      return; // two reasons in one frame
    }
    endLocalGame();
    keys.game("", List.of());
    show(edited);
    edited.message(reason);
  }

  @Override
  public void leave() {
    if (options.edit() == null) {
      later(() -> backTo(StartScreen.LEVELS));
    } else {
      Gdx.app.exit();
    }
  }

  /** Returns whether the window stays open because changes would be lost; the editor asks then. */
  boolean asksToStay() {
    return edited != null && screen == edited && edited.asksToStay();
  }

  /** Returns the screen that is shown. */
  Screen screen() {
    return screen;
  }

  // ---- what the start screen asks for

  @Override
  public void play(ServerAddress server, String room) {
    config =
        config
            .withServer(server.host(), server.tcpPort(), server.udpPort())
            .with(
                ClientConfig.ROOM, room.isEmpty() ? options.config().get(ClientConfig.ROOM) : room);
    later(this::play);
  }

  @Override
  public void password(ServerAddress server, String text) {
    ClientConfig given = options.config();
    boolean named =
        server.equals(
            new ServerAddress(
                given.get(ClientConfig.SERVER).host(),
                given.get(ClientConfig.SERVER).tcpPort(),
                given.get(ClientConfig.SERVER).udpPort()));
    config =
        config.with(
            ClientConfig.PASSWORD,
            text.isEmpty() && named ? given.get(ClientConfig.PASSWORD) : text);
  }

  @Override
  public void create(LocalGames.GameChoice choice) {
    endLocalGame();
    local = games.start(choice);
    later(this::play);
  }

  @Override
  public void watch(ServerAddress server, int room) {
    endWatching();
    config = config.withServer(server.host(), server.tcpPort(), server.udpPort());
    try {
      spectator = new SpectatorThread(config, room, sockets);
    } catch (IOException e) {
      start("Can't watch: " + FileErrors.reason(e) + ".");
    }
  }

  /** Shows what is watched as soon as enough of it is here. */
  private void lookAtDownload(float delta) {
    untilLook -= delta;
    if (untilLook > 0) {
      return;
    }
    untilLook = LOOK_SECONDS;
    followRedirect();
    if (spectator == null || !(screen instanceof StartScreen start)) {
      return;
    }
    if (spectator.isReady()) {
      String problem = show(spectator.file(), spectator, () -> later(() -> start("")));
      if (!problem.isEmpty()) {
        start(problem);
      }
    } else if (spectator.isOver()) {
      start.message(spectator.message());
      endWatching();
    }
  }

  /**
   * Goes to the server to which the watched one has sent us. The film goes on until enough of the
   * other server's game is here.
   */
  private void followRedirect() {
    SpectatorThread watched = spectator == null ? options.spectator() : spectator;
    boolean waits = screen instanceof StartScreen;
    if (watched == null || !(waits || screen instanceof ReplayScreen)) {
      return;
    }
    if (next == null) {
      try {
        next = watched.follow();
      } catch (IOException e) {
        System.err.println("carom-client: can't watch: " + FileErrors.reason(e));
      }
    }
    if (next != null && (waits || next.isReady())) {
      SpectatorThread arrived = next;
      next = null;
      endWatching();
      spectator = arrived;
      String problem = waits ? "" : show(arrived.file(), arrived, leaveFilm);
      if (!problem.isEmpty()) {
        start(problem);
      }
    } else if (next != null && next.isOver()) {
      next.close();
      next = null;
    }
  }

  @Override
  public String replay(Path file) {
    return show(file, null, () -> later(() -> backTo(StartScreen.REPLAYS)));
  }

  @Override
  public void scene(Scene scene) {
    later(() -> show(scene, () -> later(() -> backTo(StartScreen.SCENES))));
  }

  private void backTo(String page) {
    start("");
    ((StartScreen) screen).open(page);
  }

  @Override
  public void quit() {
    Gdx.app.exit();
  }

  @Override
  public LanSearch searchLan() {
    try {
      return new LanSearch();
    } catch (IOException e) {
      return null; // the page says so
    }
  }

  @Override
  public RoomBrowser browse(ServerAddress server) {
    return new RoomBrowser(server, sockets);
  }

  private void endLocalGame() {
    if (local != null) {
      if (screen instanceof GameScreen game) {
        game.leaveServer();
      }
      local.close();
      local = null;
    }
  }

  private void endWatching() {
    if (spectator != null) {
      spectator.close();
      spectator = null;
    }
    if (next != null) {
      next.close();
      next = null;
    }
  }

  // ---- settings

  @Override
  public PlayerSettings settings() {
    return options.settings().settings();
  }

  @Override
  public KeyMap keys() {
    return keys;
  }

  @Override
  public String playerName() {
    return givenName == null ? settings().get(PlayerSettings.NAME) : givenName;
  }

  @Override
  public void playerName(String name) {
    if (!name.equals(playerName())) {
      givenName = null;
      change(settings().with(PlayerSettings.NAME, name));
    }
  }

  @Override
  public String party() {
    return givenParty == null ? settings().get(PlayerSettings.PARTY) : givenParty;
  }

  @Override
  public void party(String party) {
    if (!party.equals(party())) {
      givenParty = null;
      change(settings().with(PlayerSettings.PARTY, party));
    }
  }

  @Override
  public void change(PlayerSettings changed) {
    PlayerSettings before = settings();
    options.settings().save(changed);
    keys.set(changed);
    if (!changed.get(PlayerSettings.VOLUME).equals(before.get(PlayerSettings.VOLUME))) {
      sounds.volume(changed.get(PlayerSettings.VOLUME) / 100f);
    }
    if (!changed.get(PlayerSettings.VSYNC).equals(before.get(PlayerSettings.VSYNC))) {
      Gdx.graphics.setVSync(changed.get(PlayerSettings.VSYNC));
    }
    if (screen instanceof GameScreen game) {
      game.colour(changed.get(PlayerSettings.COLOUR));
    }
    UiColours.palette(changed.get(PlayerSettings.PALETTE));
    fonts.textSize(changed.get(PlayerSettings.TEXT_SIZE) / 100f);
    boolean resized = !changed.get(PlayerSettings.WINDOW).equals(before.get(PlayerSettings.WINDOW));
    if (!changed.get(PlayerSettings.FULLSCREEN).equals(before.get(PlayerSettings.FULLSCREEN))
        || resized) {
      if (changed.get(PlayerSettings.FULLSCREEN)) {
        Gdx.graphics.setFullscreenMode(Gdx.graphics.getDisplayMode());
      } else {
        Gdx.graphics.setWindowedMode(
            changed.get(PlayerSettings.WINDOW).width(),
            changed.get(PlayerSettings.WINDOW).height());
      }
    }
    later(() -> resize(Gdx.graphics.getWidth(), Gdx.graphics.getHeight()));
  }

  @Override
  public int[] largestWindow() {
    Graphics.DisplayMode screen = Gdx.graphics.getDisplayMode();
    return new int[] {screen.width, screen.height};
  }

  @Override
  public String problem() {
    return options.settings().problem();
  }

  // ---- frames

  @Override
  public void render() {
    float delta = Gdx.graphics.getDeltaTime();
    seconds += delta;
    lookAtDownload(delta);
    renderScreen(delta);
    noteVisit();
    boolean over = options.seconds() > 0 && seconds >= options.seconds();
    if (Gdx.input.isKeyJustPressed(Keys.F12)) {
      Pictures.save("carom-" + System.currentTimeMillis() + ".png");
    }
    if (over) {
      if (!options.screenshot().isEmpty()) {
        Pictures.save(options.screenshot());
      }
      Gdx.app.exit();
    }
  }

  /** Draws the screen. One that fails as a whole is left for the start screen, which tells why. */
  private void renderScreen(float delta) {
    try {
      screen.render(delta);
    } catch (RuntimeException | Error e) {
      if (screen instanceof StartScreen) {
        throw e;
      }
      LOG.error("the screen {} failed and is left", screen.getClass().getSimpleName(), e);
      canvas.abandon();
      String reason = "The screen failed and was left: " + GameFault.describe(e);
      if (edited != null && screen != edited) {
        backToEditor(reason);
      } else {
        start(reason + (edited == null ? "" : edited.rescue()));
      }
    }
  }

  /** Keeps the server among those played on lately, once the player is in its game. */
  private void noteVisit() {
    if (!noted && screen instanceof GameScreen game && game.hasPlayed()) {
      noted = true;
      change(settings().withRecent(server().toText()));
    }
  }

  @Override
  public void resize(int width, int height) {
    if (width == 0 || height == 0) {
      return; // the window is hidden
    }
    fonts.fit(width, height);
    screen.resize(width, height);
  }

  @Override
  public void dispose() {
    keepWindow();
    if (screen != null) {
      screen.dispose();
    }
    if (edited != null && edited != screen) {
      edited.dispose();
    }
    if (local != null) {
      local.close();
    }
    endWatching();
    audio.dispose();
    pictures.dispose();
    canvas.dispose();
    widgets.dispose();
    fonts.dispose();
  }

  /** Keeps the size to which the player has drawn the window. */
  private void keepWindow() {
    PlayerSettings s = settings();
    int width = Gdx.graphics.getWidth();
    int height = Gdx.graphics.getHeight();
    if (!s.get(PlayerSettings.FULLSCREEN)
        && (width != s.get(PlayerSettings.WINDOW).width()
            || height != s.get(PlayerSettings.WINDOW).height())) {
      try {
        options.settings().save(s.withWindow(width, height));
      } catch (IllegalArgumentException e) {
        System.err.println("carom-client: the window's size is not kept: " + e.getMessage());
      }
    }
  }
}

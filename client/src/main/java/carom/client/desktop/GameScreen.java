package carom.client.desktop;

import carom.client.GameClient;
import carom.client.InputSource;
import carom.client.LevelSender;
import carom.client.desktop.KeyHints.Hint;
import carom.client.desktop.game.EventSounds;
import carom.client.desktop.game.GamePicture;
import carom.client.desktop.game.WorldPainter;
import carom.client.desktop.hud.Hud;
import carom.client.desktop.hud.Readiness;
import carom.client.desktop.menu.KeyMap;
import carom.client.desktop.menu.PauseMenu;
import carom.client.desktop.menu.SettingsHost;
import carom.client.desktop.menu.Widgets;
import carom.client.desktop.paint.Canvas;
import carom.client.desktop.paint.Fonts;
import carom.client.desktop.paint.LevelPictures;
import carom.client.desktop.paint.PictureParts;
import carom.client.desktop.paint.ViewCamera;
import carom.client.link.ConnectionPhase;
import carom.client.look.Action;
import carom.client.settings.KeyAction;
import carom.client.view.ClientView;
import carom.client.view.ClientView.Drawn;
import carom.net.protocol.ServerMessage.BestList;
import carom.net.protocol.ServerMessage.LevelList;
import carom.net.protocol.ServerMessage.RoomEntry;
import carom.net.protocol.ServerMessage.RosterEntry;
import carom.sim.entity.Input;
import carom.sim.level.Level;
import carom.sim.message.PlayerColour;
import carom.sim.message.PlayerRole;
import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.Input.Keys;
import com.badlogic.gdx.InputAdapter;
import com.badlogic.gdx.ScreenAdapter;
import com.badlogic.gdx.graphics.OrthographicCamera;
import java.util.List;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * One visit to a server, from connecting to leaving: updates the client, draws its view and samples
 * the devices. Render thread only.
 */
final class GameScreen extends ScreenAdapter {
  /** Receives the end of the visit. */
  interface Exit {
    /**
     * Ends the screen: the player left, or can't stay.
     *
     * @param reason in words for the player; empty when the player wanted to leave
     */
    void leave(String reason);
  }

  private static final Logger LOG = LoggerFactory.getLogger(GameScreen.class);

  /**
   * Time for which the last picture stays as it is when the link is lost, s: where another server
   * goes on with the room, the client is back sooner.
   */
  private static final float QUIET_SECONDS = 0.5f;

  private final GamePicture picture;
  private final NetGraph netGraph;
  private final KeyHints hints;
  private final Curtain curtain;
  private final RoomPanel rooms;
  private final PauseMenu pause;
  private final KeyMap keys;
  private final Controls controls;
  private final ActionHints actionHints;
  private final Readiness readiness = new Readiness();
  private final TeamNews teamNews;
  private final Exit exit;
  private final Fonts fonts;
  private GameClient client;
  private Conversation conversation;
  private float secondsPlayed;
  private float secondsAway;
  private boolean played;
  private int buttons; // of the last sample

  private Function<byte[], LevelSender> sender = level -> null;

  /** Runs at Esc instead of the menu; null for the menu. */
  private Runnable escape;

  /**
   * Creates a screen without a client; call {@link #client} next.
   *
   * @param levels returns a room's level, or null if this machine doesn't have it
   * @param levelPictures stays the property of the caller
   * @param keys the player's keys
   * @param widgets for the pause menu
   * @param host holds the settings that the pause menu shows
   */
  GameScreen(
      Canvas canvas,
      Function<RoomEntry, Level> levels,
      LevelPictures levelPictures,
      Fonts fonts,
      EventSounds sounds,
      KeyMap keys,
      Widgets widgets,
      SettingsHost host,
      Exit exit) {
    this.exit = exit;
    this.fonts = fonts;
    this.keys = keys;
    controls = new Controls(keys);
    actionHints = new ActionHints(keys, controls, canvas, fonts);
    pause = new PauseMenu(widgets, host, new PauseActions());
    picture = new GamePicture(canvas, fonts, sounds);
    picture.showSlowMotion();
    teamNews = new TeamNews(picture.game());
    netGraph = new NetGraph(canvas, picture.hud(), fonts);
    hints = new KeyHints(picture.hud(), fonts, picture.game());
    curtain = new Curtain(picture.hud(), canvas);
    rooms =
        new RoomPanel(
            picture.hud(),
            fonts,
            () -> client.listRooms(),
            name -> client.changeRoom(name),
            room -> {
              boolean here = room.name().equals(client.view().room());
              Level level = here ? client.view().level() : levels.apply(room);
              return level == null ? null : levelPictures.of(level);
            });
  }

  /** Sets what sends a level of the player's to the server. */
  void sender(Function<byte[], LevelSender> newSender) {
    sender = newSender;
  }

  /** Returns the devices as a source of input. */
  InputSource devices() {
    return (view, tick, out) -> sample(view, out);
  }

  /** Sets the client to update; it is closed with this screen. */
  void client(GameClient client) {
    this.client = client;
    client.events(picture.events(client.view()));
    conversation = new Conversation(client, keys, fonts);
    picture.labels(this::drawLabels);
  }

  /** Draws emotes and, beside the own body, the keys of the game's own actions. */
  private void drawLabels(ClientView view, Hud hud, ViewCamera camera, long nowNs) {
    conversation.drawEmotes(view, hud, camera, nowNs);
    Drawn own = view.own();
    if (own != null && !pause.isOpen()) {
      float radius = WorldPainter.extent(own.archetype());
      float pixels = radius * camera.pixelsPerMetre(Gdx.graphics.getHeight());
      actionHints.draw(hud, hud.at(camera, own.x(), own.y()), hud.points(pixels));
    }
  }

  /** Chooses the colour of the own body. */
  void colour(PlayerColour colour) {
    client.colour(colour);
  }

  /** Shows the net graph's few lines, or nothing of it. */
  void netGraph(boolean shown) {
    netGraph.size(shown ? NetGraph.Size.SMALL : NetGraph.Size.OFF);
  }

  /** Sets what a player is told who waits alone for others. */
  void adviceAlone(UnaryOperator<String> ofRoom) {
    picture.adviceAlone(ofRoom);
  }

  /** Sets what Esc and F5 do, instead of the menu. */
  void escape(Runnable action) {
    escape = action;
    announce("Esc: back to the editor");
  }

  /** Returns what the picture shows of the world. */
  ViewCamera camera() {
    return picture.camera();
  }

  /** Returns the texts and panels of the picture. */
  Hud hud() {
    return picture.hud();
  }

  /** Shows a line to the player for a while. */
  void announce(String text) {
    conversation.announce(text);
  }

  /** Returns whether the player has been in the game. */
  boolean hasPlayed() {
    return played;
  }

  /** Leaves the server, so that it can be stopped. */
  void leaveServer() {
    client.close();
  }

  /** Shows or hides the debug layers. */
  void debug(boolean shown) {
    picture.debug(shown);
  }

  /** Returns whether something lies over the picture of the game. */
  boolean isCovered() {
    return pause.isOpen() || rooms.isOpen() || !curtain.isOpen();
  }

  ClientView view() {
    return client.view();
  }

  /** Returns whether keys move through a menu, choose a room, or are letters. */
  private boolean areKeysForOthers() {
    return pause.isOpen() || rooms.isOpen() || conversation.isWriting();
  }

  private void sample(ClientView view, Input out) {
    if (areKeysForOthers()) {
      return;
    }
    Drawn own = view.own();
    controls.sample(out, picture.camera(), own == null ? 0 : own.x(), own == null ? 0 : own.y());
    readiness.sampled(view, out);
    if ((out.buttons() & ~buttons) != 0) {
      picture.skipSlowMotion();
    }
    buttons = out.buttons();
  }

  private final class PauseActions implements PauseMenu.Actions {
    @Override
    public void resume() {
      show();
    }

    @Override
    public void askForBest() {
      client.listBest();
    }

    @Override
    public List<BestList> best() {
      return client.view().best();
    }

    @Override
    public void askForLevels() {
      client.listLevels();
    }

    @Override
    public LevelList levels() {
      return client.view().levels();
    }

    @Override
    public void chooseLevel(String name) {
      client.chooseLevel(name);
    }

    @Override
    public LevelSender send(byte[] level) {
      return sender.apply(level);
    }

    @Override
    public void rooms() {
      rooms.toggle();
    }

    @Override
    public String playLink() {
      return client.view().playLink();
    }

    @Override
    public void leave() {
      exit.leave("");
    }

    @Override
    public void quit() {
      Gdx.app.exit();
    }
  }

  /** Returns the keys of the game, the ones a newcomer needs first. */
  private List<Hint> keyHints() {
    List<Hint> hinted = ActionHints.all(keys);
    if (keys.actions().isEmpty()) {
      hinted.add(new Hint(keys.first(KeyAction.MAIN) + ", click", KeyAction.MAIN.label()));
      hinted.add(
          new Hint(keys.first(KeyAction.SECOND) + ", right click", KeyAction.SECOND.label()));
    }
    hinted.addAll(
        List.of(
            new Hint(keys.first(KeyAction.PLAYERS), "players"),
            new Hint(keys.first(KeyAction.CHAT), "chat"),
            new Hint("1 to 8", "emotes"),
            new Hint(keys.first(KeyAction.MUTE), "sound"),
            new Hint("F1", "these keys"),
            new Hint("F2", "rooms"),
            new Hint("F3", "net graph"),
            new Hint("Esc", escape == null ? "menu" : "back to the editor")));
    return hinted;
  }

  @Override
  public void show() {
    hints.keys(keyHints());
    Gdx.input.setInputProcessor(
        new InputAdapter() {
          @Override
          public boolean keyTyped(char character) {
            conversation.typed(character);
            return true;
          }

          @Override
          public boolean keyDown(int key) {
            if (rooms.isOpen()) {
              rooms.key(key);
              return true;
            }
            if (conversation.isWriting()) {
              return conversation.key(key, isDown(Keys.SHIFT_LEFT, Keys.SHIFT_RIGHT));
            }
            if (escape != null && (key == Keys.ESCAPE || key == Keys.F5)) {
              escape.run();
              return true;
            }
            switch (key) {
              case Keys.F2 -> rooms.toggle();
              case Keys.F1 -> hints.toggle();
              case Keys.F3 -> netGraph.next();
              case Keys.ESCAPE -> Gdx.input.setInputProcessor(pause.open());
              default -> {
                return handle(key);
              }
            }
            return true;
          }
        });
  }

  private boolean handle(int key) {
    picture.skipSlowMotion();
    if (keys.does(key, KeyAction.MUTE)) {
      picture.toggleSound();
      return true;
    }
    return (keys.isDown(KeyAction.PLAYERS) && ask(key))
        || (client.view().watchedPlayer() >= 0 && watch(key))
        || keys.isOfGame(key)
        || conversation.key(key, isDown(Keys.SHIFT_LEFT, Keys.SHIFT_RIGHT))
        || picture.key(key);
  }

  /**
   * Asks the roster, while the table of players shows: ready or not, play or watch, a team by its
   * number.
   */
  private boolean ask(int key) {
    ClientView view = client.view();
    RosterEntry own = view.participant(view.playerId());
    int team = key - Keys.NUM_0;
    if (own == null) {
      return false;
    } else if (key == Keys.R) {
      client.ready(!own.ready());
      readiness.asked(view, !own.ready());
    } else if (key == Keys.P) {
      client.role(own.spectator() ? PlayerRole.PLAYER : PlayerRole.SPECTATOR);
    } else if (team >= 1 && team <= Math.min(9, picture.game().teamCount())) {
      client.team(team);
    } else {
      return false;
    }
    return true;
  }

  /** Follows another player. */
  private boolean watch(int key) {
    int step = key == Keys.A || key == Keys.LEFT ? -1 : key == Keys.D || key == Keys.RIGHT ? 1 : 0;
    if (step != 0) {
      client.watchNext(step);
    }
    return step != 0;
  }

  private static boolean isDown(int key, int otherKey) {
    return Gdx.input.isKeyPressed(key) || Gdx.input.isKeyPressed(otherKey);
  }

  @Override
  public void render(float deltaSeconds) {
    long nowNs = System.nanoTime();
    if (areKeysForOthers() || client.view().phase() != ConnectionPhase.PLAYING) {
      controls.forget(); // what is pressed while a level loads is no order for its first tick
    } else {
      controls.note();
    }
    client.update(nowNs);
    ClientView view = client.view();
    if (view.phase() == ConnectionPhase.ENDED) {
      exit.leave(view.message());
      return;
    }
    played |= view.phase() == ConnectionPhase.PLAYING;
    secondsPlayed = view.phase() == ConnectionPhase.PLAYING ? secondsPlayed + deltaSeconds : 0;
    secondsAway = view.phase() == ConnectionPhase.RECONNECTING ? secondsAway + deltaSeconds : 0;
    if (view.phase() == ConnectionPhase.PLAYING) {
      tellNews(view);
      actionHints.play(view.own() == null ? 0 : deltaSeconds);
    }
    draw(view, nowNs, deltaSeconds);
  }

  private void tellNews(ClientView view) {
    if (readiness.find(view, picture.game().clock())) {
      client.ready(true);
    }
    String news = curtain.isOpen() ? teamNews.take(view) : "";
    if (!news.isEmpty()) {
      picture.hud().showAnswer(news);
    }
  }

  private void draw(ClientView view, long nowNs, float deltaSeconds) {
    Hud hud = picture.hud();
    if (Gdx.input.justTouched()) {
      picture.skipSlowMotion();
    }
    boolean tab = !pause.isOpen() && keys.isDown(KeyAction.PLAYERS);
    picture.panels(!rooms.isOpen());
    picture.draw(view, tab, nowNs, deltaSeconds);
    takeActions(view);
    if (view.level() != null) {
      OrthographicCamera shown = picture.camera().gdx();
      client.look(shown.position.x, shown.position.y, shown.viewportWidth, shown.viewportHeight);
    }
    PictureParts parts = picture.parts();
    parts.run("curtain", () -> curtain.draw(view, deltaSeconds));
    boolean plays =
        view.phase() == ConnectionPhase.PLAYING || (secondsAway > 0 && secondsAway < QUIET_SECONDS);
    if (!plays) {
      if (parts.isBroken("curtain") || !curtain.showsLoading()) {
        hud.phase(view);
      }
    } else {
      if (view.own() == null && secondsPlayed > 1) {
        parts.run("words for those without a body", () -> hud.bodiless(view));
      }
      parts.run("chat", () -> conversation.draw(hud, nowNs));
    }
    if (plays && !rooms.isOpen()) {
      parts.run("key hints", () -> hints.draw(deltaSeconds));
    }
    if (!rooms.isOpen()) {
      int framesPerSecond = Gdx.graphics.getFramesPerSecond();
      parts.run("net graph", () -> netGraph.draw(view, nowNs, framesPerSecond, deltaSeconds));
    }
    parts.run("rooms", () -> rooms.draw(view, deltaSeconds));
    if (pause.isOpen()) {
      hud.veil();
      pause.draw(deltaSeconds);
    }
  }

  /** Makes the actions of the game that is shown those of the keys. */
  private void takeActions(ClientView view) {
    List<Action> actions = picture.look().setup().actions();
    if (keys.actions() != actions) {
      keys.game(view.game(), actions);
      hints.keys(keyHints());
      if (!keys.unknown().isEmpty()) {
        LOG.warn("unknown keys in the view of {} or the settings: {}", view.game(), keys.unknown());
      }
    }
  }

  @Override
  public void resize(int width, int height) {
    pause.resize(width, height);
  }

  @Override
  public void dispose() {
    if (client != null) {
      client.close();
    }
    pause.dispose();
    picture.dispose();
  }
}

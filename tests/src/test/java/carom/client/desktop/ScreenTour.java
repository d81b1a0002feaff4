package carom.client.desktop;

import carom.client.app.ClientMain;
import carom.client.app.LocalGames;
import carom.client.desktop.hud.Hud;
import carom.client.desktop.hud.PlayerColours;
import carom.client.desktop.hud.Readiness;
import carom.client.desktop.hud.ShownGame;
import carom.client.desktop.menu.StartScreen;
import carom.client.link.ConnectionPhase;
import carom.client.settings.PlayerSettings;
import carom.client.stats.NetStats;
import carom.client.view.ClientView;
import carom.game.rockets.RocketGame;
import carom.sim.MatchClock;
import carom.sim.MatchPhase;
import carom.sim.level.Level;
import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.Input.Keys;
import com.badlogic.gdx.InputMultiplexer;
import com.badlogic.gdx.InputProcessor;
import com.badlogic.gdx.Screen;
import com.badlogic.gdx.graphics.Pixmap;
import com.badlogic.gdx.math.Vector3;
import com.badlogic.gdx.scenes.scene2d.Actor;
import com.badlogic.gdx.scenes.scene2d.Group;
import com.badlogic.gdx.scenes.scene2d.Stage;
import com.badlogic.gdx.scenes.scene2d.ui.ScrollPane;
import com.badlogic.gdx.scenes.scene2d.ui.TextButton;
import com.badlogic.gdx.scenes.scene2d.ui.TextField;
import java.awt.Robot;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.lang.reflect.Field;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.function.BooleanSupplier;

/**
 * A program that opens the client's window and goes through its screens, as a player would: start,
 * pages, a game with bots, chat, table, menu, editor; a recording to its end; the pages again in
 * the largest texts. It prints what {@link ScreenCheck} finds wrong with each. One window shows
 * all, because a window takes longer to open than most screens to check.
 */
final class ScreenTour {
  private static final long LIMIT_NS = 100_000_000_000L;

  /** Enough for bodies that glide; each frame costs a processor that draws by itself. */
  private static final int FPS = 10;

  private static final boolean SAVES_ALL = Boolean.getBoolean("carom.all");
  private static final int LARGEST_TEXTS = 200;

  private final Path folder;
  private final Robot robot;
  private String tour = "";
  private int pictures;

  private ScreenTour(Path folder, Robot robot) {
    this.folder = folder;
    this.robot = robot;
  }

  /**
   * Runs the program.
   *
   * @param args folder for pictures; a recording of a whole match; the client's flags
   */
  public static void main(String[] args) {
    Thread guide = new Thread(() -> guide(Path.of(args[0]), Path.of(args[1])), "guide");
    guide.setDaemon(true);
    guide.start();
    String[] flags = new String[args.length - 2];
    System.arraycopy(args, 2, flags, 0, flags.length);
    System.exit(ClientMain.run(flags));
  }

  private static void guide(Path folder, Path recording) {
    try {
      ScreenTour guided = new ScreenTour(folder, new Robot());
      CalmWindow.awaitPictures(FPS);
      guided.begin("menus");
      guided.menus();
      guided.begin("ways");
      guided.ways();
      guided.begin("game");
      guided.game();
      guided.begin("others");
      guided.others();
      guided.begin("edit");
      guided.edit();
      guided.begin("replay");
      guided.replay(recording);
      if (window().settings().get(PlayerSettings.TEXT_SIZE) > 100) {
        run(
            () ->
                window().change(window().settings().with(PlayerSettings.TEXT_SIZE, LARGEST_TEXTS)));
        guided.begin("largest");
        guided.menus();
      }
      guided.begin("");
    } catch (Exception e) {
      System.out.println("problem: " + e);
    }
    Gdx.app.exit();
  }

  /** Begins a part of the tour, and tells how many pictures the one before has. */
  private void begin(String next) {
    if (!tour.isEmpty()) {
      System.out.println("pictures of " + tour + ": " + pictures);
    }
    tour = next;
    pictures = 0;
  }

  private static CaromWindow window() {
    return (CaromWindow) Gdx.app.getApplicationListener();
  }

  private void menus() throws Exception {
    for (String page :
        new String[] {
          "Join a server", "Play here", "Replays", "Edit a level", "Scenes", "Settings"
        }) {
      press(page);
      frames(10); // levels are drawn one by one
      look(page);
      if (page.equals("Scenes") || page.equals("Settings")) {
        scroll(page);
        look(page + " scrolled");
      }
    }
  }

  private void play(String level, int bots) throws Exception {
    run(() -> window().create(new LocalGames.GameChoice(level, bots, false)));
    until(() -> screen() != null && screen().view().phase() == ConnectionPhase.PLAYING);
    until(() -> screen().view().game().equals(level) || level.equals("commons"));
    until(() -> screen().view().own() != null && screen().view().players().size() == bots + 1);
    Thread.sleep(3_000); // the curtain opens
  }

  /** Other games: one player alone far from ball and goals, and one whose players have health. */
  private void others() throws Exception {
    play("commons", 0);
    look("alone in a large level");
    play("rockets", 3);
    look("rockets");
    typed(Keys.ESCAPE);
    press("Leave the game");
    until(() -> window().screen() instanceof StartScreen);
  }

  /** Esc asks, a failed join stays at its address, and nobody needs a key to begin with bots. */
  private void ways() throws Exception {
    press("Join a server");
    typed(Keys.ESCAPE);
    look("quit");
    require(button("Stay") != null, "Esc on the start screen asks");
    typed(Keys.ESCAPE);
    require(button("Join") != null, "Esc again goes back");
    Screen before = window().screen();
    write("party", "no way");
    press("Join");
    look("an unusable party");
    require(window().screen() == before && window().party().isEmpty(), "it is refused");
    write("party", "trio");
    write("address", "127.0.0.1:1");
    press("Join");
    until(() -> window().screen() instanceof StartScreen && window().screen() != before);
    look("failed join");
    boolean atAddress =
        ((Stage) input()).getKeyboardFocus() instanceof TextField field
            && field.getText().equals("127.0.0.1:1");
    require(atAddress, "a failed join leaves the player at the address");
    require(window().settings().get(PlayerSettings.PARTY).equals("trio"), "the party is kept");
    require(button("Play here instead") != null, "it offers to play here");
    play("rockets", 3);
    Set<Integer> colours = new HashSet<>();
    run(
        () ->
            screen()
                .view()
                .players()
                .forEach(p -> colours.add(colours(screen().view()).rgb(p.playerId()))));
    require(colours.size() == 4, "each has a colour of its own: " + colours);
    until(() -> Readiness.waits(screen().view(), new RocketGame().clock()));
    robot.keyPress(KeyEvent.VK_D);
    until(() -> MatchClock.phase(screen().view().match()) != MatchPhase.WARM_UP);
    robot.keyRelease(KeyEvent.VK_D);
    look("rockets begins");
  }

  /** Writes into a field of the page. */
  private void write(String field, String text) throws Exception {
    run(() -> ((TextField) ((Stage) input()).getRoot().findActor(field)).setText(text));
    frames(1);
  }

  private static TextButton button(String text) {
    return find(((Stage) input()).getRoot(), text);
  }

  private static void require(boolean so, String what) {
    if (!so) {
      System.out.println("problem: not so: " + what);
    }
  }

  private void game() throws Exception {
    play("arena", 11);
    look("game");
    typed(Keys.F3);
    typed(Keys.ENTER);
    run(() -> "good game, all of you".chars().forEach(c -> input().keyTyped((char) c)));
    look("chat, hints and net graph");
    typed(Keys.ENTER);
    typed(Keys.F3);
    look("hints and full net graph");
    run(ScreenTour::correctMuch);
    look("full net graph with large figures");
    typed(Keys.F3);
    typed(Keys.F3);
    look("net graph with large figures");
    typed(Keys.F3);
    typed(Keys.F3);
    robot.keyPress(KeyEvent.VK_TAB);
    until(() -> Gdx.input.isKeyPressed(Keys.TAB));
    look("table");
    robot.keyRelease(KeyEvent.VK_TAB);
    until(() -> !Gdx.input.isKeyPressed(Keys.TAB));
    typed(Keys.F2);
    until(() -> !screen().view().rooms().isEmpty());
    look("rooms");
    typed(Keys.F2);
    typed(Keys.ESCAPE);
    look("menu");
    press("Settings");
    look("menu settings");
    scroll("Settings in a game");
  }

  /** Makes the figures of the net graph as large as on a bad line with a slow server. */
  private static void correctMuch() {
    try {
      Field prediction = NetStats.class.getDeclaredField("prediction");
      prediction.setAccessible(true);
      Object stats = prediction.get(screen().view().stats());
      Field count = stats.getClass().getDeclaredField("correctionCount");
      Field metres = stats.getClass().getDeclaredField("correctionMetres");
      count.setAccessible(true);
      metres.setAccessible(true);
      count.setLong(stats, 5_000);
      metres.setDouble(stats, 5_000 * 9.87);
    } catch (ReflectiveOperationException e) {
      throw new LinkageError(e.getMessage(), e);
    }
  }

  /** Places a box and a plate, undoes, saves, plays what isn't saved, and comes back. */
  private void edit() throws Exception {
    run(() -> require(window().edit(Path.of("edited.json")).isEmpty(), "a level is edited"));
    until(() -> window().screen() instanceof EditScreen);
    EditScreen screen = (EditScreen) window().screen();
    frames(3);
    hit(KeyEvent.VK_B);
    drag(screen, 0, 3, 2, 4);
    require(screen.editor().source().list("statics").size() == 4, "a drag places a box");
    look("a box");
    robot.keyPress(KeyEvent.VK_CONTROL);
    hit(KeyEvent.VK_Z);
    require(screen.editor().source().list("statics").size() == 3, "Ctrl+Z takes it back");
    hit(KeyEvent.VK_Y);
    hit(KeyEvent.VK_S);
    robot.keyRelease(KeyEvent.VK_CONTROL);
    until(() -> !Gdx.input.isKeyPressed(Keys.CONTROL_LEFT));
    require(Level.load(Path.of("edited.json")).statics().size() == 4, "Ctrl+S saves what there is");
    hit(KeyEvent.VK_S);
    drag(screen, -12, 0, -10, 0.5f);
    hit(KeyEvent.VK_T);
    require(screen.editor().source().list("triggers").size() == 1, "T makes a trigger");
    look("a trigger");
    hit(KeyEvent.VK_F5);
    until(() -> screen() != null && screen().view().own() != null);
    require(screen().view().level().triggers().size() == 1, "what isn't saved is played");
    until(() -> screen().view().players().size() == 2); // the bot
    hit(KeyEvent.VK_ESCAPE);
    until(() -> window().screen() == screen);
    require(screen.asksToStay(), "closing the window would lose the trigger");
    look("a question");
    press("Leave without saving");
    until(() -> window().screen() instanceof StartScreen);
  }

  /** Presses a key of the keyboard, and waits until the window has taken it. */
  private void hit(int key) throws Exception {
    robot.keyPress(key);
    Thread.sleep(60);
    robot.keyRelease(key);
    Thread.sleep(60);
    frames(3);
  }

  /** Drags the mouse between places of a level, metres. */
  private void drag(EditScreen screen, float fromX, float fromY, float toX, float toY)
      throws Exception {
    move(screen, fromX, fromY);
    robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
    Thread.sleep(60);
    move(screen, (fromX + toX) / 2, (fromY + toY) / 2);
    move(screen, toX, toY);
    robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
    Thread.sleep(60);
    frames(3);
  }

  private void move(EditScreen screen, float x, float y) throws Exception {
    CompletableFuture<int[]> at = new CompletableFuture<>();
    run(
        () -> {
          Vector3 pixel = screen.camera().toScreen(x, y);
          at.complete(new int[] {(int) pixel.x, Gdx.graphics.getHeight() - (int) pixel.y});
        });
    robot.mouseMove(at.get()[0], at.get()[1]);
    Thread.sleep(60);
    frames(2);
  }

  private void replay(Path recording) throws Exception {
    run(() -> require(window().replay(recording).isEmpty(), "a recording is shown"));
    until(() -> window().screen() instanceof ReplayScreen);
    look("replay");
    typed(Keys.END);
    until(() -> ((ReplayScreen) window().screen()).atEnd());
    look("end of the match");
    typed(Keys.ESCAPE);
    until(() -> window().screen() instanceof StartScreen);
  }

  private static GameScreen screen() {
    return window().screen() instanceof GameScreen game ? game : null;
  }

  private static InputProcessor input() {
    return Gdx.input.getInputProcessor();
  }

  private void typed(int key) throws Exception {
    run(() -> input().keyDown(key));
    frames(3);
  }

  private void press(String text) throws Exception {
    run(
        () -> {
          TextButton button = find(stage().getRoot(), text);
          ((Runnable) button.getUserObject()).run();
        });
    frames(3);
  }

  /** Returns the colours of the players of a view. */
  static PlayerColours colours(ClientView view) {
    ShownGame game = new ShownGame();
    game.look(view);
    PlayerColours colours = new PlayerColours(game);
    colours.look(view);
    return colours;
  }

  /** Returns the button with a text, which marks the present page by an arrow, or null. */
  static TextButton find(Actor actor, String text) {
    if (actor instanceof TextButton button) {
      String shown = button.getText().toString();
      return shown.equals(text) || shown.equals("> " + text) ? button : null;
    }
    if (actor instanceof Group group) {
      for (Actor child : group.getChildren()) {
        TextButton found = find(child, text);
        if (found != null) {
          return found;
        }
      }
    }
    return null;
  }

  /** Turns the wheel over a page that is longer than the window, and checks that it moves. */
  private void scroll(String page) throws Exception {
    CompletableFuture<float[]> moved = new CompletableFuture<>();
    run(
        () -> {
          Stage stage = (Stage) input();
          ScrollPane pane = ScreenCheck.pane(stage.getRoot());
          float before = pane.getScrollY();
          stage.scrolled(0, 4);
          moved.complete(new float[] {before, pane.getScrollY(), pane.getMaxY()});
        });
    float[] at = moved.get();
    if (at[2] > 0 && !(at[1] > at[0])) {
      System.out.println("problem: the wheel doesn't scroll " + page + ", which has " + at[2]);
    }
    frames(10);
  }

  /**
   * Draws the screen once more and prints what is wrong with it. Saves it if something is, or all
   * screens are asked for: to write a picture takes longer than to check it.
   */
  private void look(String name) throws Exception {
    frames(2);
    String file = tour + "-" + pictures++ + "-" + name.replaceAll("[^A-Za-z]+", "-") + ".png";
    run(
        () -> {
          ScreenCheck check =
              new ScreenCheck(name, Gdx.graphics.getWidth(), Gdx.graphics.getHeight());
          Stage stage = stage();
          boolean menu = stage != null; // over a game, which it darkens
          Hud hud =
              menu
                  ? null
                  : window().screen() instanceof GameScreen game
                      ? game.hud()
                      : window().screen() instanceof ReplayScreen film ? film.hud() : null;
          if (hud != null) {
            hud.witness(check);
          }
          window().screen().render(0);
          Pixmap pixels =
              Pixmap.createFromFrameBuffer(0, 0, Gdx.graphics.getWidth(), Gdx.graphics.getHeight());
          if (hud != null) {
            hud.witness(null);
            check.hud(hud, window().screen() instanceof GameScreen game ? game : null, pixels);
          }
          if (menu) {
            check.menu(stage, pixels);
          }
          pixels.dispose();
          check.problems().forEach(problem -> System.out.println("problem: " + problem));
          if (SAVES_ALL || !check.problems().isEmpty()) {
            Pictures.save(folder.resolve(file).toString());
          }
        });
  }

  /** Returns the parts of the menu or editor that is shown, or null. */
  private static Stage stage() {
    if (input() instanceof InputMultiplexer several) {
      for (InputProcessor each : several.getProcessors()) {
        if (each instanceof Stage stage) {
          return stage;
        }
      }
    }
    return input() instanceof Stage stage ? stage : null;
  }

  private static void run(Runnable action) throws Exception {
    CompletableFuture<Void> done = new CompletableFuture<>();
    Gdx.app.postRunnable(
        () -> {
          try {
            action.run();
            done.complete(null);
          } catch (RuntimeException e) {
            done.completeExceptionally(e);
          }
        });
    done.get();
  }

  private static void frames(int count) throws InterruptedException {
    long frame = Gdx.graphics.getFrameId();
    while (Gdx.graphics.getFrameId() < frame + count) {
      Thread.sleep(5);
    }
  }

  /** Waits for what is so between two frames; views belong to the render thread. */
  private static void until(BooleanSupplier condition) throws Exception {
    long end = System.nanoTime() + LIMIT_NS;
    boolean[] so = {false};
    while (!so[0]) {
      run(() -> so[0] = condition.getAsBoolean());
      if (System.nanoTime() > end) {
        throw new IllegalStateException("never so after 100 s");
      }
      Thread.sleep(20);
    }
  }
}

package carom.client.desktop;

import carom.client.app.ClientMain;
import carom.client.desktop.game.SceneScreen;
import carom.client.link.ConnectionPhase;
import carom.client.link.RoomBrowser;
import carom.client.link.ServerAddress;
import carom.client.view.ClientView;
import carom.client.view.ClientView.Drawn;
import carom.fixtures.Slice;
import carom.net.protocol.ServerMessage.RoomEntry;
import carom.net.protocol.ServerMessage.RosterEntry;
import carom.physics.math.Aabb;
import carom.physics.math.Transform;
import carom.replay.RecordingReader;
import carom.sim.scene.Scene;
import carom.sim.scene.Scenes;
import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.Screen;
import com.badlogic.gdx.graphics.Pixmap;
import com.badlogic.gdx.math.Vector3;
import com.badlogic.gdx.scenes.scene2d.Stage;
import java.awt.Robot;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;

/**
 * A program that opens the client's window and plays like somebody who tries every key and button:
 * in each room of a server, or as a viewer of rooms, recordings and scenes. It presses them through
 * the display, and prints what it saw: {@code problem} and a sentence when that is wrong.
 */
final class WindowPlayer {
  private static final long LIMIT_NS = 60_000_000_000L;
  private static final int TOLERANCE = 24;

  /** Least part of the box around the own body that has its colour, and least pixels. */
  private static final float LEAST_SHARE = 0.032f;

  private static final int LEAST_PX = 20;

  /** Least number of looks at the own body in a room. */
  private static final int LOOKS = 5;

  /** Keys that the player holds for a moment: moves, shots, emotes, panels. */
  private static final int[] KEYS = {
    KeyEvent.VK_A,
    KeyEvent.VK_D,
    KeyEvent.VK_W,
    KeyEvent.VK_S,
    KeyEvent.VK_LEFT,
    KeyEvent.VK_RIGHT,
    KeyEvent.VK_UP,
    KeyEvent.VK_DOWN,
    KeyEvent.VK_SPACE,
    KeyEvent.VK_E,
    KeyEvent.VK_SHIFT,
    KeyEvent.VK_1,
    KeyEvent.VK_2,
    KeyEvent.VK_3,
    KeyEvent.VK_4,
    KeyEvent.VK_5,
    KeyEvent.VK_6,
    KeyEvent.VK_7,
    KeyEvent.VK_8,
    KeyEvent.VK_TAB,
    KeyEvent.VK_M,
    KeyEvent.VK_F1,
    KeyEvent.VK_F3,
    KeyEvent.VK_F4,
    KeyEvent.VK_F12,
  };

  /** Keys that open something, and what is pressed before the last of them closes it. */
  private static final int[][] SEQUENCES = {
    {KeyEvent.VK_ENTER, KeyEvent.VK_H, KeyEvent.VK_I, KeyEvent.VK_ENTER},
    {KeyEvent.VK_T, KeyEvent.VK_G, KeyEvent.VK_BACK_SPACE, KeyEvent.VK_G, KeyEvent.VK_ENTER},
    {KeyEvent.VK_ENTER, KeyEvent.VK_X, KeyEvent.VK_ESCAPE},
    {KeyEvent.VK_ESCAPE, KeyEvent.VK_DOWN, KeyEvent.VK_UP, KeyEvent.VK_ESCAPE},
    {KeyEvent.VK_F2, KeyEvent.VK_DOWN, KeyEvent.VK_UP, KeyEvent.VK_F2},
    {KeyEvent.VK_M, KeyEvent.VK_M},
  };

  /** Keys that count while the table of players shows. */
  private static final int[] WITH_TABLE = {
    KeyEvent.VK_R, KeyEvent.VK_1, KeyEvent.VK_2, KeyEvent.VK_P,
  };

  private static final int[] BUTTONS = {
    InputEvent.BUTTON1_DOWN_MASK, InputEvent.BUTTON2_DOWN_MASK, InputEvent.BUTTON3_DOWN_MASK,
  };

  private static final int[] FILM_KEYS = {
    KeyEvent.VK_SPACE,
    KeyEvent.VK_PERIOD,
    KeyEvent.VK_PERIOD,
    KeyEvent.VK_SPACE,
    KeyEvent.VK_LEFT,
    KeyEvent.VK_MINUS,
    KeyEvent.VK_EQUALS,
    KeyEvent.VK_RIGHT,
    KeyEvent.VK_TAB,
    KeyEvent.VK_1,
    KeyEvent.VK_2,
    KeyEvent.VK_9,
    KeyEvent.VK_0,
    KeyEvent.VK_M,
    KeyEvent.VK_F4,
    KeyEvent.VK_HOME,
    KeyEvent.VK_F4,
    KeyEvent.VK_END,
  };

  private static final int[] SCENE_KEYS = {
    KeyEvent.VK_SPACE,
    KeyEvent.VK_PERIOD,
    KeyEvent.VK_SPACE,
    KeyEvent.VK_MINUS,
    KeyEvent.VK_EQUALS,
    KeyEvent.VK_R,
    KeyEvent.VK_0,
    KeyEvent.VK_F4,
    KeyEvent.VK_H,
    KeyEvent.VK_1,
    KeyEvent.VK_2,
    KeyEvent.VK_3,
    KeyEvent.VK_4,
    KeyEvent.VK_5,
    KeyEvent.VK_6,
    KeyEvent.VK_7,
    KeyEvent.VK_TAB,
  };

  private final Robot robot;
  private final Random random;

  /** The rest that the numbers of films have in which all keys are pressed. */
  private final int firstFilm;

  private int looks;
  private int seen;

  /** Counts why the picture couldn't be looked at, by reason. */
  private final Map<String, Integer> covers = new TreeMap<>();

  private WindowPlayer(Robot robot, long seed) {
    this.robot = robot;
    random = new Random(seed);
    firstFilm = random.nextInt(2);
  }

  /**
   * Runs the program.
   *
   * @param args {@code play}, the rooms, separated by commas, and the seconds in each, or {@code
   *     view}, a folder of recordings and the number of scenes; the server's TCP port; a seed; the
   *     client's flags
   */
  public static void main(String[] args) {
    Thread player = new Thread(() -> play(args), "player");
    player.setDaemon(true);
    player.start();
    System.exit(ClientMain.run(List.of(args).subList(5, args.length).toArray(new String[0])));
  }

  private static void play(String[] args) {
    try {
      WindowPlayer player = new WindowPlayer(new Robot(), Long.parseLong(args[4]));
      CalmWindow.awaitPictures(12); // a key that is let go between two frames counts, too
      if (args[0].equals("play")) {
        player.playRooms(List.of(args[1].split(",")), Double.parseDouble(args[2]));
      } else {
        ServerAddress server = ServerAddress.parse("localhost:" + args[3]);
        player.viewRooms(server);
        player.viewRecordings(Path.of(args[1]));
        player.viewScenes(Integer.parseInt(args[2]));
      }
      System.out.println("done");
    } catch (Exception e) {
      System.out.println("problem: " + e);
      e.printStackTrace(System.out);
    }
    Gdx.app.exit();
  }

  // ---- a player

  private void playRooms(List<String> rooms, double seconds) throws Exception {
    awaitBody();
    long before = 0;
    for (String room : rooms) {
      goTo(room);
      looks = 0;
      seen = 0;
      covers.clear();
      pressForSeconds(seconds);
      awaitBody();
      System.out.printf(
          Locale.ROOT,
          "room %s looks %d seen %d else %s heap %d MB%n",
          room,
          looks,
          seen,
          covers,
          heapMb());
      if (looks < LOOKS || seen < 0.6 * looks) {
        System.out.println(
            "problem: in room " + room + " the own body is seen " + seen + " of " + looks);
      }
      before = before == 0 ? heapMb() : before;
    }
    goTo(rooms.get(0));
    System.out.println("heap before " + before + " after " + heapMb());
  }

  /** Chooses a room from the list, as a player does. */
  private void goTo(String room) throws Exception {
    boolean[] there = {false};
    run(() -> there[0] = view().room().equals(room));
    for (int attempt = 0; !there[0] && attempt < 4; attempt++) {
      tap(KeyEvent.VK_F2);
      until("the rooms are listed", () -> !view().rooms().isEmpty());
      Thread.sleep(300); // the newest list is there, and the present room is marked
      int[] steps = {0};
      run(() -> steps[0] = view().rooms().stream().map(RoomEntry::name).toList().indexOf(room));
      for (int i = 0; i < steps[0]; i++) {
        tap(KeyEvent.VK_DOWN);
      }
      tap(KeyEvent.VK_ENTER);
      long end = System.nanoTime() + 5_000_000_000L;
      while (!there[0] && System.nanoTime() < end) {
        Thread.sleep(50);
        run(() -> there[0] = view().room().equals(room));
      }
    }
    if (!there[0]) {
      System.out.println("problem: the list of rooms doesn't lead to " + room);
    }
    awaitBody();
  }

  private void awaitBody() throws Exception {
    until(
        "the own body is there",
        () ->
            screen() instanceof GameScreen
                && view().phase() == ConnectionPhase.PLAYING
                && (view().own() != null || isSpectator() || view().watchedPlayer() >= 0));
  }

  private boolean isSpectator() {
    RosterEntry own = view().participant(view().playerId());
    return own != null && own.spectator();
  }

  private void pressForSeconds(double seconds) throws Exception {
    long end = System.nanoTime() + (long) (seconds * 1e9);
    List<Runnable> acts = acts();
    Collections.shuffle(acts, random);
    int next = 0;
    while (next < acts.size() || System.nanoTime() < end) {
      closeMenu();
      acts.get(next++ % acts.size()).run();
      aim();
      if (next % 3 == 0) {
        look();
      }
      if (next % 6 == 0) {
        playAgain();
      }
      if (!(screen() instanceof GameScreen)) {
        throw new IllegalStateException("the game ended: " + screen());
      }
    }
    robot.mouseMove(640, 60);
    lookSometimes();
  }

  /** Looks until the own body was there often enough, which players who watch or are out lack. */
  private void lookSometimes() throws Exception {
    long end = System.nanoTime() + LIMIT_NS / 3;
    while (looks < LOOKS && System.nanoTime() < end) {
      closeMenu();
      playAgain();
      Thread.sleep(400);
      look();
    }
  }

  /**
   * Closes a menu that a key opened at the moment of a new match, which closed the one before: the
   * next click could otherwise be one on "quit".
   */
  private void closeMenu() throws Exception {
    long end = System.nanoTime() + LIMIT_NS / 3;
    while (holds(WindowPlayer::isMenuOpen) && System.nanoTime() < end) {
      tap(KeyEvent.VK_ESCAPE);
      Thread.sleep(300);
    }
  }

  private static boolean isMenuOpen() {
    return Gdx.input.getInputProcessor() instanceof Stage;
  }

  /** Asks for a seat again if the player watches, and waits for it a while. */
  private void playAgain() throws Exception {
    if (holds(this::isSpectator)) {
      withTable(KeyEvent.VK_P);
      long end = System.nanoTime() + 3_000_000_000L;
      while (holds(this::isSpectator) && System.nanoTime() < end) {
        Thread.sleep(50);
      }
    }
  }

  private List<Runnable> acts() {
    List<Runnable> acts = new ArrayList<>();
    for (int key : KEYS) {
      acts.add(() -> hold(key));
    }
    for (int[] sequence : SEQUENCES) {
      acts.add(() -> tap(sequence));
    }
    for (int button : BUTTONS) {
      acts.add(() -> click(button));
      acts.add(() -> click(button));
    }
    acts.add(() -> robot.mouseWheel(random.nextBoolean() ? 2 : -2));
    acts.add(() -> withTable(WITH_TABLE));
    return acts;
  }

  private void withTable(int... keys) {
    robot.keyPress(KeyEvent.VK_TAB);
    robot.delay(60);
    tap(keys);
    robot.keyRelease(KeyEvent.VK_TAB);
  }

  private void aim() {
    robot.mouseMove(100 + random.nextInt(1_080), 100 + random.nextInt(520));
  }

  private void hold(int key) {
    robot.keyPress(key);
    robot.delay(40 + random.nextInt(160));
    robot.keyRelease(key);
    robot.delay(20);
  }

  private void click(int button) {
    robot.mousePress(button);
    robot.delay(40 + random.nextInt(160));
    robot.mouseRelease(button);
    robot.delay(20);
  }

  private void tap(int... keys) {
    for (int key : keys) {
      robot.keyPress(key);
      robot.delay(35);
      robot.keyRelease(key);
      robot.delay(35);
    }
  }

  /** Looks for the own body's colour where its shapes are, unless something covers the picture. */
  private void look() throws Exception {
    run(
        () -> {
          if (!(screen() instanceof GameScreen game)) {
            return;
          }
          game.render(0);
          ClientView view = game.view();
          Drawn own = view.own();
          String cover = cover(game, own);
          if (cover != null) {
            covers.merge(cover, 1, Integer::sum);
            return;
          }
          int chosen = ScreenTour.colours(view).rgb(view.playerId());
          int rgb = own.archetype().appearance().rgb();
          Aabb box = box(own);
          Vector3 at = game.camera().toScreen((box.minX + box.maxX) / 2, (box.minY + box.maxY) / 2);
          int w = Gdx.graphics.getWidth();
          int h = Gdx.graphics.getHeight();
          Pixmap pixels = Pixmap.createFromFrameBuffer(0, 0, w, h);
          float scale = game.camera().pixelsPerMetre(h);
          int halfW = Math.max(1, Math.round(scale * (box.maxX - box.minX) / 2));
          int halfH = Math.max(1, Math.round(scale * (box.maxY - box.minY) / 2));
          int count = 0;
          int white = 0;
          for (int dy = -halfH; dy <= halfH; dy++) {
            for (int dx = -halfW; dx <= halfW; dx++) {
              int x = Math.round(at.x) + dx;
              int y = Math.round(at.y) + dy;
              if (x >= 0 && y >= 0 && x < w && y < h) {
                int pixel = pixels.getPixel(x, y) >>> 8;
                count += near(pixel, rgb) || (chosen >= 0 && near(pixel, chosen)) ? 1 : 0;
                white += near(pixel, 0xffffff) ? 1 : 0;
              }
            }
          }
          pixels.dispose();
          int least = Math.max(LEAST_PX, Math.round(LEAST_SHARE * 4 * halfW * halfH));
          if (count < least && white >= least) {
            covers.merge("white of a blow", 1, Integer::sum); // for a moment
            return;
          }
          looks++;
          seen += count >= least ? 1 : 0;
          if (count < least) {
            Pictures.save("unseen-" + looks + ".png");
          }
        });
  }

  /** Returns why the own body can't be looked for, or null if it must be seen. */
  private String cover(GameScreen game, Drawn own) {
    if (isMenuOpen()) {
      return "menu";
    }
    if (game.isCovered()) {
      return "covered";
    }
    if (own == null) {
      return isSpectator() ? "watches" : "out";
    }
    return own.alpha() < 1 ? "fades" : null;
  }

  /** Returns the box around a body's shapes as it is turned, metres. */
  private static Aabb box(Drawn body) {
    Transform pose = new Transform().set(body.x(), body.y(), body.angle());
    Aabb all = new Aabb();
    Aabb one = new Aabb();
    for (int i = 0; i < body.archetype().shapes().size(); i++) {
      body.archetype().shapes().get(i).aabb(pose, i == 0 ? all : one);
      if (i > 0) {
        all.add(one.minX, one.minY);
        all.add(one.maxX, one.maxY);
      }
    }
    return all;
  }

  private static boolean near(int a, int b) {
    for (int shift = 0; shift < 24; shift += 8) {
      if (Math.abs((a >> shift & 0xff) - (b >> shift & 0xff)) > TOLERANCE) {
        return false;
      }
    }
    return true;
  }

  private static long heapMb() {
    System.gc();
    Runtime runtime = Runtime.getRuntime();
    return (runtime.totalMemory() - runtime.freeMemory()) >> 20;
  }

  // ---- a viewer

  private void viewRooms(ServerAddress server) throws Exception {
    RoomBrowser[] browser = {null};
    run(() -> browser[0] = window().browse(server));
    until(
        "the server tells its rooms",
        () -> {
          browser[0].update(System.nanoTime());
          return browser[0].isDone();
        });
    for (int i = 0; i < browser[0].rooms().size(); i++) {
      int number = i + 1;
      run(() -> window().watch(server, number));
      until("room " + number + " is watched", () -> screen() instanceof ReplayScreen);
      film("watching room " + number, number);
    }
    run(browser[0]::close);
  }

  private void viewRecordings(Path folder) throws Exception {
    List<Path> files;
    try (Stream<Path> found = Files.walk(folder)) {
      files = found.filter(file -> file.toString().endsWith(".carom")).sorted().toList();
    }
    if (files.isEmpty()) {
      System.out.println("problem: no recordings in " + folder);
    }
    Set<String> games = new HashSet<>();
    for (Path file : files) {
      try (RecordingReader reader = RecordingReader.open(file)) {
        if (!games.add(reader.header().game())) {
          continue;
        }
      }
      CompletableFuture<String> problem = new CompletableFuture<>();
      run(() -> problem.complete(window().replay(file)));
      if (!problem.get().isEmpty()) {
        System.out.println("problem: " + file + ": " + problem.get());
        continue;
      }
      until("the recording is shown", () -> screen() instanceof ReplayScreen);
      film("replay of " + file.getFileName(), games.size());
      boolean[] back = {false};
      run(
          () -> {
            Stage menu = (Stage) Gdx.input.getInputProcessor();
            window().screen().render(0);
            back[0] = ScreenTour.find(menu.getRoot(), "> Replays") != null;
          });
      if (!back[0]) {
        System.out.println("problem: leaving a replay doesn't lead to the replays");
      }
    }
    System.out.println("replays " + games);
  }

  /** Presses all keys of a film in every second one, as all have the same screen. */
  private void film(String what, int number) throws Exception {
    boolean all = Slice.WHOLE || number % 2 == firstFilm;
    for (int key : all ? FILM_KEYS : new int[] {KeyEvent.VK_SPACE, KeyEvent.VK_F4}) {
      hold(key);
    }
    for (int i = 0; i < (all ? 4 : 1); i++) {
      robot.mouseMove(200 + 250 * i, 700 - 10 * i);
      click(InputEvent.BUTTON1_DOWN_MASK);
    }
    lookAtColours(what);
    leave();
  }

  private void leave() throws Exception {
    tap(KeyEvent.VK_ESCAPE);
    until(
        "Esc leaves", () -> !(screen() instanceof ReplayScreen || screen() instanceof SceneScreen));
  }

  private void viewScenes(int count) throws Exception {
    Set<String> all = new HashSet<>();
    List<Scene> scenes = new ArrayList<>(Scenes.all());
    Collections.shuffle(scenes, random);
    for (Scene scene : scenes.subList(0, Math.min(count, scenes.size()))) {
      all.add(scene.name());
      run(() -> window().scene(scene));
      until("scene " + scene.name(), () -> screen() instanceof SceneScreen);
      tap(SCENE_KEYS[random.nextInt(SCENE_KEYS.length)]);
      lookAtColours("scene " + scene.name());
      if (all.size() == 1) {
        for (int key : SCENE_KEYS) {
          hold(key);
        }
        robot.mouseMove(640, 500);
        click(InputEvent.BUTTON1_DOWN_MASK);
        click(InputEvent.BUTTON3_DOWN_MASK);
        robot.mouseWheel(3);
      }
      leave();
    }
    System.out.println("scenes " + all.size());
  }

  /** Requires that the picture isn't bare. */
  private static void lookAtColours(String what) throws Exception {
    run(
        () -> {
          int w = Gdx.graphics.getWidth();
          int h = Gdx.graphics.getHeight();
          window().screen().render(0);
          Pixmap pixels = Pixmap.createFromFrameBuffer(0, 0, w, h);
          Set<Integer> colours = new HashSet<>();
          for (int y = 0; y < h; y += 4) {
            for (int x = 0; x < w; x += 4) {
              colours.add(pixels.getPixel(x, y));
            }
          }
          pixels.dispose();
          if (colours.size() < 20) {
            System.out.println("problem: " + what + " shows " + colours.size() + " colours");
          }
        });
  }

  // ---- the window

  private static CaromWindow window() {
    return (CaromWindow) Gdx.app.getApplicationListener();
  }

  private static Screen screen() {
    return window().screen();
  }

  private static ClientView view() {
    return ((GameScreen) screen()).view();
  }

  private static void run(Runnable action) throws Exception {
    CompletableFuture<Void> done = new CompletableFuture<>();
    Gdx.app.postRunnable(
        () -> {
          try {
            action.run();
            done.complete(null);
          } catch (RuntimeException | Error e) {
            done.completeExceptionally(e);
          }
        });
    done.get();
  }

  /** Returns whether something is so between two frames; views belong to the render thread. */
  private static boolean holds(BooleanSupplier condition) throws Exception {
    boolean[] so = {false};
    run(() -> so[0] = condition.getAsBoolean());
    return so[0];
  }

  /** Waits for what is so between two frames. */
  private static void until(String what, BooleanSupplier condition) throws Exception {
    long end = System.nanoTime() + LIMIT_NS;
    while (!holds(condition)) {
      if (System.nanoTime() > end) {
        throw new IllegalStateException("never so: " + what + ", on " + screen());
      }
      Thread.sleep(20);
    }
  }
}

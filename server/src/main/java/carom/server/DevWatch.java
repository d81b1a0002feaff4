package carom.server;

import carom.game.GameJars;
import carom.game.Games;
import carom.game.JarWatch;
import carom.server.config.DataFolder;
import carom.server.match.MatchInfo;
import carom.server.match.MatchLibrary;
import carom.server.room.Room;
import carom.sim.level.LevelException;
import carom.text.FileErrors;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Plays matches anew whose level file or game has changed on the disk: for {@code --dev}. Players
 * and links stay, as with the commands {@code level} and {@code game}. It looks twice a second, on
 * a thread of its own, and acts when a file was the same twice, so that it reads none that is half
 * written.
 */
final class DevWatch implements Runnable {
  private static final Logger LOG = LoggerFactory.getLogger(DevWatch.class);
  private static final int PERIOD_MS = 500;

  /** A level file that rooms may play. */
  private static final class Watched {
    private String seen;
    private String taken;
    private long contentHash;
  }

  private final List<Room> rooms;
  private final DataFolder data;
  private final MatchLibrary library;
  private final Map<String, Watched> levels = new TreeMap<>();
  private final JarWatch jars = new JarWatch();

  private DevWatch(List<Room> rooms, DataFolder data, MatchLibrary library) {
    this.rooms = rooms;
    this.data = data;
    this.library = library;
  }

  /** Starts the thread. */
  static void start(List<Room> rooms, DataFolder data) {
    DevWatch watch = new DevWatch(rooms, data, MatchLibrary.in(data, MatchLibrary.INSTALLED));
    watch.look(); // so that no change is missed
    Thread thread = new Thread(watch, "carom-dev");
    thread.setDaemon(true);
    thread.start();
  }

  @Override
  public void run() {
    try {
      while (true) {
        Thread.sleep(PERIOD_MS);
        look();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void look() {
    if (haveJarsChanged()) {
      LOG.info("dev: the jars of games have changed");
      rooms.forEach(this::playNewCode);
    }
    TreeSet<String> names = new TreeSet<>(data.levelNames());
    rooms.forEach(room -> names.addAll(room.settings().levels()));
    for (String name : names) {
      lookAt(name);
    }
  }

  private boolean haveJarsChanged() {
    try {
      return jars.look();
    } catch (IOException e) {
      LOG.warn("dev: the jars of games can't be read anew: {}", FileErrors.reason(e));
      return false;
    }
  }

  /** Plays a room's game anew if the folder of games has it. */
  private void playNewCode(Room room) {
    MatchInfo match = room.match();
    try {
      if (Games.create(match.game()).getClass().getClassLoader() != GameJars.loader()) {
        return;
      }
    } catch (IllegalArgumentException e) {
      LOG.warn("dev: {}; room {} goes on with the old code", e.getMessage(), room.name());
      return;
    }
    String level = "";
    for (Map.Entry<String, Watched> watched : levels.entrySet()) {
      if (watched.getValue().contentHash == match.level().contentHash()) {
        level = watched.getKey();
      }
    }
    LOG.info("dev: room {}: {}", room.name(), room.operator().change(match.game(), level));
  }

  private void lookAt(String name) {
    String now = state(data.level(name));
    if (now.isEmpty()) {
      return; // no file, or between being removed and written
    }
    Watched level = levels.computeIfAbsent(name, n -> new Watched());
    boolean isFirst = level.seen == null;
    boolean isSettled = isFirst || now.equals(level.seen);
    level.seen = now;
    if (!isSettled || now.equals(level.taken)) {
      return;
    }
    level.taken = now;
    try {
      long before = level.contentHash;
      long hash = library.level(name).contentHash();
      level.contentHash = hash;
      for (Room room : rooms) {
        if (!isFirst && hash != before && room.match().level().contentHash() == before) {
          LOG.info("dev: room {}: {}", room.name(), room.operator().change("", name));
        }
      }
    } catch (LevelException e) {
      LOG.warn("dev: the level has changed and can't be played: {}", e.getMessage());
    }
  }

  /**
   * Returns size and time of a level file, and of tilesets beside a map; empty if it isn't there.
   */
  private static String state(String name) {
    try {
      Path file = Path.of(name);
      if (!Files.isRegularFile(file)) {
        return "";
      }
      StringBuilder state = new StringBuilder(of(file));
      String ending = name.substring(name.lastIndexOf('.') + 1);
      if (ending.equals("tmx") || ending.equals("tmj")) {
        try (Stream<Path> beside = Files.list(file.toAbsolutePath().getParent())) {
          for (Path other : beside.filter(DevWatch::isTileset).sorted().toList()) {
            state.append(of(other));
          }
        }
      }
      return state.toString();
    } catch (InvalidPathException e) {
      return "";
    } catch (IOException e) {
      LOG.debug("dev: {}: {}", name, FileErrors.reason(e));
      return "";
    }
  }

  private static boolean isTileset(Path file) {
    String name = file.toString();
    return name.endsWith(".tsx") || name.endsWith(".tsj");
  }

  private static String of(Path file) throws IOException {
    return file + " " + Files.size(file) + " " + Files.getLastModifiedTime(file) + "\n";
  }
}

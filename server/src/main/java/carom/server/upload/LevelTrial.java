package carom.server.upload;

import carom.game.GameFault;
import carom.game.GameJars;
import carom.game.Games;
import carom.net.protocol.ProtocolLimits;
import carom.physics.math.SimRandom;
import carom.server.level.LevelCheck;
import carom.server.match.MatchLibrary;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.entity.HostPlayer;
import carom.sim.level.CheckedLevel;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import carom.sim.level.LevelTrigger;
import carom.sim.level.LevelTrigger.Action;
import carom.sim.level.LevelTrigger.Verb;
import carom.sim.pool.PoolDef;
import java.io.IOException;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * The program that judges a level of a player, in a process of its own: its heap is bounded, and it
 * can be ended whatever the level makes the game do. It reads the file from standard input, and
 * writes a verdict of a few lines.
 */
final class LevelTrial {
  /** First line of the verdict on a level that can be played; game and name follow. */
  static final String GOOD = "good";

  /** First line of the verdict on another one; what is wrong follows. */
  static final String BAD = "bad";

  static final int MAX_STATICS = 2_048;
  static final int MAX_BODIES = 512;
  static final int MAX_JOINTS = 256;
  static final int MAX_TRIGGERS = 128;
  static final int MAX_PARTICLES = 2_048;

  /** Ticks for which two players play, after those of {@link LevelCheck}. */
  private static final int TICKS = 300;

  /** Ticks before the first that is timed. */
  private static final int WARM = 120;

  private static final int TICK_RATE = 60;
  private static final int PLAYERS = 2;

  /** Longest time of a tick on average, as the processor counts, ms: half of a tick's. */
  private static final double MAX_TICK_MS = 8;

  private static final int MOST_PROBLEMS = 3;
  private static final String FILE = "level";

  private LevelTrial() {}

  /**
   * Runs the program.
   *
   * @param args a folder with jars of games, or nothing
   */
  public static void main(String[] args) throws IOException {
    if (args.length > 0) {
      GameJars.open(Path.of(args[0]));
    }
    byte[] json = System.in.readNBytes(ProtocolLimits.MAX_OFFERED_BYTES + 1);
    PrintStream out = new PrintStream(System.out, true, StandardCharsets.UTF_8);
    CheckedLevel checked = CheckedLevel.of(FILE, json);
    List<String> problems = problems(checked, json);
    if (problems.isEmpty()) {
      out.println(GOOD);
      out.println(checked.level().gameName());
      out.println(checked.level().name());
    } else {
      out.println(BAD);
      problems.stream().limit(MOST_PROBLEMS).forEach(out::println);
    }
  }

  private static List<String> problems(CheckedLevel checked, byte[] json) {
    Level level = checked.level();
    if (level == null) {
      return checked.problems().stream().map(LevelException::getMessage).toList();
    }
    List<String> problems = new ArrayList<>();
    most(problems, "statics", level.statics().size(), MAX_STATICS);
    most(problems, "bodies", level.bodies().size(), MAX_BODIES);
    most(problems, "joints", level.joints().size(), MAX_JOINTS);
    most(problems, "triggers", level.triggers().size(), MAX_TRIGGERS);
    int particles = level.pools().stream().mapToInt(PoolDef::most).sum();
    most(problems, "particles of pools", particles, MAX_PARTICLES);
    String name = UploadedLevel.problemOf(level.name());
    if (name != null) {
      problems.add(name);
    }
    level.triggers().forEach(trigger -> next(problems, trigger));
    if (problems.isEmpty()) {
      problems.addAll(LevelCheck.of(FILE, json).problems());
    }
    if (problems.isEmpty()) {
      play(problems, level);
    }
    return problems;
  }

  private static void most(List<String> problems, String what, int count, int most) {
    if (count > most) {
      problems.add("it has " + what + "=" + count + ", the limit for levels of players is " + most);
    }
  }

  /** Refuses the way to a file of the server. */
  private static void next(List<String> problems, LevelTrigger trigger) {
    for (List<Action> actions : List.of(trigger.then(), trigger.otherwise())) {
      for (Action action : actions) {
        boolean known =
            action.verb() != Verb.NEXT
                || MatchLibrary.builtInLevels().contains(action.name())
                || action.name().startsWith(UploadedLevel.PREFIX);
        if (!known) {
          problems.add(
              "a trigger has \"next\": \"%s\"; name a level that comes with the program, or %sNAME"
                  .formatted(action.name(), UploadedLevel.PREFIX));
        }
      }
    }
  }

  /** Lets players try every key, and times the ticks. */
  private static void play(List<String> problems, Level level) {
    SimulationHost s =
        new SimulationHost(Games.create(level.gameName()), level, 1, TICK_RATE, Role.AUTHORITY);
    ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    SimRandom random = new SimRandom(1);
    List<HostPlayer> players = new ArrayList<>();
    long begin = 0;
    try {
      for (int i = 0; i < PLAYERS; i++) {
        players.add(s.join("Player " + (i + 1)));
      }
      for (int tick = 0; tick < TICKS; tick++) {
        begin = tick == WARM ? threads.getCurrentThreadCpuTime() : begin;
        for (HostPlayer player : players) {
          if (tick % 10 == 0) {
            player.input().buttons((int) (random.nextLong() >>> 59));
            player.input().move((random.nextLong() >> 62) / 2f, (random.nextLong() >> 62) / 2f);
          }
        }
        s.step();
      }
    } catch (RuntimeException | LinkageError | AssertionError | StackOverflowError e) {
      problems.add("tick " + s.tick() + " with players fails: " + GameFault.describe(e));
      return;
    }
    double ms = (threads.getCurrentThreadCpuTime() - begin) / 1e6 / (TICKS - WARM);
    if (ms > MAX_TICK_MS) {
      problems.add(
          String.format(
              Locale.ROOT,
              "a tick takes %.1f ms, the limit for levels of players is %.0f ms; use fewer bodies"
                  + " that touch",
              ms,
              MAX_TICK_MS));
    }
  }
}

package carom.game.platformer;

import static carom.game.platformer.PlatformerFields.BEST_LENGTH;
import static carom.game.platformer.PlatformerFields.BEST_PATH;
import static carom.game.platformer.PlatformerFields.BEST_RUN;
import static carom.game.platformer.PlatformerFields.BEST_RUNNER;
import static carom.game.platformer.PlatformerFields.MAX_SAMPLES;
import static carom.game.platformer.PlatformerFields.OWN_BEST;
import static carom.game.platformer.PlatformerFields.PATH;
import static carom.game.platformer.PlatformerFields.READY;
import static carom.game.platformer.PlatformerFields.RUN;

import carom.sim.Match;
import carom.sim.Simulation;
import carom.sim.entity.Player;
import carom.sim.level.Level;
import java.util.Locale;

/**
 * Runs from the start to the goal, their best times, and the path of the best one. A path has
 * {@value #SAMPLES_PER_SECOND} places a second, of {@value #BITS} bits for each direction.
 */
public final class Runs {
  /** Places of a path in a second. */
  public static final int SAMPLES_PER_SECOND = 3;

  /** Longest run, seconds. */
  public static final float LIMIT_SECONDS = 300;

  private static final int BITS = 15;
  private static final int MOST = (1 << BITS) - 1;

  /** Greatest place of a path. */
  static final int MAX_POINT = (MOST << BITS) | MOST;

  private final Course course;

  Runs(Course course) {
    this.course = course;
  }

  /** Remembers the best time of a player who joins. */
  void join(Player p) {
    if (course.best != null) {
      p.set(OWN_BEST, p.get(course.best));
    }
  }

  /** Begins a player's run as it leaves the start; both roles. */
  void begin(Simulation s, Player p) {
    if (course.start == null) {
      return;
    }
    if (course.start.contains(p.entity().x(), p.entity().y())) {
      p.set(READY, true);
      p.set(RUN, 0);
    } else if (p.get(READY)) {
      p.set(READY, false);
      p.set(RUN, s.ticks(LIMIT_SECONDS));
    }
  }

  /** Notes where a player is in its run, some times a second. */
  void note(Match m, Player p) {
    int ticks = m.ticks(LIMIT_SECONDS) - p.get(RUN);
    int every = m.tickRate() / SAMPLES_PER_SECOND;
    int sample = ticks / every;
    if (p.get(RUN) > 0 && p.isAlive() && ticks % every == 0 && sample < MAX_SAMPLES) {
      Level.Bounds b = m.level().bounds();
      int x = part((p.entity().x() - b.minX()) / (b.maxX() - b.minX()));
      int y = part((p.entity().y() - b.minY()) / (b.maxY() - b.minY()));
      p.set(PATH, sample, (x << BITS) | y);
    }
  }

  private static int part(float share) {
    return Math.max(0, Math.min(MOST, Math.round(share * MOST)));
  }

  /** Returns the x of a place of a path, metres. */
  public static float x(int point, Level.Bounds b) {
    return b.minX() + (point >> BITS) * (b.maxX() - b.minX()) / MOST;
  }

  /** Returns the y of a place of a path, metres. */
  public static float y(int point, Level.Bounds b) {
    return b.minY() + (point & MOST) * (b.maxY() - b.minY()) / MOST;
  }

  /** Returns whether a player has come to the goal of its run. */
  boolean isDone(Player p) {
    return p.get(RUN) > 0 && course.goal.contains(p.entity().x(), p.entity().y());
  }

  /** Ends a player's run: notes its time, and tells it. */
  void finish(Match m, Player p) {
    int ticks = m.ticks(LIMIT_SECONDS) - p.get(RUN);
    int ms = (int) (ticks * 1_000L / m.tickRate());
    int record = m.get(BEST_RUN);
    int own = p.get(OWN_BEST);
    boolean isRecord = record == 0 || ms < record;
    boolean isOwnBest = own == 0 || ms < own;
    if (isOwnBest) {
      p.set(OWN_BEST, ms);
      if (course.best != null) {
        p.set(course.best, ms);
      }
    }
    if (isRecord) {
      int samples = ticks / (m.tickRate() / SAMPLES_PER_SECOND) + 1;
      m.set(BEST_RUN, ms);
      m.set(BEST_RUNNER, p);
      m.set(BEST_LENGTH, samples > MAX_SAMPLES ? 0 : samples);
      for (int i = 0; i < samples && samples <= MAX_SAMPLES; i++) {
        m.set(BEST_PATH, i, p.get(PATH, i));
      }
    }
    p.set(RUN, 0);
    String best =
        isRecord && record > 0
            ? ", " + seconds(record - ms) + " faster than anyone here"
            : isOwnBest && own > 0 ? ", " + seconds(own - ms) + " faster than ever" : "";
    m.notice(m.name(p) + " is at the goal in " + seconds(ms) + best);
    m.emit(isRecord || isOwnBest ? course.bestEvent : course.goalEvent)
        .at(p.entity().x(), p.entity().y())
        .of(p.entity())
        .by(p);
  }

  private static String seconds(int ms) {
    return String.format(Locale.ROOT, "%.2f s", ms / 1_000f);
  }
}

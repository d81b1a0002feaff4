package carom.server.level;

import carom.game.GameFault;
import carom.game.Games;
import carom.physics.BodyType;
import carom.physics.math.Aabb;
import carom.physics.math.Transform;
import carom.sim.Game;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.level.Archetype;
import carom.sim.level.Archetypes;
import carom.sim.level.CheckedLevel;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import carom.sim.level.LevelTrigger;
import carom.sim.level.LevelTrigger.Action;
import carom.sim.level.LevelTrigger.Cause;
import carom.sim.level.LevelTrigger.Condition;
import carom.sim.level.LevelTrigger.Verb;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * A judgement on a level: problems, with which it can't be played, and warnings, of what is legal
 * and surely not meant. It is read, built with its game, and stepped for two seconds without
 * players.
 */
public final class LevelCheck {
  private static final int TICK_RATE = 60;
  private static final int TICKS = 2 * TICK_RATE;

  /** Most warnings; a level that is wrong in one place a thousand times says it a few times. */
  private static final int MOST = 50;

  /** Depth from which an overlap at the start is a mistake, metres. */
  private static final float DEEP = 0.05f;

  private final CheckedLevel file;
  private final List<String> problems = new ArrayList<>();
  private final List<String> warnings = new ArrayList<>();

  private LevelCheck(CheckedLevel file) {
    this.file = file;
    for (LevelException problem : file.problems()) {
      problems.add(problem.getMessage());
    }
  }

  /**
   * Checks a level.
   *
   * @param fileName begins the messages
   * @param json the bytes of the file
   */
  public static LevelCheck of(String fileName, byte[] json) {
    LevelCheck check = new LevelCheck(CheckedLevel.of(fileName, json));
    if (check.file.level() != null) {
      check.play(fileName);
    }
    return check;
  }

  /** Returns why the level can't be played, with file, line, column and path; empty if it can. */
  public List<String> problems() {
    return List.copyOf(problems);
  }

  /** Returns what is surely not meant, in the same form. */
  public List<String> warnings() {
    return List.copyOf(warnings);
  }

  private void play(String fileName) {
    Level level = file.level();
    SimulationHost simulation;
    Class<?> type = Game.class;
    try {
      Game game = Games.create(level.gameName());
      type = game.getClass();
      simulation = new SimulationHost(game, level, 1, TICK_RATE, Role.AUTHORITY);
    } catch (IllegalArgumentException e) {
      String message = GameFault.refusal(type, e);
      problems.add(message.startsWith(fileName) ? message : fileName + ": " + message);
      return;
    } catch (RuntimeException | LinkageError | AssertionError | StackOverflowError e) {
      problems.add(fileName + ": the game's set-up fails: " + GameFault.describe(e));
      return;
    }
    spawns(simulation);
    triggers();
    bodiesAtTheStart(simulation);
    step(fileName, simulation);
  }

  private void warn(LevelException warning) {
    if (warnings.size() < MOST) {
      warnings.add(warning.getMessage());
    }
  }

  private void spawns(SimulationHost simulation) {
    List<Level.Spawn> spawns = file.level().spawns();
    for (int i = 0; i < spawns.size(); i++) {
      int index = i;
      Level.Spawn spawn = spawns.get(i);
      simulation
          .world()
          .queries()
          .containing(
              spawn.x(),
              spawn.y(),
              null,
              hit -> {
                boolean isWall = hit.body().type() == BodyType.STATIC;
                if (isWall) {
                  warn(
                      file.remark(
                          "spawns",
                          index,
                          ".at=%s is inside %s; move it out"
                              .formatted(point(spawn.x(), spawn.y()), title(hit.body().user()))));
                }
                return !isWall;
              });
    }
  }

  private void bodiesAtTheStart(SimulationHost simulation) {
    Level level = file.level();
    Level.Bounds bounds = level.bounds();
    for (int id = 0; id < level.bodies().size(); id++) {
      Level.Placement placed = level.bodies().get(id);
      HostEntity entity = simulation.entity(id);
      if (entity == null || !entity.isDynamic()) {
        continue; // the game has taken it, or moves it
      }
      if (!bounds.contains(placed.x(), placed.y())) {
        warn(
            file.remark(
                placed,
                " begins at %s, outside the bounds %s; move it, or widen the bounds"
                    .formatted(point(placed.x(), placed.y()), text(bounds))));
      } else if (!entity.archetype().sensor()) {
        overlaps(simulation, placed, entity);
      }
    }
  }

  private void overlaps(SimulationHost simulation, Level.Placement placed, HostEntity entity) {
    DeepOverlap overlap = new DeepOverlap(simulation.world(), entity.body());
    HostEntity other = overlap.find(DEEP);
    if (other != null) {
      warn(
          file.remark(
              placed,
              " at %s is more than %s m inside %s; it will be pushed out at once: move one of them"
                  .formatted(point(placed.x(), placed.y()), DEEP, title(other))));
    }
  }

  /** Returns the item of the file that an entity comes from, or the name of its archetype. */
  private String title(HostEntity entity) {
    Level level = file.level();
    Archetype archetype = entity.archetype();
    if (archetype.index() >= level.archetypes().size()) {
      return "a " + archetype.name() + " of the game";
    }
    List<Level.Placement> all = entity.isLevel() ? level.statics() : level.bodies();
    for (Level.Placement placed : all) {
      if (placed.archetype() == archetype.index()) {
        return file.title(placed);
      }
    }
    return archetype.name();
  }

  private void triggers() {
    List<LevelTrigger> triggers = file.level().triggers();
    for (int i = 0; i < triggers.size(); i++) {
      LevelTrigger trigger = triggers.get(i);
      condition(i, trigger.when());
      if (!trigger.enabled() && !isEnabledByAnother(trigger)) {
        warn(
            file.remark(
                "triggers",
                i,
                trigger.name().isEmpty()
                    ? ".enabled=false, and without a name nothing can enable it; give it a name,"
                        + " or remove \"enabled\""
                    : ".enabled=false, and no trigger enables \"" + trigger.name() + "\""));
      }
    }
  }

  private boolean isEnabledByAnother(LevelTrigger trigger) {
    for (LevelTrigger other : file.level().triggers()) {
      for (List<Action> actions : List.of(other.then(), other.otherwise())) {
        for (Action action : actions) {
          if (action.verb() == Verb.ENABLE
              && !trigger.name().isEmpty()
              && action.name().equals(trigger.name())) {
            return true;
          }
        }
      }
    }
    return false;
  }

  private void condition(int trigger, Condition condition) {
    condition.parts().forEach(part -> condition(trigger, part));
    if (condition.cause() == Cause.ENTER
        || condition.cause() == Cause.LEAVE
        || condition.cause() == Cause.INSIDE) {
      if (file.level().statics().stream().noneMatch(p -> isReachable(p, condition.name()))) {
        warn(
            file.remark(
                "triggers",
                trigger,
                ".when: sensor \"%s\" lies outside the bounds %s, where nothing comes"
                    .formatted(condition.name(), text(file.level().bounds()))));
      }
    } else if (condition.cause() == Cause.HIT && isSensor(condition.name())) {
      warn(
          file.remark(
              "triggers",
              trigger,
              ".when.hit=\"%s\" is a sensor, which nothing hits; use \"enter\""
                  .formatted(condition.name())));
    } else if (condition.cause() == Cause.TIMER && condition.least() > 3_600) {
      warn(
          file.remark(
              "triggers",
              trigger,
              ".when.timer=%s is more than an hour of a match".formatted(condition.least())));
    }
  }

  private boolean isSensor(String name) {
    return file.level().sensorNames().contains(name);
  }

  /** Returns whether a body is a sensor of a name, and touches the bounds. */
  private boolean isReachable(Level.Placement placed, String name) {
    Archetype archetype = archetype(placed);
    if (!archetype.name().equals(name)) {
      return false;
    }
    Aabb box = new Aabb();
    Transform at = new Transform(placed.x(), placed.y(), placed.angle());
    Level.Bounds b = file.level().bounds();
    return archetype.shapes().stream()
        .anyMatch(
            shape -> {
              shape.aabb(at, box);
              return box.maxX >= b.minX()
                  && box.minX <= b.maxX()
                  && box.maxY >= b.minY()
                  && box.minY <= b.maxY();
            });
  }

  private Archetype archetype(Level.Placement placed) {
    return new Archetypes().add(file.level().archetypes().get(placed.archetype()));
  }

  private void step(String fileName, SimulationHost simulation) {
    Level level = file.level();
    boolean[] told = new boolean[level.bodies().size()];
    for (int tick = 1; tick <= TICKS; tick++) {
      try {
        simulation.step();
      } catch (RuntimeException | LinkageError | AssertionError | StackOverflowError e) {
        problems.add(fileName + ": tick " + tick + " fails: " + GameFault.describe(e));
        return;
      }
      for (int id = 0; id < told.length; id++) {
        HostEntity entity = simulation.entity(id);
        Level.Placement placed = level.bodies().get(id);
        boolean isItem =
            entity != null
                && entity.generation() == 0
                && entity.archetype().index() == placed.archetype();
        if (isItem
            && !told[id]
            && level.bounds().contains(placed.x(), placed.y())
            && entity.isDynamic()
            && isLeaving(entity)) {
          told[id] = true;
          warn(
              file.remark(
                  placed,
                  " at %s is out of the bounds %s after %s s; give it something to stand on, or"
                          .formatted(
                              point(placed.x(), placed.y()),
                              text(level.bounds()),
                              Math.round(10f * tick / TICK_RATE) / 10f)
                      + " other bounds"));
        }
      }
    }
  }

  /**
   * Returns whether a body is out of the bounds with the next tick, in which the game brings it
   * back.
   */
  private boolean isLeaving(HostEntity entity) {
    float nextX = entity.x() + entity.velocityX() / TICK_RATE;
    float nextY = entity.y() + entity.velocityY() / TICK_RATE;
    return !file.level().bounds().contains(nextX, nextY);
  }

  private static String point(float x, float y) {
    return String.format(Locale.ROOT, "[%.4g, %.4g]", x, y);
  }

  private static String text(Level.Bounds b) {
    return point(b.minX(), b.minY()) + " to " + point(b.maxX(), b.maxY());
  }
}

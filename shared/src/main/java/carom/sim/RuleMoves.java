package carom.sim;

import carom.physics.math.Limits;
import carom.sim.entity.HostEntity;
import carom.sim.level.LevelTrigger;
import java.util.List;

/**
 * Moves kinematic bodies of the level to where rules sent them. Where each goes, and until when, is
 * in {@link RuleWords}. A body follows the words of the tick before. So a client that is told them
 * later computes from that tick on what the server did. One thread; allocates nothing in a step.
 */
final class RuleMoves {
  /** The highest speed of a body that moves, m/s along an axis; what needs more comes later. */
  private static final float MAX_SPEED = 500;

  private final SimulationHost simulation;
  private final SimParts parts;
  private final RuleWords words;

  /** Numbers in {@link carom.sim.level.Level#bodies} of the bodies that may be moved. */
  private final List<Integer> moved;

  RuleMoves(SimulationHost simulation, SimParts parts) {
    this.simulation = simulation;
    this.parts = parts;
    words = parts.ruleWords;
    moved = RuleWords.moved(parts.level, parts.rules != null);
  }

  /** Returns the number of bodies that may be moved. */
  int count() {
    return moved.size();
  }

  /** Returns one of the bodies that may be moved, or null if it is gone or not predicted here. */
  HostEntity get(int at) {
    return parts.levelBody(moved.get(at));
  }

  /** Returns the place of a body among those that may be moved, or -1. */
  int find(int body) {
    return moved.indexOf(body);
  }

  /** Returns the place of the one body of a name, as {@link Rules#move} says. */
  int find(String name) {
    int found = -1;
    for (int i = 0; i < moved.size(); i++) {
      int archetype = parts.level.bodies().get(moved.get(i)).archetype();
      if (parts.archetypes.get(archetype).name().equals(name)) {
        if (found >= 0) {
          throw new IllegalArgumentException(
              "body=\"" + name + "\" is the name of several; give each another name");
        }
        found = i;
      }
    }
    if (found < 0) {
      throw new IllegalArgumentException(
          "body=\""
              + name
              + "\" isn't one of the first "
              + LevelTrigger.MAX_MOVED
              + " bodies of the level that are kinematic and have no \"motion\"");
    }
    return found;
  }

  /** Sends a body to a place, from the next tick on. */
  void start(int at, float x, float y, float seconds) {
    Limits.position("x", x);
    Limits.position("y", y);
    Limits.range("seconds", seconds, 0, LevelTrigger.MAX_SECONDS);
    simulation.set(words.until, at, parts.tick + simulation.ticks(seconds));
    simulation.set(words.toX, at, x);
    simulation.set(words.toY, at, y);
  }

  /** Gives the bodies that move their velocities for the tick that is being computed. */
  void drive() {
    for (int i = 0; i < moved.size(); i++) {
      int until = simulation.get(words.until, i);
      int left = until - parts.tick + 1;
      HostEntity entity = until == 0 || left < 0 ? null : get(i);
      if (entity != null) {
        drive(i, entity, left);
      }
    }
  }

  private void drive(int at, HostEntity entity, int left) {
    float vx = left == 0 ? 0 : (simulation.get(words.toX, at) - entity.x()) * parts.tickRate / left;
    float vy = left == 0 ? 0 : (simulation.get(words.toY, at) - entity.y()) * parts.tickRate / left;
    float fastest = Math.max(Math.abs(vx), Math.abs(vy));
    if (fastest > MAX_SPEED) {
      vx *= MAX_SPEED / fastest;
      vy *= MAX_SPEED / fastest;
      simulation.set(words.until, at, Math.max(parts.tick + left - 1, parts.tick + 1));
    }
    entity.body().setVelocity(vx, vy);
  }
}

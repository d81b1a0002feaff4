package carom.testkit;

import carom.physics.archive.ArchiveReader;
import carom.physics.archive.ArchiveWriter;
import carom.physics.math.SimRandom;
import carom.sim.Game;
import carom.sim.Role;
import carom.sim.SimState;
import carom.sim.SimulationHost;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.Input;
import carom.sim.level.Level;
import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;

/**
 * Computes a game again, without a network: twice from the start, again from a state that was saved
 * in memory, and from one that was written to bytes. All ways must end in the same state. It also
 * measures what a tick costs. One thread.
 */
final class RepeatCheck {
  private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();
  private static final int TICK_RATE = 60;

  /** Ticks between saved states, and ticks that are computed again from each. */
  private static final int STRIDE = 40;

  private static final int HELD_TICKS = 9;

  private final Supplier<Game> games;
  private final CodeCheck code;
  private final Level level;
  private final long seed;
  private final int players;
  private final List<String> broken = new ArrayList<>();
  private double msPerTick;
  private double bytesPerTick;

  /**
   * Runs the check.
   *
   * @param code what was read of the game's code
   * @param ticks how long each way is
   */
  RepeatCheck(
      Supplier<Game> games, CodeCheck code, Level level, long seed, int players, int ticks) {
    this.games = games;
    this.code = code;
    this.level = level;
    this.seed = seed;
    this.players = players;
    SimulationHost first = start();
    SimulationHost second = start();
    int part = ticks / 2;
    int differs = -1;
    for (int tick = 0; tick < ticks && differs < 0; tick++) {
      if (tick == part) {
        measure(first, tick, Math.min(part, ticks - tick));
        for (int i = tick; i < tick + Math.min(part, ticks - tick); i++) {
          step(second, i);
        }
        differs = first.stateHash() == second.stateHash() ? -1 : first.tick();
        break;
      }
      step(first, tick);
      step(second, tick);
      differs = first.stateHash() == second.stateHash() ? -1 : first.tick();
    }
    if (differs >= 0) {
      broken.add(
          "the same seed and the same inputs give another state, first at tick "
              + differs
              + difference(first, second)
              + "; use Simulation.random() instead of java.util.Random, no clock, no hash order,"
              + " and no static variables that change");
      return; // all that follows would differ, too
    }
    rollBack();
    restoreElsewhere();
  }

  /** Returns what is broken, in words; empty if nothing is. */
  List<String> broken() {
    return broken;
  }

  /** Returns the time of a tick of the simulation, mean of the second half, milliseconds. */
  double msPerTick() {
    return msPerTick;
  }

  /**
   * Returns what a tick allocates, mean of the second half, bytes. The engine allocates nothing.
   */
  double bytesPerTick() {
    return bytesPerTick;
  }

  private SimulationHost start() {
    SimulationHost s = new SimulationHost(games.get(), level, seed, TICK_RATE, Role.AUTHORITY);
    for (int i = 0; i < players; i++) {
      s.join("p" + i);
    }
    return s;
  }

  /** Steps with inputs that are a function of seed, player and tick. */
  private void step(SimulationHost s, int tick) {
    for (int id = 0; id < players; id++) {
      HostPlayer p = s.player(id);
      if (p != null) {
        press(p.input(), SimRandom.mix(SimRandom.mix(seed, id), tick / HELD_TICKS));
      }
    }
    s.step();
  }

  private static void press(Input out, long bits) {
    out.clear();
    out.move(axis(bits), axis(bits >>> 8));
    out.aim((bits >>> 16 & 0xff) * 0.0245f);
    int buttons = (int) (bits >>> 24 & bits >>> 32);
    out.buttons(buttons & (Input.JUMP | Input.ACTION | Input.SECOND | Input.UP | Input.DOWN));
  }

  private static float axis(long bits) {
    return Math.max(-1, Math.min(1, ((bits & 0xff) - 127) / 100f));
  }

  private void measure(SimulationHost s, int tick, int ticks) {
    long ns = System.nanoTime();
    long bytes = THREADS.getCurrentThreadAllocatedBytes();
    for (int i = tick; i < tick + ticks; i++) {
      step(s, i);
    }
    bytesPerTick = (THREADS.getCurrentThreadAllocatedBytes() - bytes) / (double) ticks;
    msPerTick = (System.nanoTime() - ns) / 1e6 / ticks;
  }

  private void rollBack() {
    SimulationHost s = start();
    SimState[] before = new SimState[STRIDE];
    for (int tick = 0; tick < 8 * STRIDE; tick += STRIDE) {
      final SimState saved = s.save(null);
      long[] hashes = new long[STRIDE];
      for (int i = 0; i < STRIDE; i++) {
        step(s, tick + i);
        hashes[i] = s.stateHash();
        before[i] = s.save(before[i]);
      }
      s.restore(saved);
      for (int i = 0; i < STRIDE; i++) {
        step(s, tick + i);
        if (s.stateHash() != hashes[i]) {
          broken.add(
              "after a rollback to tick "
                  + tick
                  + " the same inputs give another state, first at tick "
                  + (tick + i + 1)
                  + difference(elsewhere(before[i]), s)
                  + advice());
          return;
        }
      }
    }
  }

  /** Returns a simulation in another's state. */
  private SimulationHost elsewhere(SimState state) {
    ArchiveWriter bytes = new ArchiveWriter();
    state.write(bytes);
    SimulationHost other = new SimulationHost(games.get(), level, seed, TICK_RATE, Role.AUTHORITY);
    other.restore(other.read(new ArchiveReader(bytes.toBytes())));
    return other;
  }

  private static String difference(SimulationHost a, SimulationHost b) {
    String found = StateDifference.between(a, b);
    return found.isEmpty() ? "" : ", where " + found;
  }

  private String advice() {
    String variables = String.join("; ", code.variables());
    return "; keep what changes in fields, not in variables of the game"
        + (variables.isEmpty() ? "" : ". It writes " + variables);
  }

  private void restoreElsewhere() {
    SimulationHost s = start();
    if (s.game().keepsMore()) {
      return; // the game says that its state is incomplete
    }
    for (int tick = 0; tick < 8 * STRIDE; tick += STRIDE) {
      SimulationHost other = elsewhere(s.save(null));
      for (int i = 0; i < STRIDE; i++) {
        step(s, tick + i);
        step(other, tick + i);
        if (s.stateHash() != other.stateHash()) {
          broken.add(
              "a state that was saved at tick "
                  + tick
                  + " goes on otherwise in another process, first at tick "
                  + (tick + i + 1)
                  + difference(s, other)
                  + advice());
          return;
        }
      }
    }
  }
}

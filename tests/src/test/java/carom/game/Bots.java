package carom.game;

import carom.physics.math.SimRandom;
import carom.sim.SimulationHost;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.Input;

/** Inputs for tests: a pure function of seed, tick and player. */
final class Bots {
  private Bots() {}

  /** Sets the input of every player as if children held the controllers. */
  static void wander(SimulationHost s, long seed) {
    for (int id = 0; id < s.playerCapacity(); id++) {
      HostPlayer p = s.player(id);
      if (p == null) {
        continue;
      }
      long phase = (s.tick() + 7L * id) / 25;
      SimRandom random = new SimRandom(seed * 1_000_003 + phase * 257 + id);
      random.nextLong();
      Input in = p.input();
      in.move(random.between(-1.3f, 1.3f), random.between(-1.3f, 1.3f));
      in.aim(random.between(0, 6.28f));
      in.buttons(random.nextInt(8));
    }
  }
}

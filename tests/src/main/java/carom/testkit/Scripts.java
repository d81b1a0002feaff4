package carom.testkit;

import carom.client.InputSource;
import carom.sim.Input;
import carom.sim.SimRandom;

/** Players that follow a simple rule. */
public final class Scripts {
  private Scripts() {}

  /** Pushes the stick in one direction for ever. */
  public static InputSource hold(float moveX, float moveY) {
    return (view, tick, out) -> out.move(moveX, moveY);
  }

  /**
   * Changes its mind several times a second: directions, jumps, actions. Looks at nothing, so that
   * equal seeds give equal inputs however the picture differs.
   */
  public static InputSource wander(long seed) {
    SimRandom random = new SimRandom(seed);
    Input held = new Input();
    return (view, tick, out) -> {
      if (random.nextInt(12) == 0) {
        held.move(2 * random.nextFloat() - 1, 2 * random.nextFloat() - 1);
        held.hold(Input.ACTION, random.nextInt(3) == 0);
        held.hold(Input.JUMP, random.nextInt(3) == 0);
      }
      out.set(held);
    };
  }
}

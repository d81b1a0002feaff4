package carom.testkit;

import carom.client.InputSource;
import carom.physics.math.SimRandom;
import carom.sim.entity.Input;

/** Input sources that follow a simple rule. */
public final class Scripts {
  private Scripts() {}

  /** Returns a source that always pushes the stick in one direction. */
  public static InputSource hold(float moveX, float moveY) {
    return (view, tick, out) -> out.move(moveX, moveY);
  }

  /**
   * Returns a source that changes direction, jump and action at random several times a second. It
   * ignores the view, so equal seeds give equal inputs in any game.
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

package carom.plain;

import java.util.concurrent.atomic.AtomicInteger;

/**
 * Carries the player's newest controls. The server uses them from its next tick on, until others
 * come. Send one for each frame or change, by UDP if there is UDP.
 */
public final class Input {
  private static final AtomicInteger COUNT = new AtomicInteger();

  /** Number of this input: higher than that of any before. */
  public int count = COUNT.incrementAndGet();

  /** Tick of the newest snapshot of which all parts are here; -1 for none. */
  public int seen = -1;

  /**
   * Up to three controls, the newest first. The older ones are those of the inputs before, in case
   * these are lost.
   */
  public Controls[] inputs = {};

  /** Creates one to be filled in. */
  public Input() {}

  /**
   * Creates one that stands alone.
   *
   * @param seen tick of the newest snapshot, or -1
   * @param buttons that are down: 1 jump, 2 action, 4 second, 8 down, 16 up
   * @param moveX to the right, -1..1
   * @param moveY upwards, -1..1
   * @param aim radians counterclockwise from +x
   */
  public Input(int seen, int buttons, float moveX, float moveY, float aim) {
    this.seen = seen;
    inputs = new Controls[] {new Controls(buttons, moveX, moveY, aim)};
  }

  /**
   * Creates one that follows another and carries its controls, too, so that a press isn't lost with
   * a datagram.
   *
   * @param before the input sent last, or null
   */
  public Input(Input before, int seen, int buttons, float moveX, float moveY, float aim) {
    this(seen, buttons, moveX, moveY, aim);
    if (before != null) {
      int older = Math.min(before.inputs.length, 2);
      Controls[] all = new Controls[1 + older];
      all[0] = inputs[0];
      System.arraycopy(before.inputs, 0, all, 1, older);
      inputs = all;
      count = before.count + 1;
    }
  }
}

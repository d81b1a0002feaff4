package carom.plain;

/** Buttons and sticks of a player: a part of {@link Input}. */
public final class Controls {
  /** Buttons that are down: 1 jump, 2 action, 4 second, 8 down, 16 up. */
  public int buttons;

  /** Movement to the right, -1..1. */
  public float moveX;

  /** Movement upwards, -1..1. */
  public float moveY;

  /** Direction, radians counterclockwise from +x. */
  public float aim;

  /** Creates one to be filled in. */
  public Controls() {}

  /** Creates one. */
  public Controls(int buttons, float moveX, float moveY, float aim) {
    this.buttons = buttons;
    this.moveX = moveX;
    this.moveY = moveY;
    this.aim = aim;
  }
}

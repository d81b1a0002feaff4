package carom.physics.collision;

import carom.physics.math.Limits;

/**
 * A way to move two overlapping bodies apart by their MTV, as lectures do it: A by a share of it, B
 * by the rest backwards. The engine itself solves contacts instead ({@code carom.physics.World}),
 * which keeps stacks still; these are for lessons, and for games without a world.
 */
public enum Separation {
  /** Each body moves by half of the MTV. */
  HALVES,

  /** Each body moves by its share of both speeds; what stood still stays. */
  BY_SPEED;

  /**
   * Returns the part of the MTV by which A moves; B moves by the rest, backwards.
   *
   * @param speedA speed of A, 0 or more, m/s
   * @param speedB speed of B, 0 or more, m/s
   * @return 0..1; a half if neither moves
   */
  public float shareOfA(float speedA, float speedB) {
    float a = Limits.range("speedA", speedA, 0, Limits.MAX_VELOCITY);
    float both = a + Limits.range("speedB", speedB, 0, Limits.MAX_VELOCITY);
    return this == HALVES || both == 0 ? 0.5f : a / both;
  }

  /**
   * Returns the impulse along the MTV that makes bodies part, {@code j = -(1 + e) v.n / (1/mA +
   * 1/mB)}: A gets j times the unit vector of the MTV, B gets it backwards.
   *
   * @param mtv moves A out of B, not zero
   * @param velocityX velocity of A relative to B, m/s
   * @param velocityY velocity of A relative to B, m/s
   * @param inverseMassA 1/kg, 0 for a body that doesn't move
   * @param inverseMassB 1/kg, 0 for a body that doesn't move
   * @param restitution 0..1
   * @return N s; 0 if the bodies part already, or neither can move
   */
  public static float impulse(
      Mtv mtv,
      float velocityX,
      float velocityY,
      float inverseMassA,
      float inverseMassB,
      float restitution) {
    float length = Limits.notNull("mtv", mtv).length();
    Limits.range("restitution", restitution, 0, 1);
    float masses = Limits.range("inverseMassA", inverseMassA, 0, 1e9f);
    masses += Limits.range("inverseMassB", inverseMassB, 0, 1e9f);
    float parting = velocityX * mtv.x + velocityY * mtv.y;
    return parting < 0 && masses > 0 ? -(1 + restitution) * parting / (length * masses) : 0;
  }
}

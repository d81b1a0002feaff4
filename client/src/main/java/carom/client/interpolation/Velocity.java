package carom.client.interpolation;

/**
 * The velocity of an entity in one of its known states, derived from the poses around it, as the
 * server sends none. Mutable, reused.
 */
public final class Velocity {
  /**
   * Acceleration above which something has hit the body, m/s^2. Then the poses before and after say
   * nothing about each other.
   */
  private static final float HIT = 100;

  /** Angular acceleration above which something has hit the body, rad/s^2. */
  private static final float SPIN_HIT = 120;

  /**
   * Most that rounded poses differ from the true ones, metres; {@link #TURN_ROUNDING} is the same
   * in radians.
   */
  private static final float ROUNDING = 2e-3f;

  private static final float TURN_ROUNDING = 6.2e-3f;

  /** Time over which a velocity is measured that has poses on one side only, milliseconds. */
  private static final int MEASURED_MS = 50;

  private final float tickSeconds;
  private final int measuredTicks;

  /** X of the velocity, m/s. */
  public float vx;

  /** Y of the velocity, m/s. */
  public float vy;

  /** Angular velocity, rad/s. */
  public float omega;

  /**
   * Creates a velocity of 0.
   *
   * @param tickRate the server's ticks per second, at least 1
   */
  public Velocity(int tickRate) {
    tickSeconds = 1f / tickRate;
    measuredTicks = Math.max(1, tickRate * MEASURED_MS / 1_000);
  }

  /** Returns whether two states are the same entity's, not teleported between. */
  static boolean areLinked(StateHistory states, int older, int newer) {
    return older < states.size()
        && newer >= 0
        && states.alive(older)
        && states.alive(newer)
        && states.generation(older) == states.generation(newer)
        && states.teleports(older) == states.teleports(newer);
  }

  /**
   * Derives the velocity with which a curve between two states leaves one of them. It comes from
   * the poses on both sides of the state, or, if the body was hit there, is the mean velocity
   * between the two.
   *
   * @param at the state
   * @param other the state at the curve's other end
   * @param beyond the state on the other side of {@code at}
   */
  void atEnd(StateHistory states, int at, int other, int beyond) {
    boolean both = areLinked(states, Math.max(at, beyond), Math.min(at, beyond));
    mean(states, Math.max(at, other), Math.min(at, other));
    if (!both) {
      return;
    }
    float inner = Math.abs(states.tick(other) - states.tick(at)) * tickSeconds;
    float outer = Math.abs(states.tick(beyond) - states.tick(at)) * tickSeconds;
    float rounding = 1 / inner + 1 / outer;
    float innerX = vx;
    float innerY = vy;
    float innerOmega = omega;
    mean(states, Math.max(at, beyond), Math.min(at, beyond));
    float share = inner / (inner + outer);
    float apart = (inner + outer) / 2;
    boolean hit = length(vx - innerX, vy - innerY) > HIT * apart + ROUNDING * rounding;
    vx = hit ? innerX : innerX + (vx - innerX) * share;
    vy = hit ? innerY : innerY + (vy - innerY) * share;
    hit = Math.abs(omega - innerOmega) > SPIN_HIT * apart + TURN_ROUNDING * rounding;
    omega = hit ? innerOmega : innerOmega + (omega - innerOmega) * share;
  }

  /**
   * Derives the velocity in a state from that and earlier ones: 0 if it stood still, or is alone.
   */
  public void measure(StateHistory states, int at) {
    int middle = back(states, at);
    int oldest = back(states, middle);
    vx = 0;
    vy = 0;
    omega = 0;
    if (states.still(at) || middle == at) {
      return;
    }
    if (oldest == middle) {
      mean(states, middle, at);
      return;
    }
    mean(states, oldest, middle);
    float earlyX = vx;
    float earlyY = vy;
    float earlyOmega = omega;
    mean(states, middle, at);
    float late = (states.tick(at) - states.tick(middle)) * tickSeconds;
    float early = (states.tick(middle) - states.tick(oldest)) * tickSeconds;
    float share = late / (late + early);
    float apart = (late + early) / 2;
    if (length(vx - earlyX, vy - earlyY) > HIT * apart
        || Math.abs(omega - earlyOmega) > SPIN_HIT * apart) {
      mean(states, at + 1, at); // what was before it was hit says nothing
    } else {
      vx += (vx - earlyX) * share;
      vy += (vy - earlyY) * share;
      omega += (omega - earlyOmega) * share;
    }
  }

  /** Returns the state from which to measure the way to another one; that one, if there is none. */
  private int back(StateHistory states, int from) {
    int at = from;
    while (areLinked(states, at + 1, at) && states.tick(from) - states.tick(at) < measuredTicks) {
      at++;
    }
    return at;
  }

  /** Sets this to the mean velocity between two states. */
  void mean(StateHistory states, int older, int newer) {
    float seconds = (states.tick(newer) - states.tick(older)) * tickSeconds;
    vx = (states.x(newer) - states.x(older)) / seconds;
    vy = (states.y(newer) - states.y(older)) / seconds;
    omega = turn(states, older, newer) / seconds;
  }

  /**
   * Returns the angle by which an entity turned between two states. Angles are known modulo a turn:
   * takes the turn nearest to what the spin before explains.
   */
  private static float turn(StateHistory states, int older, int newer) {
    float way = Pose.wrap(states.angle(newer) - states.angle(older));
    int ticks = states.tick(newer) - states.tick(older);
    if (ticks > 1 && areLinked(states, older + 1, older)) {
      int before = states.tick(older) - states.tick(older + 1);
      float spun = Pose.wrap(states.angle(older) - states.angle(older + 1)) * ticks / before;
      return before < ticks ? spun + Pose.wrap(way - spun) : way;
    }
    return way;
  }

  private static float length(float x, float y) {
    return (float) Math.sqrt(x * x + y * y);
  }
}

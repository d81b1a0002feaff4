package carom.client.bots;

import carom.client.view.ClientView.Drawn;
import carom.game.cars.CarsFields;
import carom.game.cars.CarsGame;
import carom.sim.entity.Input;

/**
 * Plays {@code cars}: full throttle, level in the air as the ground below will be, nitro where the
 * road ahead is clear, flips where a flight is long enough.
 */
public final class CarsBrain extends GradedBrain {
  private static final float LOOK_AHEAD = 0.45f; // s
  private static final float DEPTH = 9; // below a car, within which there is a road, m
  private static final int PATIENCE_TICKS = 70;
  private static final int BACK_TICKS = 45;

  private boolean burns;
  private float miss;
  private float ease; // share of the throttle that it leaves off
  private float markX;
  private int markTick;

  /** Creates a bot of a strength that its random numbers choose, for the service loader. */
  public CarsBrain() {
    this(null);
  }

  /** Creates a bot of a strength, null for one by chance. */
  public CarsBrain(Strength strength) {
    super("cars", strength);
  }

  @Override
  void play(Senses s, Strength strength, Input out) {
    if (changesMind(s, 20)) {
      float error = strength.of(0.3f, 0.2f, 0.1f); // rad it lands askew, share of the throttle
      miss = s.random().between(-error, error);
      ease = s.random().between(0, error);
    }
    Drawn own = s.own();
    float speed = (float) Math.hypot(own.velocityX(), own.velocityY());
    float slope = slope(s, own.x() + LOOK_AHEAD * Math.max(3, own.velocityX()), own.y());
    boolean flies = !s.isWall(0, -1.8f);
    float error = wrapped(slope + miss - own.angle());
    float lean = strength.of(0.6f, 0.8f, 1) * (1.6f * error - 0.4f * own.angularVelocity());
    out.move(
        isStuck(s) ? -1 : strength.of(0.85f, 0.95f, 1) - ease,
        flies || Math.abs(error) > 0.5f ? lean : 0);
    float tank = s.player().get(CarsFields.NITRO);
    burns = burns ? tank > 0.02f : tank > strength.of(0.95f, 0.6f, 0.15f);
    boolean straight = Math.abs(wrapped(own.angle())) < 0.7f && speed < CarsGame.BOOST_SPEED - 1;
    out.hold(Input.ACTION, burns && straight && !flies);
  }

  /** Returns the slope of the road at a place, radians; 0 where there is none. */
  private static float slope(Senses s, float x, float y) {
    float before = road(s, x - 1, y);
    float after = road(s, x + 1, y);
    return Float.isNaN(before) || Float.isNaN(after) ? 0 : (float) Math.atan2(after - before, 2);
  }

  /** Returns the height of the road at a place, or NaN over a gap. */
  private static float road(Senses s, float x, float y) {
    float top = y + 3;
    float length = 3 + DEPTH;
    if (!s.view().isWall(x, top, 0, -length)) {
      return Float.NaN;
    }
    for (float half = length / 2; half > 0.05f; half /= 2) {
      length += s.view().isWall(x, top, 0, half - length) ? -half : 0;
    }
    return top - length;
  }

  private static float wrapped(float angle) {
    return (float) Math.IEEEremainder(angle, 2 * Math.PI);
  }

  /** Returns whether it hasn't got on for a while, so that it should take a run-up. */
  private boolean isStuck(Senses s) {
    int since = s.tick() - markTick;
    boolean waits = s.player().get(CarsFields.HELD) > 0;
    boolean gotOn = Math.abs(s.own().x() - markX) > 2;
    if (waits || gotOn || since < 0 || since > PATIENCE_TICKS + BACK_TICKS) {
      markX = s.own().x();
      markTick = s.tick();
      return false;
    }
    return since > PATIENCE_TICKS;
  }
}

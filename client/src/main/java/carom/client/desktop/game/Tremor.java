package carom.client.desktop.game;

import carom.client.look.Shake;
import com.badlogic.gdx.math.MathUtils;

/** The shake of the picture: the strongest of those that go on. Render thread only. */
final class Tremor {
  /** Distance at which a shake is half as strong, metres. */
  private static final float NEAR_M = 12;

  /** Frequency of its way to and fro, Hz; the two differ, so that it draws no line. */
  private static final float HERTZ_X = 13;

  private static final float HERTZ_Y = 17;

  private float metres;
  private float length = 1;
  private float age;
  private float listenerX;
  private float listenerY;

  Tremor() {}

  /** Ends it. */
  void clear() {
    metres = 0;
  }

  /** Adds a shake, unless a stronger one goes on. */
  void add(Shake shake, float x, float y, float share) {
    float dx = x - listenerX;
    float dy = y - listenerY;
    float strength = shake.metres() * share / (1 + (dx * dx + dy * dy) / (NEAR_M * NEAR_M));
    if (strength >= strength()) {
      metres = strength;
      length = shake.seconds();
      age = 0;
    }
  }

  private float strength() {
    float left = Math.max(0, 1 - age / length);
    return metres * left * left;
  }

  /** Lets time pass; the picture shows what is around a point, metres. */
  public void update(float x, float y, float seconds) {
    listenerX = x;
    listenerY = y;
    age += seconds;
  }

  /** Returns how far the picture is moved to the right, metres. */
  public float x() {
    return strength() * MathUtils.sin(MathUtils.PI2 * HERTZ_X * age + 1);
  }

  /** Returns how far the picture is moved upwards, metres. */
  public float y() {
    return strength() * MathUtils.sin(MathUtils.PI2 * HERTZ_Y * age + 2);
  }
}

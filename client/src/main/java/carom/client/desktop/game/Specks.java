package carom.client.desktop.game;

import java.util.Arrays;

/**
 * Small things of the picture that fly for a moment, such as sparks and drops. They fall by the
 * level's gravity, hit nothing and fade. A new one takes the place of the oldest. Render thread
 * only; allocates nothing after it was created.
 */
final class Specks {
  private final float life;
  private final float[] x;
  private final float[] y;
  private final float[] vx;
  private final float[] vy;
  private final float[] size;
  private final float[] age;
  private final int[] rgb;
  private int next;

  /** Creates room for so many specks, none of which flies. Each lives for a number of seconds. */
  Specks(int most, float life) {
    this.life = life;
    x = new float[most];
    y = new float[most];
    vx = new float[most];
    vy = new float[most];
    size = new float[most];
    age = new float[most];
    rgb = new int[most];
    clear();
  }

  /** Ends all specks. */
  void clear() {
    Arrays.fill(age, life);
  }

  /**
   * Adds a speck.
   *
   * @param spent the part of its life that is over, 0..1
   */
  void add(
      float atX, float atY, float speedX, float speedY, float metres, float spent, int colour) {
    x[next] = atX;
    y[next] = atY;
    vx[next] = speedX;
    vy[next] = speedY;
    size[next] = metres;
    age[next] = spent * life;
    rgb[next] = colour;
    next = (next + 1) % age.length;
  }

  /** Moves the specks that live. */
  void fly(float gravityX, float gravityY, float seconds) {
    for (int i = 0; i < age.length; i++) {
      if (lives(i)) {
        age[i] += seconds;
        vx[i] += gravityX * seconds;
        vy[i] += gravityY * seconds;
        x[i] += vx[i] * seconds;
        y[i] += vy[i] * seconds;
      }
    }
  }

  /** Returns whether the speck of a place lives. */
  boolean lives(int i) {
    return age[i] < life;
  }

  /** Ends the speck of a place. */
  void end(int i) {
    age[i] = life;
  }

  /** Returns the part of a speck's life that is left, 0..1. */
  float left(int i) {
    return Math.max(0, 1 - age[i] / life);
  }

  /** Returns for how long a speck has lived, s. */
  float seconds(int i) {
    return age[i];
  }

  float x(int i) {
    return x[i];
  }

  float y(int i) {
    return y[i];
  }

  float velocityX(int i) {
    return vx[i];
  }

  float velocityY(int i) {
    return vy[i];
  }

  float size(int i) {
    return size[i];
  }

  int rgb(int i) {
    return rgb[i];
  }

  /** Returns how many specks live. */
  int living() {
    int n = 0;
    for (int i = 0; i < age.length; i++) {
      n += lives(i) ? 1 : 0;
    }
    return n;
  }
}

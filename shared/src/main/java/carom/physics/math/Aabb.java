package carom.physics.math;

/**
 * An axis-aligned bounding box: two closed intervals, in metres. Boxes that share only a border
 * overlap. A box with {@code minX > maxX} is empty, see {@link #setEmpty()}. Mutable and reused;
 * not safe for use by several threads.
 */
public final class Aabb {
  /** Left border. */
  public float minX;

  /** Lower border. */
  public float minY;

  /** Right border. */
  public float maxX;

  /** Upper border. */
  public float maxY;

  /** Creates the box that holds only the origin. */
  public Aabb() {}

  /** Creates a box from its borders, which are not checked. */
  public Aabb(float minX, float minY, float maxX, float maxY) {
    set(minX, minY, maxX, maxY);
  }

  /** Sets all borders, which are not checked. Returns this. */
  public Aabb set(float minX, float minY, float maxX, float maxY) {
    this.minX = minX;
    this.minY = minY;
    this.maxX = maxX;
    this.maxY = maxY;
    return this;
  }

  /** Copies {@code box}. Returns this. */
  public Aabb set(Aabb box) {
    Limits.notNull("box", box);
    return set(box.minX, box.minY, box.maxX, box.maxY);
  }

  /** Makes this the empty box, the neutral element of {@link #add(Aabb)}. Returns this. */
  public Aabb setEmpty() {
    return set(
        Float.POSITIVE_INFINITY,
        Float.POSITIVE_INFINITY,
        Float.NEGATIVE_INFINITY,
        Float.NEGATIVE_INFINITY);
  }

  /** Returns true if the box holds no point. */
  public boolean isEmpty() {
    return !(minX <= maxX && minY <= maxY);
  }

  /** Extends this box to hold {@code box}. Returns this. */
  public Aabb add(Aabb box) {
    Limits.notNull("box", box);
    minX = Math.min(minX, box.minX);
    minY = Math.min(minY, box.minY);
    maxX = Math.max(maxX, box.maxX);
    maxY = Math.max(maxY, box.maxY);
    return this;
  }

  /** Extends this box to hold the point (x, y). Returns this. */
  public Aabb add(float x, float y) {
    minX = Math.min(minX, x);
    minY = Math.min(minY, y);
    maxX = Math.max(maxX, x);
    maxY = Math.max(maxY, y);
    return this;
  }

  /** Moves every border outwards by {@code margin} metres (inwards when negative). Returns this. */
  public Aabb grow(float margin) {
    return set(minX - margin, minY - margin, maxX + margin, maxY + margin);
  }

  /** Returns true if the boxes share at least one point. */
  public boolean overlaps(Aabb box) {
    Limits.notNull("box", box);
    return minX <= box.maxX && box.minX <= maxX && minY <= box.maxY && box.minY <= maxY;
  }

  /** Returns true if {@code box} lies inside this one, borders included. */
  public boolean contains(Aabb box) {
    Limits.notNull("box", box);
    return minX <= box.minX && box.maxX <= maxX && minY <= box.minY && box.maxY <= maxY;
  }

  /** Returns true if the point (x, y) is inside or on the border. */
  public boolean contains(float x, float y) {
    return minX <= x && x <= maxX && minY <= y && y <= maxY;
  }

  /** Returns the horizontal size, metres. */
  public float width() {
    return maxX - minX;
  }

  /** Returns the vertical size, metres. */
  public float height() {
    return maxY - minY;
  }

  /** Returns half the length of the border in metres, the cost measure of box trees. */
  public float halfPerimeter() {
    return width() + height();
  }

  @Override
  public String toString() {
    return "Aabb(" + minX + ", " + minY + " .. " + maxX + ", " + maxY + ")";
  }
}

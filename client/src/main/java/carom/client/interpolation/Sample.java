package carom.client.interpolation;

/** A body's pose at a moment, and the states between which it lies. Mutable, reused. */
public final class Sample {
  /** Takes the place of a tick or of an index where there is none. */
  public static final int NONE = -1;

  /** Index of the last state before the moment; {@link #NONE} if the body did not exist then. */
  public int index = NONE;

  /** Tick of that state. */
  public int fromTick = NONE;

  /** Tick of the state after the moment; {@link #NONE} if the pose was extrapolated. */
  public int toTick = NONE;

  /** Pose at the moment. */
  public final Pose pose = new Pose();

  /** Creates a sample of a body that did not exist. */
  public Sample() {}

  /** Copies another sample. */
  public void set(Sample other) {
    index = other.index;
    fromTick = other.fromTick;
    toTick = other.toTick;
    pose.set(other.pose);
  }

  /** Returns whether the body existed at the moment. */
  public boolean exists() {
    return index != NONE;
  }
}

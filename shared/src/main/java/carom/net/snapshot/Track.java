package carom.net.snapshot;

import carom.net.snapshot.frame.QuantizedPose;

/**
 * The poses of a body that a {@link Baseline} names, and what {@link Predictor} finds in them: how
 * the body moved, how its way bends, and which of the contexts of {@link DeltaCodec} that is.
 * Mutable, reused.
 */
final class Track {

  /** Number of classes of {@link #bend}. */
  static final int BENDS = 16;

  /** Number of classes of {@link #twist}. */
  static final int TWISTS = 12;

  /** Number of classes of {@link #speed}. */
  static final int SPEEDS = 6;

  /** The newest pose, that of the baseline. */
  public final QuantizedPose newest = new QuantizedPose();

  /** The pose a stride before; if the baseline has it. */
  public final QuantizedPose middle = new QuantizedPose();

  /** The pose two strides before; if the baseline has it. */
  public final QuantizedPose oldest = new QuantizedPose();

  int baseline;

  // First and second differences of the poses, which are 0 where poses lack.
  int dx;
  int dy;
  int turn;
  int bendX;
  int bendY;
  int bendTurn;

  /** True if gravity alone explains how the way bends. */
  boolean falls;

  // How far it falls beyond the straight way in the time of the baseline's age.
  long dropX;
  long dropY;

  /** Class of how far the way bends in the time of the baseline's age; others if poses lack. */
  int bend;

  /** Class of how the turning changes in that time; others if poses lack. */
  int twist;

  /** Class of how far the body goes in that time. */
  int speed;

  /** Creates a track without poses. */
  public Track() {}

  /** Returns a pose: 0 for the newest, 2 for the oldest. */
  public QuantizedPose pose(int index) {
    return index == 0 ? newest : index == 1 ? middle : oldest;
  }
}

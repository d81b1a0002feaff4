package carom.client.prediction;

import carom.net.snapshot.exact.OwnState;

/**
 * Result of the last {@link Prediction#reconcile}: what was compared, what was corrected, and what
 * the replay took. One object for the prediction's life. Read-only for users.
 */
public final class Reconciliation {
  final OwnState predicted = new OwnState();
  boolean compared;
  boolean exact;
  boolean corrected;
  float correctionMetres;
  int awakeBodies;
  int exactBodies;
  int toldBodies;
  boolean told;
  boolean otherInputs;
  boolean ruled;
  int replayedTicks;
  int rolledBackTicks;
  long replayNs;

  Reconciliation() {}

  /** Starts a new result; the replay's time stays until it is measured again. */
  void begin() {
    compared = false;
    corrected = false;
    replayedTicks = 0;
    rolledBackTicks = 0;
    awakeBodies = 0;
    exactBodies = 0;
    toldBodies = 0;
    told = false;
  }

  /** Returns whether there was a prediction to compare with. */
  public boolean compared() {
    return compared;
  }

  /** Returns what was predicted for the own body. Valid while {@link #compared}. */
  public OwnState predicted() {
    return predicted;
  }

  /** Returns whether the own body was predicted in every bit. */
  public boolean exact() {
    return compared && exact;
  }

  /**
   * Returns whether the own body was predicted otherwise because the game's rules acted on it or
   * near it, as the server has told, and is right with what was told.
   */
  public boolean told() {
    return told;
  }

  /**
   * Returns how many awake bodies were predicted otherwise because of what the game's rules did, as
   * the server has told, and are right with what was told. They don't count in {@link
   * #awakeBodies}.
   */
  public int toldBodies() {
    return toldBodies;
  }

  /** Returns whether an input came that differs from the one that was predicted in its place. */
  public boolean otherInputs() {
    return otherInputs;
  }

  /** Returns whether word came of what the game's rules did in a tick that was predicted. */
  public boolean ruled() {
    return ruled;
  }

  /** Returns how many awake bodies of the predicted set were compared. */
  public int awakeBodies() {
    return awakeBodies;
  }

  /** Returns how many of {@link #awakeBodies} were predicted in every bit. */
  public int exactBodies() {
    return exactBodies;
  }

  /** Returns whether the own body was corrected; what was {@linkplain #told told} doesn't count. */
  public boolean corrected() {
    return corrected;
  }

  /** Returns how far the correction moved the own body in the present, metres. */
  public float correctionMetres() {
    return corrected || told ? correctionMetres : 0;
  }

  /**
   * Returns how far the own body is in the present from where it was before the reconciliation,
   * metres, for any reason. What the rules did to it may be known before it shows, so this may be
   * more than {@link #correctionMetres}.
   */
  public float shiftMetres() {
    return replayedTicks > 0 ? correctionMetres : 0;
  }

  /** Returns how many ticks were resimulated. */
  public int replayedTicks() {
    return replayedTicks;
  }

  /** Returns how many ticks before the present the rollback went; 0 if there was none. */
  public int rolledBackTicks() {
    return rolledBackTicks;
  }

  /** Returns how long the last reconciliation took, nanoseconds. */
  public long replayNs() {
    return replayNs;
  }
}

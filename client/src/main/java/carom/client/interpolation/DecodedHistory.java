package carom.client.interpolation;

import carom.net.codec.Quantizer;
import carom.net.snapshot.EntityHistory;

/** Converts a decoder's history to metres and radians. Reused for one history after another. */
public final class DecodedHistory implements StateHistory {
  private EntityHistory history;

  /** Creates a reader; call {@link #of} before anything else. */
  public DecodedHistory() {}

  /** Sets the history to read; returns this. */
  public DecodedHistory of(EntityHistory history) {
    this.history = history;
    return this;
  }

  @Override
  public int size() {
    return history.size();
  }

  @Override
  public int tick(int index) {
    return history.tick(index);
  }

  @Override
  public boolean alive(int index) {
    return history.alive(index);
  }

  @Override
  public int generation(int index) {
    return history.generation(index);
  }

  @Override
  public int teleports(int index) {
    return history.teleports(index);
  }

  @Override
  public float x(int index) {
    return Quantizer.positionOf(history.x(index));
  }

  @Override
  public float y(int index) {
    return Quantizer.positionOf(history.y(index));
  }

  @Override
  public float angle(int index) {
    return Quantizer.angleOf(history.angle(index));
  }

  @Override
  public boolean still(int index) {
    return history.still(index);
  }
}

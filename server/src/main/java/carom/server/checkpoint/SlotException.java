package carom.server.checkpoint;

import java.io.IOException;

/** Says in one line why a slot can't be used. */
final class SlotException extends IOException {
  private static final long serialVersionUID = 1;

  /** Creates an exception with its reason. */
  public SlotException(String why) {
    super(why);
  }
}

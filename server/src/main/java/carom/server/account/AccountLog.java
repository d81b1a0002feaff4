package carom.server.account;

import java.util.List;

/** The writes that a room has noted of accounts, as its checkpoints see them. */
public interface AccountLog {
  /** Returns how many writes the room has noted so far, which belong to ticks before now. */
  long noted();

  /** Returns the last writes of players who have left, which the store may lack. */
  List<AccountWrite> departed();

  /** Takes the last writes of players who had left an earlier run of the room. */
  void resumed(List<AccountWrite> writes);
}

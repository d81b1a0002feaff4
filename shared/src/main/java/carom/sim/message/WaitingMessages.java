package carom.sim.message;

import java.util.ArrayList;
import java.util.List;

/**
 * Messages of players that wait for the next step, in the order in which the step handles them: by
 * player id, then by arrival. One thread.
 */
public final class WaitingMessages {
  /** Most messages of one player that a step handles. */
  public static final int MAX_PER_PLAYER = 16;

  private record Waiting(int player, Message message) {}

  /** Receives messages. */
  @FunctionalInterface
  public interface Reader {
    /** Receives a message of a player. */
    void read(int player, Message message);
  }

  private final List<Waiting> list = new ArrayList<>();

  /** Creates an empty queue. */
  public WaitingMessages() {}

  /** Adds a message; returns false when {@value #MAX_PER_PLAYER} of the player wait. */
  public boolean add(int player, Message message) {
    int at = list.size();
    while (at > 0 && list.get(at - 1).player > player) {
      at--;
    }
    if (at >= MAX_PER_PLAYER && list.get(at - MAX_PER_PLAYER).player == player) {
      return false;
    }
    list.add(at, new Waiting(player, message));
    return true;
  }

  /** Passes on all messages, in order, and keeps them. */
  public void forEach(Reader reader) {
    for (int i = 0; i < list.size(); i++) {
      reader.read(list.get(i).player, list.get(i).message);
    }
  }

  /** Removes all messages. */
  public void clear() {
    list.clear();
  }

  /** Removes the messages of a player. */
  public void forget(int player) {
    list.removeIf(waiting -> waiting.player == player);
  }
}

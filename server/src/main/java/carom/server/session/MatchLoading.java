package carom.server.session;

import carom.net.protocol.ClientMessage;
import carom.net.protocol.ServerMessage;
import carom.net.protocol.SessionState;
import carom.net.transport.Link;

/**
 * Lets the client of one session load a match: sends the level, checks that the client has the game
 * of the match, and counts the ticks that it takes. The room's thread.
 */
final class MatchLoading {
  /** Sends the level; null while the client plays. */
  private LevelUpload upload;

  private ServerMessage.Welcome welcome;
  private boolean done;
  private int ticks;

  /**
   * Begins with a match.
   *
   * @param newUpload sends the level
   * @param newWelcome tells the client of the match
   */
  void begin(LevelUpload newUpload, ServerMessage.Welcome newWelcome) {
    upload = newUpload;
    welcome = newWelcome;
    done = false;
    ticks = 0;
  }

  /** Ends, because the client plays. */
  void end() {
    upload = null;
    done = false;
  }

  /**
   * Takes a message of the client. What belongs to the last match may still arrive.
   *
   * @return what is wrong with it, or null if nothing is
   */
  String receive(Object message, Link link) {
    if (message instanceof ClientMessage.LevelRequest request) {
      boolean answered = upload.answer(request, link) == null;
      return answered ? null : Offence.of(message, SessionState.LOADING);
    }
    if (message instanceof ClientMessage.Ready ready) {
      boolean ofThisMatch = upload.isFinishedBy(ready);
      if (ofThisMatch && welcome.refusal(ready) != null) {
        return "Ready with another game than the match's: " + welcome.refusal(ready);
      }
      done |= ofThisMatch;
      return null;
    }
    boolean mayBeLate =
        message instanceof ClientMessage.Look
            || message instanceof ClientMessage.Diverged
            || message instanceof ClientMessage.Heard
            || message instanceof ClientMessage.PoolRequest
            || message instanceof ClientMessage.GameMessage;
    return mayBeLate ? null : Offence.of(message, SessionState.LOADING);
  }

  /** Returns whether the client has loaded the match. */
  boolean isDone() {
    return done;
  }

  /** Notes that a tick has passed meanwhile. */
  void tick() {
    ticks++;
  }

  /** Returns the number of ticks since the match began to load. */
  int ticks() {
    return ticks;
  }
}

package carom.server.lobby;

import carom.net.protocol.ClientMessage;
import carom.net.protocol.ServerMessage;
import carom.net.protocol.ServerMessage.LevelOutcome;
import carom.net.transport.Link;
import carom.server.upload.Uploads;
import java.util.concurrent.CompletableFuture;

/** A level that a visitor sends, until the server has it or not. The lobby's thread. */
final class LevelIntake {
  private final Uploads uploads;
  private final String account;
  private final String author;
  private final int size;
  private final byte[] packed;
  private int received;
  private CompletableFuture<Uploads.Outcome> judged;

  /** Creates an intake of which nothing has arrived. */
  LevelIntake(Uploads uploads, String account, String author, ClientMessage.OfferLevel offer) {
    this.uploads = uploads;
    this.account = account;
    this.author = author;
    size = offer.levelSize();
    packed = new byte[offer.packedSize()];
  }

  /** Tells the client how far the level has arrived. */
  void tell(Link link) {
    link.send(new ServerMessage.LevelAnswer(received, LevelOutcome.UNDER_WAY, ""));
  }

  /** Takes a piece; returns false if it isn't the next one. */
  boolean take(ClientMessage.LevelPiece piece, Link link) {
    byte[] bytes = piece.bytes();
    if (judged != null || piece.offset() != received || bytes.length > packed.length - received) {
      return false;
    }
    System.arraycopy(bytes, 0, packed, received, bytes.length);
    received += bytes.length;
    tell(link);
    if (received == packed.length) {
      judged = uploads.submit(account, author, packed, size);
    }
    return true;
  }

  /** Returns whether the whole level is here, so that the client waits for the server. */
  boolean isWhole() {
    return judged != null;
  }

  /** Returns the bytes that have arrived. */
  int received() {
    return received;
  }

  /** Returns what has come of the level, or null as long as that isn't known. */
  Uploads.Outcome outcome() {
    return judged == null ? null : judged.getNow(null);
  }
}

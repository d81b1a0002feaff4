package carom.testkit;

import carom.server.Server;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;

/**
 * Where a stepper's servers keep their checkpoints.
 *
 * @param parent the caller's folder
 * @param life counts the folders in it; each crash leaves a copy to the next server
 * @param seconds time between checkpoints, s
 */
record KeptRooms(Path parent, int life, int seconds) {
  private Path folder() {
    return parent.resolve("checkpoints" + life);
  }

  void begin(Server server) {
    try {
      server.checkpoint(folder(), seconds);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /**
   * Ends a server as a crash does. What it writes at its end is lost.
   *
   * @return what it had written before
   */
  KeptRooms crash(Server server) {
    KeptRooms next = new KeptRooms(parent, life + 1, seconds);
    try {
      Folders.copy(folder(), next.folder());
      server.close();
      Folders.delete(folder());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return next;
  }
}

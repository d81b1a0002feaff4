package carom.client.replay;

import carom.replay.RecordingReader;
import java.io.IOException;
import java.nio.file.Path;

/** Finds the end of a recording without computing the game. */
final class RecordingLength {
  private RecordingLength() {}

  /**
   * Returns the last tick that a recording has now. Reads the whole file once, which takes
   * milliseconds for a match. Of a damaged file it is the last tick before the damage.
   *
   * @param first tick before the first one of the file
   */
  static int lastTick(Path file, int first) {
    int tick = first;
    try (RecordingReader reader = RecordingReader.open(file)) {
      while (true) {
        switch (reader.next()) {
          case STEPPED -> tick++;
          case STATE -> tick = reader.stateTick();
          case END, WAIT -> {
            return tick;
          }
          default -> {}
        }
      }
    } catch (IOException e) {
      return tick; // playing that far reports it
    }
  }
}

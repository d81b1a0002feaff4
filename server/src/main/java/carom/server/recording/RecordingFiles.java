package carom.server.recording;

import carom.replay.BlockSink;
import java.io.IOException;

/** Files for the recordings of one room, one after the other. The room's thread asks for them. */
@FunctionalInterface
public interface RecordingFiles {
  /**
   * Creates the next file, which takes a disk about a millisecond.
   *
   * @return takes the blocks of one recording
   * @throws IOException when it can't be created
   */
  BlockSink next() throws IOException;
}

package carom.server.recording;

import carom.replay.Block;
import carom.replay.BlockSink;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntSupplier;

/**
 * A room's recording that shows each block to spectators after a delay, counted from the last tick
 * in the block, and not while it is {@linkplain #hold held}. All spectators read the same file. A
 * spectator that comes late can skip what lies before the last whole state.
 *
 * <p>The room's thread calls {@link #take} and {@link #hold}, the lobby's thread all other methods.
 */
public final class DelayedRecording implements BlockSink, AutoCloseable {
  private final RecordingFile file;
  private final IntSupplier tick;
  private final boolean temporary;

  /** The tick after which each block was made. Guarded by itself. */
  private final List<Integer> ticks = new ArrayList<>();

  /** The type of each block. {@code ticks} guards it and the fields derived from it below. */
  private final List<Block> types = new ArrayList<>();

  /** End of the header in the file, bytes. */
  private long headerEnd;

  /** Start of the last whole state in the file, bytes. */
  private long lastState;

  /** Start of the newest state in the file, bytes. Its last blocks may be missing. */
  private long begunState;

  private int delayTicks = Integer.MAX_VALUE;
  private volatile boolean held;
  private int shownBlocks;
  private long shownBytes;
  private FileChannel channel;

  /**
   * Creates a recording that shows nothing until {@link #delay} is called.
   *
   * @param file takes the blocks; {@link #close} closes it
   * @param tick returns the room's present tick; called on the room's thread
   * @param temporary whether {@link #close} deletes the file
   */
  public DelayedRecording(RecordingFile file, IntSupplier tick, boolean temporary) {
    this.file = file;
    this.tick = tick;
    this.temporary = temporary;
  }

  /** Sets the delay, in ticks. Call it before the first block is read. */
  public void delay(int newDelayTicks) {
    delayTicks = newDelayTicks;
  }

  /**
   * Shows no further block, or goes on showing blocks. Somebody who computes a match from a
   * recording knows all of it, also what a team alone may know.
   */
  public void hold(boolean newHeld) {
    held = newHeld;
  }

  /** Returns whether spectators may see the recording. Constant after the room's first turn. */
  public boolean isShown() {
    return delayTicks != Integer.MAX_VALUE;
  }

  /** Returns whether the recording is for spectators alone: it isn't kept. */
  public boolean isOnlyShown() {
    return temporary && isShown();
  }

  @Override
  public boolean take(Block type, byte[] bytes, int length) {
    boolean taken = file.take(type, bytes, length);
    if (taken) {
      synchronized (ticks) {
        ticks.add(tick.getAsInt());
        types.add(type);
      }
    }
    return taken;
  }

  /**
   * Returns the number of bytes at the start of the file that spectators may see.
   *
   * @param now the room's tick
   */
  public long shownBytes(int now) {
    synchronized (ticks) {
      while (!held
          && shownBlocks < ticks.size()
          && now - ticks.get(shownBlocks) >= delayTicks
          && file.endOf(shownBlocks) >= 0) {
        noteState(types.get(shownBlocks));
        shownBytes = file.endOf(shownBlocks);
        shownBlocks++;
      }
    }
    return shownBytes;
  }

  /** Notes where whole states begin. Called before {@code shownBytes} moves to the block's end. */
  private void noteState(Block type) {
    boolean inState = shownBlocks > 0 && types.get(shownBlocks - 1) == Block.STATE;
    if (shownBlocks == 0) {
      headerEnd = file.endOf(0);
    } else if (type == Block.STATE && !inState) {
      begunState = shownBytes;
    } else if (type != Block.STATE && inState) {
      lastState = begunState;
    }
  }

  /**
   * Returns the number of bytes behind the header that a new spectator can skip. The header and the
   * blocks from the last whole state on are a recording by themselves.
   *
   * @param now the room's tick
   */
  public long skippableBytes(int now) {
    shownBytes(now);
    return Math.max(0, lastState - headerEnd);
  }

  /**
   * Reads bytes that spectators may see.
   *
   * @param skipped number of bytes behind the header to leave out, from {@link #skippableBytes}
   * @param offset offset in the rest, any value; the result is empty behind the visible bytes
   * @param most largest number of bytes to read
   * @param now the room's tick
   */
  public byte[] read(long skipped, long offset, int most, int now) throws IOException {
    int length = (int) Math.max(0, Math.min(most, shownBytes(now) - skipped - offset));
    byte[] bytes = new byte[length];
    if (length > 0) {
      if (channel == null) {
        channel = FileChannel.open(file.path());
      }
      int before = (int) Math.max(0, Math.min(length, headerEnd - offset));
      fill(ByteBuffer.wrap(bytes, 0, before), offset);
      fill(ByteBuffer.wrap(bytes, before, length - before), offset + before + skipped);
    }
    return bytes;
  }

  private void fill(ByteBuffer to, long from) throws IOException {
    for (long at = from; to.hasRemaining(); ) {
      int read = channel.read(to, at);
      if (read < 0) {
        return;
      }
      at += read;
    }
  }

  /** Returns the file. */
  public RecordingFile file() {
    return file;
  }

  /** Closes the file and deletes it if it is temporary. */
  @Override
  public void close() {
    file.close();
    try {
      if (channel != null) {
        channel.close();
      }
      if (temporary) {
        Files.deleteIfExists(file.path());
      }
    } catch (IOException e) {
      // The system clears its folder for temporary files by itself.
      return;
    }
  }

  @Override
  public String toString() {
    return file.toString();
  }
}

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
 * A room's recording as spectators may see it: each block from a delay after the last tick in it
 * on, never before. All of them read the same file, whose bytes exist once, whoever watches; who
 * comes late is spared what lies before the last whole state.
 *
 * <p>{@link #take} belongs to the room's thread, the rest to the lobby's.
 */
public final class DelayedRecording implements BlockSink, AutoCloseable {
  private final RecordingFile file;
  private final IntSupplier tick;
  private final boolean temporary;

  /** The tick after which each block was made; guarded by itself. */
  private final List<Integer> ticks = new ArrayList<>();

  /** What each block is; guarded by {@code ticks}, as what is derived from it below. */
  private final List<Block> types = new ArrayList<>();

  /** Where the header ends, the last whole state begins, and one that may not be whole yet. */
  private long headerEnd;

  private long lastState;
  private long begunState;

  private int delayTicks = Integer.MAX_VALUE;
  private int shownBlocks;
  private long shownBytes;
  private FileChannel channel;

  /**
   * Shows nothing until {@link #delay} is set.
   *
   * @param file takes the blocks; closed with this
   * @param tick the room's present tick, read on its thread
   * @param temporary whether the file goes when this is closed
   */
  public DelayedRecording(RecordingFile file, IntSupplier tick, boolean temporary) {
    this.file = file;
    this.tick = tick;
    this.temporary = temporary;
  }

  /** Shows blocks so many ticks late, before the first is read. */
  public void delay(int newDelayTicks) {
    delayTicks = newDelayTicks;
  }

  /** Whether spectators may see it, once it is old enough. Set before the room's first turn. */
  public boolean isShown() {
    return delayTicks != Integer.MAX_VALUE;
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
   * How many bytes of the file may be seen.
   *
   * @param now the room's tick
   */
  public long shownBytes(int now) {
    synchronized (ticks) {
      while (shownBlocks < ticks.size()
          && now - ticks.get(shownBlocks) >= delayTicks
          && file.endOf(shownBlocks) >= 0) {
        noteState(types.get(shownBlocks));
        shownBytes = file.endOf(shownBlocks);
        shownBlocks++;
      }
    }
    return shownBytes;
  }

  /** Before {@code shown} moves to the block's end. */
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
   * How many bytes behind the header somebody who comes now needs not fetch: the header and what
   * follows the last whole state are a recording by themselves.
   *
   * @param now the room's tick
   */
  public long skippableBytes(int now) {
    shownBytes(now);
    return Math.max(0, lastState - headerEnd);
  }

  /**
   * Reads bytes that may be seen.
   *
   * @param skipped how many bytes behind the header are left out, as {@link #skippableBytes} said
   * @param offset in what is left, anything; behind what may be seen there is nothing
   * @param most largest number of bytes
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

  /** The file. */
  public RecordingFile file() {
    return file;
  }

  /** Closes the file, and deletes it if it was made for this only. */
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
      // It lies in the system's folder for such files, which is cleared without us.
      return;
    }
  }

  @Override
  public String toString() {
    return file.toString();
  }
}

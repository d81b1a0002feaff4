package carom.server.checkpoint;

import carom.replay.Block;
import carom.replay.BlockSink;
import carom.replay.BlockWriter;
import carom.text.FileErrors;
import java.io.IOException;
import java.nio.channels.Channels;
import java.nio.channels.WritableByteChannel;
import java.util.Arrays;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;

/**
 * One slot while it is written. The room's thread hands in blocks and seats, which are copied;
 * everything else happens on the threads of {@link SlotDisk}.
 *
 * <p>When the disk fails, or more than {@value #MAX_QUEUED} bytes wait for it, the slot has failed:
 * it takes nothing more and stays readable up to its last whole block.
 */
final class SlotFile implements BlockSink {
  /** Most bytes that may wait: the largest state, and the log of some minutes. */
  static final int MAX_QUEUED = 48 << 20;

  /** Does something that a disk may refuse. */
  @FunctionalInterface
  interface Task {
    void run() throws IOException;
  }

  private final SlotDisk disk;
  private final SlotStore folder;
  private final int number;
  private final AtomicLong queued = new AtomicLong();
  private final AtomicInteger blocks = new AtomicInteger();
  private final AtomicInteger queuedBlocks = new AtomicInteger();

  /** Null until the first block is written. */
  private BlockWriter writer;

  private WritableByteChannel channel;
  private volatile String failure;

  /** True once the disk has failed, so that the rest of the queue is of no use. */
  private volatile boolean broken;

  /** True once the seats of the checkpoint were handed in. The room's thread only. */
  private boolean hasSeats;

  private volatile boolean safe;

  SlotFile(SlotDisk disk, SlotStore folder, int number) {
    this.disk = disk;
    this.folder = folder;
    this.number = number;
  }

  int number() {
    return number;
  }

  @Override
  public boolean take(Block type, byte[] bytes, int length) {
    if (failure != null) {
      return false;
    }
    if (queued.get() + length > MAX_QUEUED) {
      failure = folder.title() + " is too slow: bytes=" + queued.get() + " wait for it";
      return false;
    }
    byte[] copy = Arrays.copyOf(bytes, length);
    queued.addAndGet(length);
    blocks.incrementAndGet();
    queuedBlocks.incrementAndGet();
    disk.write(
        () -> {
          attempt(() -> write(type, copy));
          queued.addAndGet(-length);
          queuedBlocks.decrementAndGet();
        });
    return true;
  }

  private void write(Block type, byte[] bytes) throws IOException {
    if (writer == null) {
      channel = folder.newLog(number);
      writer = new BlockWriter(Channels.newOutputStream(channel));
    }
    writer.write(type, bytes, bytes.length);
  }

  /** Writes who plays: at first at the checkpoint, later since the last player came or went. */
  void seats(byte[] bytes) {
    Task write =
        hasSeats ? () -> folder.writeLatest(number, bytes) : () -> folder.writeSeats(number, bytes);
    hasSeats = true;
    disk.write(() -> attempt(write));
  }

  /** Does something on the disk's thread after all that was handed in is written; or never. */
  void then(Task task) {
    disk.write(() -> attempt(task));
  }

  /**
   * Waits, on the disk's thread, until all that was handed in is on the disk.
   *
   * @param then runs when it is, on that thread
   */
  void sync(Runnable then) {
    disk.write(
        () ->
            disk.sync(
                () ->
                    attempt(
                        () -> {
                          folder.force(number, channel);
                          safe = true;
                          then.run();
                        })));
  }

  /** Closes the file after all that was handed in. A slot that is of no use is deleted. */
  void close() {
    disk.write(
        () ->
            disk.sync(
                () -> {
                  if (writer != null) {
                    try {
                      writer.close();
                    } catch (IOException e) {
                      fail("can't close it: " + e);
                    }
                  }
                  if (broken && !safe) {
                    deleteUseless();
                  }
                }));
  }

  private void deleteUseless() {
    try {
      folder.delete(number);
    } catch (IOException stays) {
      // the next slot that the disk takes deletes it
    }
  }

  /** Makes the slot take nothing more, such as when the room's thread is abandoned. */
  void cut(String why) {
    failure = why;
  }

  private void attempt(Task task) {
    if (broken) {
      return;
    }
    try {
      task.run();
    } catch (IOException e) {
      fail("can't write it: " + FileErrors.reason(e));
    } catch (RuntimeException | Error e) {
      fail("can't write it: " + e);
    }
  }

  private void fail(String why) {
    broken = true;
    failure = why;
  }

  /** Returns why the slot takes nothing more, or null while it does. Any thread. */
  String failure() {
    return failure;
  }

  /** Returns whether the checkpoint and its seats are on the disk. Any thread. */
  boolean isSafe() {
    return safe;
  }

  /** Returns the number of bytes that wait for the disk. Any thread. */
  long queuedBytes() {
    return queued.get();
  }

  /**
   * Returns the number of blocks that the disk may lack: all as long as the checkpoint isn't safe,
   * then those that wait. Any thread.
   */
  int uncertainBlocks() {
    return safe ? queuedBlocks.get() : blocks.get();
  }
}

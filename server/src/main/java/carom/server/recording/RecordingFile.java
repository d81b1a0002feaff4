package carom.server.recording;

import carom.replay.Block;
import carom.replay.BlockSink;
import carom.replay.BlockWriter;
import carom.replay.Recorder;
import carom.text.FileErrors;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.LocalDateTime;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.ArrayBlockingQueue;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The file of a recording, written by its own thread so that no disk can hold up a tick. The room's
 * thread copies a block into a queue of {@value #QUEUE}, and the file's thread writes it as soon as
 * the disk is ready.
 *
 * <p>When the queue is full, the disk fails or the file is too large, the recording is cut: it ends
 * there. Its last block then says so, if the disk still accepts it. The file closes after its last
 * block, or by {@link #close}. Unless the disk has failed, another file can go on with the game.
 *
 * <p>The room's thread calls {@link #take}; any thread may call {@link #close}.
 */
public final class RecordingFile implements BlockSink, AutoCloseable {
  /** Ending of a recording's file name. */
  public static final String SUFFIX = ".carom";

  /** Number of blocks that may wait for the disk. A room makes one or two per second. */
  static final int QUEUE = 16;

  /** Largest size of a file, bytes: eleven days of a busy match. A longer recording is cut. */
  static final long MAX_BYTES = 4L << 30;

  private static final Logger LOG = LoggerFactory.getLogger(RecordingFile.class);
  private static final DateTimeFormatter STAMP =
      DateTimeFormatter.ofPattern("yyyyMMdd-HHmmss", Locale.ROOT);
  private static final long CLOSE_MS = 5_000;

  private static final class Item {
    private Block type;
    private byte[] bytes = {};
    private int length;
  }

  private final Path path;
  private final BlockWriter writer;
  private final ArrayBlockingQueue<Item> waiting = new ArrayBlockingQueue<>(QUEUE + 1);
  private final ArrayBlockingQueue<Item> spare = new ArrayBlockingQueue<>(QUEUE);
  private final Item stop = new Item();
  private final Thread thread;
  private final long limit;
  private volatile String cut;
  private volatile boolean failed;
  private volatile long writtenBytes;

  /** Ends of the written blocks in the file, bytes. Guarded by itself. */
  private final List<Long> ends = new ArrayList<>();

  /**
   * Creates the file and starts the thread.
   *
   * @throws FileAlreadyExistsException when the file exists already
   * @throws IOException when it can't be created
   */
  public RecordingFile(Path path) throws IOException {
    this(path, MAX_BYTES);
  }

  /**
   * Creates the file for an operator.
   *
   * @throws IOException when it can't be created; the message says why and what to do
   */
  public static RecordingFile create(Path path) throws IOException {
    try {
      return new RecordingFile(path);
    } catch (FileAlreadyExistsException e) {
      throw new IOException(
          "file=" + path + " exists, and nothing is overwritten; name another, or a folder", e);
    } catch (NoSuchFileException e) {
      throw new IOException(
          "file=" + path + " can't be created: there is no folder " + path.getParent(), e);
    } catch (IOException e) {
      throw new IOException("file=" + path + " can't be created: " + FileErrors.reason(e), e);
    }
  }

  /** Ends and deletes the file, into which nothing was recorded. */
  public void discard() {
    finish();
    try {
      Files.deleteIfExists(path);
    } catch (IOException e) {
      LOG.warn("recording {} is of no use, but can't be deleted: {}", path, e.toString());
    }
  }

  /** Creates the file with another largest size, in bytes. */
  RecordingFile(Path path, long limit) throws IOException {
    this.path = path;
    this.limit = limit;
    writer = open(path);
    for (int i = 0; i < QUEUE; i++) {
      spare.add(new Item());
    }
    thread = new Thread(this::run, "carom-recording");
    thread.start();
  }

  /** Creates the file with its preamble. A full disk leaves no empty file. */
  private static BlockWriter open(Path path) throws IOException {
    OutputStream out = Files.newOutputStream(path, StandardOpenOption.CREATE_NEW);
    try {
      return new BlockWriter(out);
    } catch (IOException e) {
      out.close();
      Files.delete(path);
      throw e;
    }
  }

  /**
   * Returns the path of the file that a room records to.
   *
   * @param target a file, or a folder; in a folder the file is named after the game and the time
   * @param game name of the game
   * @param room the room's name; empty for the only one that nobody has named
   */
  public static Path fileFor(Path target, String game, String room) {
    if (!Files.isDirectory(target)) {
      return target;
    }
    boolean isNumber = !room.isEmpty() && room.chars().allMatch(Character::isDigit);
    String which = room.isEmpty() ? "" : isNumber ? "-room" + room : "-" + safe(room);
    String name = safe(game);
    return target.resolve(
        name + "-" + LocalDateTime.now(ZoneId.systemDefault()).format(STAMP) + which + SUFFIX);
  }

  private static String safe(String name) {
    return name.replaceAll("[^A-Za-z0-9_-]", "-");
  }

  /**
   * Returns a path that is free: the given one, or else with a number before its ending. Matches of
   * one room may follow each other within the second that names a file.
   */
  public static Path free(Path wanted) {
    Path path = wanted;
    for (int number = 2; Files.exists(path); number++) {
      String name = String.valueOf(wanted.getFileName());
      int dot = name.lastIndexOf('.');
      int end = dot < 1 ? name.length() : dot;
      path = wanted.resolveSibling(name.substring(0, end) + "-" + number + name.substring(end));
    }
    return path;
  }

  @Override
  public boolean take(Block type, byte[] bytes, int length) {
    if (cut != null) {
      return false;
    }
    if (writtenBytes > limit) {
      cut = "it has reached " + limit + " bytes";
      return false;
    }
    Item item = spare.poll();
    if (item == null) {
      cut = "the disk is too slow: " + QUEUE + " blocks wait";
      return false;
    }
    if (item.bytes.length < length) {
      item.bytes = new byte[Math.max(length, 2 * item.bytes.length)];
    }
    System.arraycopy(bytes, 0, item.bytes, 0, length);
    item.type = type;
    item.length = length;
    waiting.add(item); // never full: there are QUEUE items and the one that stops
    return true;
  }

  private void run() {
    try (writer) {
      for (Item item; (item = waiting.take()) != stop; ) {
        writer.write(item.type, item.bytes, item.length);
        writtenBytes = writer.written();
        synchronized (ends) {
          ends.add(writer.written());
        }
        if (item.type == Block.END) {
          return;
        }
        spare.add(item);
      }
      if (cut != null) {
        byte[] end = Recorder.cutBlock(cut);
        writer.write(Block.END, end, end.length);
      }
    } catch (IOException e) {
      failed = true;
      String reason = FileErrors.reason(e);
      cut = "can't write " + path + ": " + reason;
      LOG.error("recording {} is cut: {}; the game goes on", path, reason);
    } catch (RuntimeException | Error e) {
      failed = true;
      cut = "can't write " + path + ": " + e;
      LOG.error("recording {} is cut", path, e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /**
   * Returns where a block ends in the file, in bytes from its start, or -1 while the block isn't
   * written. Any thread.
   */
  long endOf(int block) {
    synchronized (ends) {
      return block < ends.size() ? ends.get(block) : -1;
    }
  }

  /** Returns why the recording ended early, or null when it didn't. Any thread. */
  public String cutReason() {
    return cut;
  }

  /** Returns whether the disk refused a block. Any thread. */
  public boolean hasFailed() {
    return failed;
  }

  /** Returns the number of bytes written to the disk. Any thread. */
  long writtenBytes() {
    return writtenBytes;
  }

  /** Returns the path of the file. */
  public Path path() {
    return path;
  }

  /** Returns whether the file is closed. Any thread. */
  public boolean isDone() {
    return !thread.isAlive();
  }

  /**
   * Ends the file after the queued blocks and returns at once. Calling it twice does nothing. Any
   * thread.
   */
  public void finish() {
    waiting.offer(stop); // refused only if an earlier call has filled the place
  }

  /** Writes the queued blocks, for at most 5 s, and closes the file. Closing twice does nothing. */
  @Override
  public void close() {
    if (thread.isAlive()) {
      finish();
      try {
        thread.join(CLOSE_MS);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
      if (thread.isAlive()) {
        LOG.error("recording {} is incomplete: the disk did not take it in time", path);
      }
    }
  }

  @Override
  public String toString() {
    return path + (cut == null ? "" : ", cut: " + cut);
  }
}

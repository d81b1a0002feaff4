package carom.server.access;

import carom.server.config.DataFolder;
import carom.text.FileErrors;
import carom.text.TextFile;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A list in a file, one entry a line. People may edit the file while the server runs. Comments and
 * lines that can't be read stay in it; each such line is logged when it is read and has no effect.
 * A file that can't be read leaves the entries as they were.
 *
 * <p>Any thread may ask for the entries; all else holds a lock.
 */
final class AccessFile {
  private static final Logger LOG = LoggerFactory.getLogger(AccessFile.class);
  private static final FileTime MISSING = FileTime.fromMillis(0);

  private final Path file;
  private final String head;
  private final boolean takesNames;
  private volatile List<AccessEntry> entries = List.of();
  private FileTime readTime;
  private long readSize;

  /**
   * Reads the file, if it is there.
   *
   * @param head first line of a new file, a comment
   * @param takesNames whether entries may be about names, which any player can take
   * @throws IOException if it can't be read; the message says what to do
   */
  AccessFile(Path file, String head, boolean takesNames) throws IOException {
    this.file = file;
    this.head = head;
    this.takesNames = takesNames;
    noteTime();
    entries = read();
  }

  /** Returns the entries that the file had when it was read last. */
  List<AccessEntry> entries() {
    return entries;
  }

  /** Reads the file again if it has changed, and returns whether it has. */
  synchronized boolean reloadIfChanged() {
    try {
      if (!noteTime()) {
        return false;
      }
      entries = read();
      LOG.info("{}: {} entries", file, entries.size());
      return true;
    } catch (IOException e) {
      LOG.error("{}; the entries read before stay in force", e.getMessage());
      return false;
    }
  }

  /** Notes time and size of the file, and returns whether they differ from those noted before. */
  private boolean noteTime() throws IOException {
    FileTime time = MISSING;
    long size = 0;
    try {
      time = Files.getLastModifiedTime(file);
      size = Files.size(file);
    } catch (NoSuchFileException e) {
      // the list is empty
    } catch (IOException e) {
      throw unreadable(e);
    }
    boolean changed = !time.equals(readTime) || size != readSize;
    readTime = time;
    readSize = size;
    return changed;
  }

  private List<AccessEntry> read() throws IOException {
    List<AccessEntry> found = new ArrayList<>();
    List<String> lines = lines();
    for (int i = 0; i < lines.size(); i++) {
      try {
        if (isEntry(lines.get(i))) {
          found.add(parse(lines.get(i)));
        }
      } catch (IllegalArgumentException e) {
        LOG.error("{}: {}: {}; the line has no effect", file, i + 1, e.getMessage());
      }
    }
    return List.copyOf(found);
  }

  private List<String> lines() throws IOException {
    try {
      return TextFile.read(file, TextFile.MAX_BYTES).lines().toList();
    } catch (NoSuchFileException e) {
      return List.of();
    } catch (IOException e) {
      throw unreadable(e);
    }
  }

  private IOException unreadable(IOException cause) {
    String why = FileErrors.reason(cause);
    return new IOException(file + " can't be read: " + why + "; mend it, or move it away", cause);
  }

  private static boolean isEntry(String line) {
    return !line.isBlank() && !line.strip().startsWith("#");
  }

  /**
   * Adds an entry, in the place of one about the same.
   *
   * @throws IOException if the file can't be written; the message says what to do
   */
  synchronized void add(AccessEntry entry) throws IOException {
    rewrite(entry::isAboutSame, List.of(entry));
  }

  /**
   * Removes entries, and returns how many.
   *
   * @throws IOException if the file can't be written; the message says what to do
   */
  synchronized int remove(Predicate<AccessEntry> which) throws IOException {
    int before = entries.size();
    if (entries.stream().anyMatch(which)) {
      rewrite(which, List.of());
    }
    return before - entries.size();
  }

  /**
   * Removes entries and adds others, in one step.
   *
   * @throws IOException if the file can't be written; the message says what to do
   */
  synchronized void change(Predicate<AccessEntry> without, List<AccessEntry> added)
      throws IOException {
    rewrite(without, added);
  }

  /**
   * Returns the entry of a line.
   *
   * @throws IllegalArgumentException if it is none of this list
   */
  AccessEntry parse(String line) {
    AccessEntry entry = AccessEntry.parse(line);
    if (entry.name() != null && !takesNames) {
      throw new IllegalArgumentException("anybody can take a name; list an account or an address");
    }
    return entry;
  }

  private void rewrite(Predicate<AccessEntry> without, List<AccessEntry> added) throws IOException {
    List<String> kept = new ArrayList<>();
    for (String line : lines()) {
      if (!isEntry(line) || !matches(line, without)) {
        kept.add(line);
      }
    }
    if (kept.isEmpty()) {
      kept.add(head);
    }
    added.forEach(entry -> kept.add(entry.line()));
    try {
      String text = String.join(System.lineSeparator(), kept) + System.lineSeparator();
      DataFolder.replace(file, text.getBytes(StandardCharsets.UTF_8));
    } catch (IOException e) {
      throw new IOException(
          file
              + " can't be written ("
              + FileErrors.reason(e)
              + "), so nothing has changed; free the disk or let this user write it",
          e);
    }
    noteTime();
    entries = read();
  }

  private static boolean matches(String line, Predicate<AccessEntry> which) {
    try {
      return which.test(AccessEntry.parse(line));
    } catch (IllegalArgumentException e) {
      return false;
    }
  }

  @Override
  public String toString() {
    return file.toString();
  }
}

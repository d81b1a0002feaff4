package carom.server.fleet;

import carom.server.access.SharedList;
import carom.server.config.DataFolder;
import carom.server.directory.Directory;
import carom.server.directory.DirectoryEntry;
import carom.server.directory.DirectoryException;
import carom.server.directory.DirectoryWatcher;
import carom.text.TextFile;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicBoolean;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Keeps the lists of those who may play and moderate the same on all servers of a fleet. Each line
 * is an entry of the directory. What this server and the directory agreed on last is in a file, so
 * that a line that is on one side only is known as new or as removed, even if it changed while this
 * server was down or edited by hand: three sides are merged, line by line, and where both have
 * changed a line, this server's counts.
 */
final class FleetLists implements DirectoryWatcher {
  private static final Logger LOG = LoggerFactory.getLogger(FleetLists.class);
  private static final String PREFIX = "lists/";

  private final Directory directory;
  private final List<Shared> lists = new ArrayList<>();
  private volatile boolean complete;
  private final AtomicBoolean running = new AtomicBoolean();
  private boolean failing; // guarded by running

  /**
   * Creates lists, which {@link #agree} compares.
   *
   * @param folder gets a file for each list
   * @throws IOException if a file is there but can't be read
   */
  FleetLists(Directory directory, Path folder, List<SharedList> shared) throws IOException {
    this.directory = directory;
    for (SharedList list : shared) {
      lists.add(new Shared(list, folder.resolve(list.name() + ".agreed")));
    }
    directory.watch(PREFIX, this);
  }

  @Override
  public void present(DirectoryEntry entry) {
    lists.stream().filter(one -> entry.key().startsWith(one.prefix)).forEach(l -> l.present(entry));
  }

  @Override
  public void gone(DirectoryEntry last) {
    lists.forEach(one -> one.gone(last.key()));
  }

  @Override
  public void complete() {
    complete = true;
  }

  /**
   * Makes this server's lists and the directory's equal, unless another thread is about to. It
   * waits for the directory and the disk.
   */
  void agree() {
    if (!complete || !running.compareAndSet(false, true)) {
      return;
    }
    try {
      for (Shared shared : lists) {
        shared.agree();
      }
      failing = false;
    } catch (DirectoryException e) {
      LOG.debug("fleet: lists wait for the directory: {}", e.getMessage());
    } catch (IOException e) {
      if (!failing) {
        failing = true;
        LOG.error("fleet: a list isn't the same on all servers: {}", e.getMessage());
      }
    } finally {
      running.set(false);
    }
  }

  /** One list. */
  private final class Shared {
    private final SharedList list;
    private final String prefix;
    private final Path file;

    /** Lines by subject, on which both sides agreed last. */
    private final Map<String, String> agreed;

    /** Entries of the directory by subject. */
    private final Map<String, DirectoryEntry> theirs = new ConcurrentHashMap<>();

    Shared(SharedList list, Path file) throws IOException {
      this.list = list;
      this.file = file;
      prefix = PREFIX + list.name() + "/";
      agreed = read();
    }

    private Map<String, String> read() throws IOException {
      Map<String, String> lines = new TreeMap<>();
      try {
        for (String line : TextFile.read(file, TextFile.MAX_BYTES).lines().toList()) {
          lines.put(list.subjectOf(line), line);
        }
      } catch (NoSuchFileException e) {
        return lines; // they never agreed
      } catch (IllegalArgumentException e) {
        throw new IOException(
            file + " has a line that is none: " + e.getMessage() + "; delete the file", e);
      }
      return lines;
    }

    void present(DirectoryEntry entry) {
      try {
        theirs.put(list.subjectOf(entry.value()), entry);
      } catch (IllegalArgumentException e) {
        LOG.warn("fleet: the entry {} can't be read: {}", entry.key(), e.getMessage());
      }
    }

    void gone(String key) {
      theirs.values().removeIf(entry -> entry.key().equals(key));
    }

    void agree() throws IOException {
      Map<String, String> mine = list.lines();
      Map<String, DirectoryEntry> present = Map.copyOf(theirs);
      Set<String> subjects = new TreeSet<>(mine.keySet());
      subjects.addAll(present.keySet());
      subjects.addAll(agreed.keySet());
      Map<String, String> news = new HashMap<>();
      boolean changed = false;
      for (String subject : subjects) {
        String own = mine.get(subject);
        DirectoryEntry entry = present.get(subject);
        String other = entry == null ? null : entry.value();
        String before = agreed.get(subject);
        if (Objects.equals(own, other)) {
          changed |= note(subject, own);
        } else if (!Objects.equals(own, before)) {
          changed |= tell(subject, own, entry) && note(subject, own);
        } else {
          news.put(subject, other);
        }
      }
      if (!news.isEmpty()) {
        list.change(news);
        LOG.info("fleet: {} lines of {} come from other servers", news.size(), list.name());
        news.forEach(this::note);
      }
      if (changed || !news.isEmpty()) {
        String text = String.join("\n", agreed.values());
        DataFolder.replace(file, text.getBytes(StandardCharsets.UTF_8));
      }
    }

    private boolean note(String subject, String line) {
      String before = line == null ? agreed.remove(subject) : agreed.put(subject, line);
      return !Objects.equals(before, line);
    }

    /** Tells the directory a line of this server's, or that it is gone; returns whether it is. */
    private boolean tell(String subject, String line, DirectoryEntry entry)
        throws DirectoryException {
      if (line == null) {
        directory.delete(entry.key(), entry.number());
        theirs.remove(subject, entry);
        return true;
      }
      if (line.getBytes(StandardCharsets.UTF_8).length > Directory.MAX_VALUE_BYTES) {
        LOG.warn("fleet: a line of {} is too long for the directory: {}", list.name(), subject);
        return true;
      }
      String key = entry == null ? HashedKey.of(prefix, subject) : entry.key();
      long number = entry == null ? directory.create(key, line, 0) : entry.number();
      if (number == 0 || (entry != null && !directory.update(key, line, number))) {
        return false; // another server has changed it just now, and tells
      }
      theirs.put(subject, new DirectoryEntry(key, line, number, 0));
      return true;
    }
  }
}

package carom.server.upload;

import carom.server.config.DataFolder;
import carom.text.FileErrors;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.HexFormat;
import java.util.List;
import java.util.Set;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The levels of players in a folder: a file for each, named by its hash, and an index. A file is
 * there before the index has it, and goes after, so that the index is right after a crash at any
 * moment. Not thread-safe.
 */
final class UploadStore {
  private static final Logger LOG = LoggerFactory.getLogger(UploadStore.class);
  private static final String LEVEL = ".json";

  private final Path folder;
  private final Path index;
  private List<UploadedLevel> levels = List.of();

  /**
   * Reads the index, and deletes what it doesn't have.
   *
   * @throws IOException if the folder can't be used; the message says what to do
   */
  UploadStore(Path folder) throws IOException {
    this.folder = folder;
    index = index(folder);
    try {
      Files.createDirectories(folder);
      levels = read(folder);
      deleteOthers();
    } catch (IOException e) {
      throw new IOException(
          folder + " can't be used for levels of players: " + FileErrors.reason(e), e);
    }
  }

  private static Path index(Path folder) {
    return folder.resolve("index.txt");
  }

  /** Returns the levels of the index, without a change. */
  static List<UploadedLevel> read(Path folder) throws IOException {
    List<UploadedLevel> read = new ArrayList<>();
    Path index = index(folder);
    if (!Files.exists(index)) {
      return read;
    }
    for (String line : Files.readString(index).split("\n", -1)) {
      UploadedLevel level = UploadedLevel.parse(line);
      if (level != null && Files.isRegularFile(file(folder, level))) {
        read.add(level);
      } else if (!line.isEmpty()) {
        LOG.warn("levels of players: a line of {} is left out: no level, or no file", index);
      }
    }
    return List.copyOf(read);
  }

  private void deleteOthers() throws IOException {
    Set<Path> known = new HashSet<>();
    levels.forEach(level -> known.add(file(level)));
    known.add(index);
    try (DirectoryStream<Path> files = Files.newDirectoryStream(folder)) {
      for (Path file : files) {
        if (!known.contains(file) && Files.isRegularFile(file)) {
          Files.delete(file); // of a crash between file and index
        }
      }
    }
  }

  /** Returns all levels, in the order in which they came. Immutable. */
  List<UploadedLevel> levels() {
    return levels;
  }

  /** Returns a file of the folder that the next start deletes. */
  Path scratch(String name) {
    return folder.resolve(name);
  }

  private Path file(UploadedLevel level) {
    return file(folder, level);
  }

  private static Path file(Path folder, UploadedLevel level) {
    return folder.resolve(level.hash() + LEVEL);
  }

  /**
   * Returns the bytes of a level's file.
   *
   * @throws IOException if it isn't there, or isn't what was kept
   */
  byte[] bytes(UploadedLevel level) throws IOException {
    return bytes(folder, level);
  }

  /** Returns the bytes as {@link #bytes(UploadedLevel)} does. */
  static byte[] bytes(Path folder, UploadedLevel level) throws IOException {
    Path file = file(folder, level);
    byte[] bytes = Files.readAllBytes(file);
    if (!hash(bytes).equals(level.hash())) {
      throw new IOException(file + " has been changed; remove the level");
    }
    return bytes;
  }

  /**
   * Keeps a level, in the place of another or none.
   *
   * @param old the one that goes, or null
   * @throws IOException if the disk doesn't take it; nothing has changed then
   */
  void put(UploadedLevel level, byte[] bytes, UploadedLevel old) throws IOException {
    DataFolder.replace(file(level), bytes);
    List<UploadedLevel> next = new ArrayList<>(levels);
    next.remove(old);
    next.add(level);
    write(next);
    delete(old);
  }

  /**
   * Removes a level.
   *
   * @throws IOException if the disk doesn't take it; nothing has changed then
   */
  void remove(UploadedLevel level) throws IOException {
    List<UploadedLevel> next = new ArrayList<>(levels);
    next.remove(level);
    write(next);
    delete(level);
  }

  private void write(List<UploadedLevel> next) throws IOException {
    StringBuilder text = new StringBuilder();
    next.forEach(level -> text.append(level.line()).append('\n'));
    DataFolder.replace(index, text.toString().getBytes(StandardCharsets.UTF_8));
    levels = List.copyOf(next);
  }

  private void delete(UploadedLevel old) {
    try {
      if (old != null && levels.stream().noneMatch(level -> level.hash().equals(old.hash()))) {
        Files.deleteIfExists(file(old));
      }
    } catch (IOException e) {
      LOG.warn("levels of players: {} stays until the next start: {}", file(old), e.toString());
    }
  }

  /** Returns the SHA-256 of bytes in hexadecimal digits. */
  static String hash(byte[] bytes) {
    try {
      return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(bytes));
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException(e); // every JDK has it
    }
  }
}

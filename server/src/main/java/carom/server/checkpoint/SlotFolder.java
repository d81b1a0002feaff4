package carom.server.checkpoint;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.WritableByteChannel;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * The folder of a room's checkpoints. A slot is up to three files: {@code 12.log}, a recording that
 * begins with the whole state, {@code 12.seats}, who played then, and {@code 12.latest}, who plays
 * since somebody came or went. The seats of the checkpoint are never replaced: the disk has them
 * for certain, and a machine that loses power may lose the latest. Only the user of the server may
 * read them, as the seats have the secrets of the sessions.
 *
 * @param path the folder
 */
record SlotFolder(Path path) implements SlotStore {
  private static final Pattern SLOT = Pattern.compile("([0-9]{1,9})\\.(log|seats|latest|new)");

  @Override
  public String title() {
    return "the disk";
  }

  /** Creates the folder if it isn't there. */
  void create() throws IOException {
    Files.createDirectories(path, onlyOwner("rwx------"));
  }

  Path log(int slot) {
    return path.resolve(slot + ".log");
  }

  Path seats(int slot) {
    return path.resolve(slot + ".seats");
  }

  Path latest(int slot) {
    return path.resolve(slot + ".latest");
  }

  @Override
  public List<Integer> slots() throws IOException {
    if (!Files.isDirectory(path)) {
      return List.of();
    }
    try (Stream<Path> files = Files.list(path)) {
      return files
          .map(file -> SLOT.matcher(file.getFileName().toString()))
          .filter(Matcher::matches)
          .map(name -> Integer.valueOf(name.group(1)))
          .distinct()
          .sorted((a, b) -> b - a)
          .toList();
    }
  }

  @Override
  public FileChannel newLog(int slot) throws IOException {
    return FileChannel.open(
        log(slot),
        Set.of(StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE),
        onlyOwner("rw-------"));
  }

  @Override
  public void writeSeats(int slot, byte[] bytes) throws IOException {
    write(slot, bytes, seats(slot));
  }

  @Override
  public void writeLatest(int slot, byte[] bytes) throws IOException {
    write(slot, bytes, latest(slot));
  }

  /** Writes a file in one step. */
  private void write(int slot, byte[] bytes, Path target) throws IOException {
    Path fresh = path.resolve(slot + ".new");
    Files.deleteIfExists(fresh);
    Set<StandardOpenOption> create =
        Set.of(StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
    try (FileChannel file = FileChannel.open(fresh, create, onlyOwner("rw-------"))) {
      for (ByteBuffer rest = ByteBuffer.wrap(bytes); rest.hasRemaining(); ) {
        file.write(rest);
      }
    }
    Files.move(fresh, target, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
  }

  @Override
  public void force(int slot, WritableByteChannel log) throws IOException {
    if (log instanceof FileChannel file && file.isOpen()) {
      file.force(true);
    }
    try (FileChannel file = FileChannel.open(seats(slot), StandardOpenOption.WRITE)) {
      file.force(true);
    }
    try (FileChannel folder = FileChannel.open(path, StandardOpenOption.READ)) {
      folder.force(true);
    } catch (IOException e) {
      return; // a system that can't open folders keeps names by itself
    }
  }

  @Override
  public void delete(int slot) throws IOException {
    Files.deleteIfExists(seats(slot)); // first, so that no seats are without their log
    Files.deleteIfExists(latest(slot));
    Files.deleteIfExists(log(slot));
    Files.deleteIfExists(path.resolve(slot + ".new"));
  }

  /** Puts a slot that can't be used out of the way, for people to look at. */
  void refuse(int slot) throws IOException {
    moveIfThere(seats(slot), slot + ".seats.refused");
    moveIfThere(latest(slot), slot + ".latest.refused");
    moveIfThere(log(slot), slot + ".log.refused");
  }

  /** Returns how often in a row the room has failed soon after it was resumed. */
  int failures() throws IOException {
    return Files.exists(failed()) ? (int) Files.size(failed()) : 0;
  }

  @Override
  public void writeClaim(long claim) throws IOException {
    Files.writeString(claimFile(), String.valueOf(claim));
  }

  /** Returns the claim under which the slots were written, 0 for none. */
  long claim() throws IOException {
    try {
      return Long.parseLong(Files.readString(claimFile()).strip());
    } catch (NoSuchFileException | NumberFormatException e) {
      return 0;
    }
  }

  private Path claimFile() {
    return path.resolve("claim");
  }

  @Override
  public void addFailure() throws IOException {
    Files.write(failed(), new byte[] {'x'}, StandardOpenOption.CREATE, StandardOpenOption.APPEND);
  }

  @Override
  public void forgetFailures() throws IOException {
    Files.deleteIfExists(failed());
  }

  private Path failed() {
    return path.resolve("failed");
  }

  private void moveIfThere(Path file, String name) throws IOException {
    if (Files.exists(file)) {
      Files.move(file, path.resolve(name), StandardCopyOption.REPLACE_EXISTING);
    }
  }

  private FileAttribute<?>[] onlyOwner(String permissions) {
    boolean posix = path.getFileSystem().supportedFileAttributeViews().contains("posix");
    return posix
        ? new FileAttribute<?>[] {
          PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString(permissions))
        }
        : new FileAttribute<?>[0];
  }
}

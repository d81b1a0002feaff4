package carom.net.seal;

import carom.text.FileErrors;
import carom.text.TextFile;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.WritableByteChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.SecureRandom;
import java.util.Base64;
import java.util.Set;
import java.util.function.Function;
import java.util.function.Supplier;

/** A file with a lasting key in one line, which only its owner may read. */
final class KeyFile {
  private static final String OWNER_ONLY = "rw-------";

  /** Most bytes of the file: its one line has some 90. */
  private static final int MAX_BYTES = 1_000;

  private KeyFile() {}

  /**
   * Returns the key in a file, or makes one and writes the file.
   *
   * @param reader makes a key of bytes; throws IllegalArgumentException if they are none
   * @param fresh returns the bytes of a new key
   * @param what what the file holds, and what to do if it doesn't
   * @throws IOException when the file can't be read or written; the message says what to do
   */
  static <K> K load(Path file, Function<byte[], K> reader, Supplier<byte[]> fresh, String what)
      throws IOException {
    try {
      return read(file, reader, what);
    } catch (NoSuchFileException e) {
      byte[] secret = fresh.get();
      return create(file, secret) ? reader.apply(secret) : read(file, reader, what);
    }
  }

  private static <K> K read(Path file, Function<byte[], K> reader, String what) throws IOException {
    String text;
    try {
      text = TextFile.read(file, MAX_BYTES).strip();
    } catch (NoSuchFileException e) {
      throw e;
    } catch (IOException e) {
      throw new IOException(
          file
              + " can't be read: "
              + e.getMessage()
              + "; restore it from a backup, or give it to the user that runs this program",
          e);
    }
    try {
      return reader.apply(Base64.getUrlDecoder().decode(text));
    } catch (IllegalArgumentException e) {
      throw new IOException(file + " holds no " + what, e);
    }
  }

  /** Writes a new file; returns false if it is there, because another program was faster. */
  private static boolean create(Path file, byte[] secret) throws IOException {
    byte[] line = (text(secret) + "\n").getBytes(StandardCharsets.US_ASCII);
    Files.createDirectories(file.toAbsolutePath().getParent());
    boolean posix = file.getFileSystem().supportedFileAttributeViews().contains("posix");
    FileAttribute<?>[] owner =
        posix
            ? new FileAttribute<?>[] {
              PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString(OWNER_ONLY))
            }
            : new FileAttribute<?>[0];
    try (var channel =
        Files.newByteChannel(
            file, Set.of(StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE), owner)) {
      write(channel, ByteBuffer.wrap(line), file);
      return true;
    } catch (FileAlreadyExistsException e) {
      return false;
    } catch (IOException e) {
      throw new IOException(
          file
              + " can't be written ("
              + FileErrors.reason(e)
              + "); free the disk or make its folder writable",
          e);
    }
  }

  /** Writes a new file. If the disk is full, no empty file stays that the next start would read. */
  private static void write(WritableByteChannel channel, ByteBuffer line, Path file)
      throws IOException {
    try {
      while (line.hasRemaining()) {
        channel.write(line);
      }
    } catch (IOException e) {
      Files.delete(file);
      throw e;
    }
  }

  /** Returns random bytes. */
  static byte[] random(int count) {
    byte[] bytes = new byte[count];
    new SecureRandom().nextBytes(bytes);
    return bytes;
  }

  /** Returns bytes as letters, digits, {@code -} and {@code _}. */
  static String text(byte[] bytes) {
    return Base64.getUrlEncoder().withoutPadding().encodeToString(bytes);
  }
}

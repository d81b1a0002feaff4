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
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.security.SecureRandom;
import java.util.Base64;
import java.util.Set;

/** The lasting key by which clients know a server: its file and its fingerprint. */
public final class ServerKey {
  private static final String OWNER_ONLY = "rw-------";

  /** Most bytes of the file: its one line has 44. */
  private static final int MAX_BYTES = 1_000;

  private ServerKey() {}

  /**
   * Returns the key in a file, or makes one and writes the file, which only its owner may read.
   *
   * @throws IOException when the file can't be read or written; the message says what to do
   */
  public static ExchangeKey load(Path file) throws IOException {
    try {
      return read(file);
    } catch (NoSuchFileException e) {
      return create(file);
    }
  }

  private static ExchangeKey read(Path file) throws IOException {
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
              + "; restore it from a backup, or give it to the user that runs the server",
          e);
    }
    try {
      return ExchangeKey.of(Base64.getUrlDecoder().decode(text));
    } catch (IllegalArgumentException e) {
      throw new IOException(
          file
              + " holds no server key; restore it from a backup, or delete it and tell the players"
              + " the new fingerprint",
          e);
    }
  }

  private static ExchangeKey create(Path file) throws IOException {
    byte[] secret = new byte[ExchangeKey.BYTES];
    new SecureRandom().nextBytes(secret);
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
    } catch (FileAlreadyExistsException e) {
      return read(file); // another server of the same folder was faster
    } catch (IOException e) {
      throw new IOException(
          file
              + " can't be written ("
              + FileErrors.reason(e)
              + "); free the disk or make its folder writable",
          e);
    }
    return ExchangeKey.of(secret);
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

  /**
   * Returns the fingerprint of a public key, 43 letters, digits, {@code -} and {@code _}: the
   * SHA-256 hash of its 32 bytes in Base64.
   */
  public static String fingerprint(byte[] publicKey) {
    try {
      return text(MessageDigest.getInstance("SHA-256").digest(publicKey));
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("this Java has no SHA-256", e);
    }
  }

  private static String text(byte[] bytes) {
    return Base64.getUrlEncoder().withoutPadding().encodeToString(bytes);
  }
}

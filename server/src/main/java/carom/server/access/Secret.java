package carom.server.access;

import carom.text.FileErrors;
import carom.text.TextFile;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.security.SecureRandom;
import java.util.Base64;
import java.util.Locale;
import java.util.Set;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** A secret that operators know, from a file that only the server's user may read. Immutable. */
public final class Secret {
  /** Least length of a secret that a person writes into the file, characters. */
  public static final int LEAST = 12;

  private static final Logger LOG = LoggerFactory.getLogger(Secret.class);
  private static final int RANDOM_BYTES = 24;
  private static final int MAX_BYTES = 10_000;
  private static final Set<PosixFilePermission> OWNER_ONLY =
      PosixFilePermissions.fromString("rw-------");

  private final String text;
  private final byte[] digest;

  private Secret(String text) {
    this.text = text;
    digest = digest(text);
  }

  /** Returns a random secret of 192 bits. */
  public static Secret random() {
    byte[] bytes = new byte[RANDOM_BYTES];
    new SecureRandom().nextBytes(bytes);
    return new Secret(Base64.getUrlEncoder().withoutPadding().encodeToString(bytes));
  }

  /**
   * Reads the secret of a file, its first line. If there is no file, creates one with a random
   * secret that only its owner may read.
   *
   * @throws IOException if the file can't be read or created, or the secret is too short; the
   *     message says what to do
   */
  public static Secret of(Path file) throws IOException {
    try {
      String text = firstLine(file);
      if (text.length() < LEAST) {
        throw new IOException(
            String.format(
                Locale.ROOT,
                "%s has a secret of length=%d, at least %d is needed; remove the file for a random"
                    + " one",
                file,
                text.length(),
                LEAST));
      }
      warnIfShared(file);
      return new Secret(text);
    } catch (NoSuchFileException e) {
      return create(file);
    }
  }

  private static String firstLine(Path file) throws IOException {
    try {
      return TextFile.read(file, MAX_BYTES).lines().findFirst().orElse("").strip();
    } catch (NoSuchFileException e) {
      throw e;
    } catch (IOException e) {
      throw new IOException(
          file + " can't be read: " + e.getMessage() + "; remove it for a random secret", e);
    }
  }

  private static Secret create(Path file) throws IOException {
    Secret secret = random();
    try {
      Files.createDirectories(file.toAbsolutePath().getParent());
      Files.createFile(file, isPosix(file) ? ownerOnly() : new FileAttribute<?>[0]);
      write(file, secret.text + "\n");
      return secret;
    } catch (FileAlreadyExistsException e) {
      return of(file); // another server was quicker
    } catch (IOException e) {
      throw new IOException(file + " can't be written: " + FileErrors.reason(e), e);
    }
  }

  /** Fills a new file. If the disk is full, no empty file stays that the next start would read. */
  private static void write(Path file, String text) throws IOException {
    try {
      Files.writeString(file, text);
    } catch (IOException e) {
      Files.delete(file);
      throw e;
    }
  }

  private static FileAttribute<?>[] ownerOnly() {
    return new FileAttribute<?>[] {PosixFilePermissions.asFileAttribute(OWNER_ONLY)};
  }

  private static boolean isPosix(Path file) {
    return file.getFileSystem().supportedFileAttributeViews().contains("posix");
  }

  /** Logs a warning if users other than its owner may read or change a file that is there. */
  public static void warnIfShared(Path file) throws IOException {
    if (Files.exists(file)
        && isPosix(file)
        && !OWNER_ONLY.containsAll(Files.getPosixFilePermissions(file))) {
      LOG.warn("{} is open to other users; chmod 600 {}", file, file);
    }
  }

  /** Returns whether a text is the secret, in a time that doesn't tell how much of it is right. */
  public boolean matches(String other) {
    return MessageDigest.isEqual(digest, digest(other));
  }

  /** Returns the secret itself, for the one who starts a server that can't write files. */
  public String text() {
    return text;
  }

  private static byte[] digest(String text) {
    try {
      return MessageDigest.getInstance("SHA-256").digest(text.getBytes(StandardCharsets.UTF_8));
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every JDK has SHA-256", e);
    }
  }

  @Override
  public String toString() {
    return "Secret";
  }
}

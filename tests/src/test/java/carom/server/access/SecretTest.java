package carom.server.access;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Goal: only who may read the file knows the secret. */
final class SecretTest {
  @TempDir private Path folder;

  @Test
  void theFileIsMadeOnceAndForItsOwnerAlone() throws IOException {
    Path file = folder.resolve("new/admin.token");
    Secret made = Secret.of(file);
    assertEquals("rw-------", PosixFilePermissions.toString(Files.getPosixFilePermissions(file)));
    String text = Files.readString(file).strip();
    assertTrue(made.matches(text));
    assertTrue(Secret.of(file).matches(text));
    assertFalse(made.matches(""));
    assertFalse(made.matches(text + "x"));
    assertFalse(made.matches(text.substring(1)));
    assertNotEquals(text, Secret.random().text());
    assertFalse(made.toString().contains(text));
  }

  @Test
  void anOwnSecretMustBeLong() throws IOException {
    Path file = folder.resolve("rcon.password");
    Files.writeString(file, "short\n");
    IOException e = assertThrows(IOException.class, () -> Secret.of(file));
    assertTrue(e.getMessage().contains("length=5, at least 12"), e.getMessage());
    Files.writeString(file, "twelve chars\nand a comment");
    assertTrue(Secret.of(file).matches("twelve chars"));
  }

  @Test
  void networksOfIpv6AreOneAddressAndManyAddressesHaveALimit() throws IOException {
    long[] now = {0};
    LoginThrottle throttle = new LoginThrottle(() -> now[0]);
    for (int i = 0; i < LoginThrottle.MOST; i++) {
      throttle.wrong(InetAddress.getByName("2001:db8::" + i));
    }
    assertTrue(throttle.mustWait(InetAddress.getByName("2001:db8::ffff")));
    assertFalse(throttle.mustWait(InetAddress.getByName("2001:db8:0:1::1")));
    for (int i = 0; i < LoginThrottle.MOST_OF_ALL; i++) {
      throttle.wrong(InetAddress.getByName("10.0.0." + i));
    }
    InetAddress operator = InetAddress.getByName("192.0.2.1");
    assertFalse(throttle.mustWait(operator), "strangers lock no operator out");
    throttle.wrong(operator);
    assertTrue(throttle.mustWait(operator), "it guesses, too");
    throttle.right(operator);
    assertFalse(throttle.mustWait(operator));
    throttle.wrong(operator);
    now[0] += 60_000_000_000L;
    assertFalse(throttle.mustWait(operator));
  }
}

package carom.net.seal;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Goal: a server keeps its key, and a client notices another one. Method: files in a folder. */
final class ServerKeyTest {
  private static final String SERVER = "play.example.org:54555";

  @TempDir Path folder;

  @Test
  void aKeyIsMadeOnceAndOnlyItsOwnerMayReadIt() throws IOException {
    Path file = folder.resolve("new").resolve("server.key");
    byte[] first = ServerKey.load(file).publicKey();
    assertArrayEquals(first, ServerKey.load(file).publicKey());
    if (file.getFileSystem().supportedFileAttributeViews().contains("posix")) {
      assertEquals("rw-------", PosixFilePermissions.toString(Files.getPosixFilePermissions(file)));
    }
    assertEquals(43, ServerKey.fingerprint(first).length());
  }

  @Test
  void aDamagedKeyIsToldAndNotReplaced() throws IOException {
    Path file = folder.resolve("server.key");
    Files.writeString(file, "hello\n");
    IOException told = assertThrows(IOException.class, () -> ServerKey.load(file));
    assertTrue(told.getMessage().contains("server.key holds no server key"), told::getMessage);
    assertEquals("hello\n", Files.readString(file));
  }

  @Test
  void theFirstKeyIsRememberedAndAnotherOneRefused() {
    Path file = folder.resolve("settings").resolve("known_servers");
    KnownServers known = KnownServers.in(file);
    assertNull(known.problem(SERVER, "first"));
    known.remember(SERVER, "first");
    assertNull(KnownServers.in(file).problem("Play.Example.org:54555", "first"), "names fold");
    String problem = KnownServers.in(file).problem(SERVER, "second");
    assertTrue(problem.contains("first") && problem.contains("second"), problem);
    assertTrue(problem.contains(file.toString()), problem);
    known.remember(SERVER, "second");
    assertFalse(KnownServers.in(file).problem(SERVER, "second") == null, "the first one stays");
  }

  @Test
  void whatATrustedPartyToldCountsBeforeTheFile() {
    KnownServers known = KnownServers.in(folder.resolve("known_servers"));
    known.remember(SERVER, "first");
    known.expect(SERVER, "told");
    assertNull(known.problem(SERVER, "told"));
    assertTrue(known.problem(SERVER, "first").contains("told"));
  }

  @Test
  void serversOnThisMachineAreNotRemembered() {
    KnownServers known = KnownServers.inMemory();
    for (String server : new String[] {"localhost:1", "127.0.0.1:1", "::1:1"}) {
      known.remember(server, "first");
      assertNull(known.problem(server, "second"), server);
    }
  }

  @Test
  void aListThatCantBeReadLetsNobodyIn() throws IOException {
    Path file = Files.createDirectory(folder.resolve("known_servers"));
    assertTrue(KnownServers.in(file).problem(SERVER, "first").contains("can't be read"));
  }
}

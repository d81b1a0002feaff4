package carom.net.seal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.protocol.ProtocolLimits;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Goal: a player's own key proves one account on one link, and nothing else does. */
final class PlayerKeyTest {
  private static final byte[] HERE = new byte[32];
  private static final byte[] THERE = {1};

  @TempDir private Path folder;

  @Test
  void aProofIsGoodOnItsLinkAlone() {
    PlayerKey key = PlayerKey.random();
    String proof = key.proof(HERE);
    assertEquals(key.account(), PlayerKey.account(proof, HERE));
    assertNull(PlayerKey.account(proof, THERE));
    assertTrue(proof.length() <= ProtocolLimits.MAX_TOKEN_BYTES, proof);
    assertTrue(key.account().length() <= ProtocolLimits.MAX_ACCOUNT_CHARACTERS, key.account());
    assertNotEquals(key.account(), PlayerKey.random().account());
  }

  @Test
  void aProofOfWhichACharacterIsAnotherProvesNothingOfItsAccount() {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    System.out.println("changed proofs: seed=" + seed);
    Random random = new Random(seed);
    PlayerKey key = PlayerKey.random();
    String proof = key.proof(HERE);
    for (int i = 0; i < 400; i++) {
      int at = random.nextInt(proof.length() - 1);
      if (proof.charAt(at + 1) == '.') {
        continue; // it has unused bits, as the last one
      }
      char other = (char) (' ' + random.nextInt(95));
      String changed = proof.substring(0, at) + other + proof.substring(at + 1);
      boolean same = changed.equals(proof);
      String account = PlayerKey.account(changed, HERE);
      assertEquals(same ? key.account() : null, account, changed + " seed=" + seed);
    }
    for (String none : new String[] {"", "key.", "key..", "key.AA.AA", "x.y.z"}) {
      assertNull(PlayerKey.account(none, HERE), none);
    }
  }

  @Test
  void aKeyIsMadeOnceAndOnlyItsOwnerReadsIt() throws IOException {
    Path file = folder.resolve("new/player.key");
    PlayerKey made = PlayerKey.load(file);
    PlayerKey read = PlayerKey.load(file);
    assertEquals(made.account(), read.account());
    assertEquals(made.account(), PlayerKey.account(read.proof(HERE), HERE));
    if (file.getFileSystem().supportedFileAttributeViews().contains("posix")) {
      assertEquals("rw-------", PosixFilePermissions.toString(Files.getPosixFilePermissions(file)));
    }
    Files.writeString(file, "nonsense");
    IOException e = assertThrows(IOException.class, () -> PlayerKey.load(file));
    assertTrue(e.getMessage().contains("restore it"), e.getMessage());
  }
}

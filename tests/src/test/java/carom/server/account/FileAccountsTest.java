package carom.server.account;

import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.server.JdbcAccounts;
import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Goal: the file in the data folder keeps what the contract asks for. */
final class FileAccountsTest extends AccountStoreContract {
  @TempDir private Path folder;

  @Override
  AccountStore store() throws IOException {
    return JdbcAccounts.file(folder.resolve("accounts"));
  }

  @Test
  void aFolderThatTheDatabaseMisreadsIsRefused() {
    IOException e =
        assertThrows(IOException.class, () -> JdbcAccounts.file(folder.resolve("a;INIT=x/b")));
    assertTrue(e.getMessage().contains("\";\""), e.getMessage());
  }
}

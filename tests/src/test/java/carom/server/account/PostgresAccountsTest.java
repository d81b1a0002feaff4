package carom.server.account;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.server.JdbcAccounts;
import carom.server.directory.PostgresProgram;
import carom.suite.Needs;
import java.io.IOException;
import java.util.List;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/**
 * Goal: a PostgreSQL keeps what the contract asks for, also over its own crash. Method: PostgreSQL
 * itself; skipped where that isn't possible.
 */
@Needs("processes")
final class PostgresAccountsTest extends AccountStoreContract {
  private static PostgresProgram postgres;

  @BeforeAll
  static void start() throws Exception {
    postgres = new PostgresProgram();
    postgres.await();
  }

  @AfterAll
  static void stop() throws Exception {
    if (postgres != null) {
      postgres.close();
    }
  }

  @Override
  AccountStore store() throws IOException {
    return JdbcAccounts.postgres(PostgresProgram.address(List.of(postgres.port())));
  }

  @Test
  void aDatabaseThatComesBackIsAskedAgain() throws Exception {
    try (AccountStore store = store()) {
      Stay stay = store.begin("down", 0, true);
      postgres.kill();
      IOException e = assertThrows(IOException.class, () -> store.begin("down", 0, true));
      assertFalse(e.getMessage().contains(PostgresProgram.ENCODED), e.getMessage());
      postgres.start();
      postgres.await();
      assertTrue(store.begin("down", 0, true).stamp() > stay.stamp());
    }
  }
}

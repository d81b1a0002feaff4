package carom.server.directory;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.suite.Needs;
import java.util.List;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/**
 * Goal: the directory in PostgreSQL keeps what the contract asks for. Method: PostgreSQL itself, in
 * a folder and on a port of its own; skipped where that isn't possible.
 */
@Needs("processes")
final class PostgresDirectoryTest extends RemoteDirectoryContract {
  private static PostgresProgram postgres;

  @BeforeAll
  static void start() throws Exception {
    postgres = new PostgresProgram();
    try (Directory directory = behind(List.of(postgres.port()))) {
      postgres.await(directory);
    }
  }

  @AfterAll
  static void stop() throws Exception {
    if (postgres != null) {
      postgres.close();
    }
  }

  private static Directory behind(List<Integer> ports) throws Exception {
    return Directories.open(PostgresProgram.address(ports), DirectoryTls.NONE);
  }

  @Override
  int port() {
    return postgres.port();
  }

  @Override
  Directory open(List<Integer> ports, int deadlineMs) throws Exception {
    return new PostgresDirectory(
        PostgresAddress.parse(
            "--fleet", PostgresProgram.address(ports), DirectoryTls.NONE, deadlineMs));
  }

  @Test
  void aWrongPasswordIsNamedWithoutIt() throws Exception {
    String address = PostgresProgram.address(List.of(port())).replace("ge%3A", "wrong");
    try (Directory way = Directories.open(address, DirectoryTls.NONE)) {
      DirectoryException e = assertThrows(DirectoryException.class, () -> way.get("a"));
      assertTrue(e.getMessage().contains("check user and password"), e.getMessage());
      assertFalse(e.getMessage().contains("wrong"), e.getMessage());
    }
  }

  @Test
  void aLeaseOutlivesAPauseOfTheDatabase() throws Exception {
    try (PostgresProgram program = new PostgresProgram();
        Directory way =
            Directories.open(PostgresProgram.address(List.of(program.port())), DirectoryTls.NONE)) {
      program.await(way);
      long lease = way.lease(5_000);
      long number = way.create("a", "1", lease);
      Heard heard = new Heard();
      way.watch("", heard);
      await("complete", () -> heard.completes() > 0);
      int before = heard.completes();
      program.kill();
      assertThrows(DirectoryException.class, () -> way.get("a"));
      pass(5_000);
      program.start();
      program.await(way);
      assertTrue(way.renew(lease), "nobody could renew it meanwhile");
      assertEquals(new DirectoryEntry("a", "1", number, lease), way.get("a"));
      await("complete again", () -> heard.completes() > before);
      assertTrue(way.create("b", "1", lease) > number);
      await("watched", () -> heard.values().size() == 2);
      await("it ends", () -> heard.values().isEmpty());
      heard.check();
    }
  }
}

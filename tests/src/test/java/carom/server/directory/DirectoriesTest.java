package carom.server.directory;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Goal: an address that is none is refused with what is wrong, and without its password. */
final class DirectoriesTest {

  @Test
  void etcdIsNamedByItsMembers() throws Exception {
    for (String good :
        List.of(
            "etcd:http://a:2379",
            "etcd:http://a:2379,http://b:2379/, https://[::1]:2379",
            "etcd:https://etcd.example.org")) {
      try (Directory directory = Directories.open(good, DirectoryTls.NONE)) {
        assertInstanceOf(EtcdDirectory.class, directory);
      }
    }
  }

  @Test
  void postgresIsNamedAsByItsOwnTools() throws Exception {
    PostgresAddress address =
        PostgresAddress.parse(
            "--fleet",
            "postgresql://me:ge%3Ah%2Fe%40i%25m+@a:5433,[::1]/db?targetServerType=primary",
            new DirectoryTls(Path.of("ca.pem"), null, null),
            1_000);
    assertEquals("postgresql://a:5433,[::1]/db", address.shown());
    assertEquals("jdbc:postgresql://a:5433,[::1]/db?targetServerType=primary", address.jdbcUrl());
    assertEquals("me", address.properties().getProperty("user"));
    assertEquals("ge:h/e@i%m+", address.properties().getProperty("password"));
    assertEquals("verify-full", address.properties().getProperty("sslmode"));
    assertNull(
        PostgresAddress.parse("--fleet", "postgresql://me@a/db", DirectoryTls.NONE, 1_000)
            .properties()
            .getProperty("password"));
    try (Directory directory = Directories.open("postgresql://a/db", DirectoryTls.NONE)) {
      assertInstanceOf(PostgresDirectory.class, directory);
    }
  }

  @Test
  void whatIsWrongIsSaid() {
    refused("postgresql:a", "needs a host and a database");
    refused("postgresql://me:geheim@a", "needs a host and a database");
    refused("postgresql://me:geheim@a/", "needs a host and a database");
    refused("postgresql://me:geheim/x@a/db", "needs a host and a database");
    refused("postgresql://me:geheim%zz@a/db", "a % in user or password");
    refused("", "no directory that Carom knows");
    refused("zookeeper:a", "no directory that Carom knows");
    refused("etcd:", "needs http://HOST:PORT");
    refused("etcd:a:2379", "needs http://HOST:PORT");
    refused("etcd:http://a:2379,", "needs http://HOST:PORT");
    refused("etcd:ftp://a:2379", "needs http://HOST:PORT");
    refused("etcd:http://a b", "no URL");
    refused("etcd:http://a:2379/v3", "a path behind a port");
    refused("etcd:http://u:geheim@a:2379", "client certificates");
  }

  private static void refused(String address, String problem) {
    IOException e =
        assertThrows(IOException.class, () -> Directories.open(address, DirectoryTls.NONE));
    assertTrue(e.getMessage().startsWith("--fleet "), e.getMessage());
    assertTrue(e.getMessage().contains(problem), e.getMessage());
    assertTrue(e.getMessage().contains("for example"), e.getMessage());
    assertFalse(e.getMessage().contains("geheim"), e.getMessage());
  }

  @Test
  void aFileThatIsMissingIsNamed() {
    IOException e =
        assertThrows(
            IOException.class,
            () ->
                Directories.open(
                    "etcd:https://a", new DirectoryTls(null, Path.of("none.pem"), null)));
    assertEquals(
        "--directory-cert and --directory-key belong together; one is missing", e.getMessage());
    e =
        assertThrows(
            IOException.class,
            () ->
                Directories.open(
                    "etcd:https://a", new DirectoryTls(Path.of("none.pem"), null, null)));
    assertEquals("--directory-ca=none.pem can't be read: there is no none.pem", e.getMessage());
  }
}

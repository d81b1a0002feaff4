package carom.server.directory;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import carom.suite.Needs;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: etcd and a server know each other by certificates. Method: an etcd that asks for those of
 * its clients.
 */
@Timeout(120)
@Needs("processes")
final class EtcdTlsTest {
  @TempDir private Path folder;

  private Path file(String name) {
    return folder.resolve(name);
  }

  @Test
  void bothShowTheirCertificates() throws Exception {
    for (String name : new String[] {"etcd", "client", "stranger"}) {
      TestKeys.make(folder, name);
    }
    // etcd's gateway calls etcd itself with etcd's own certificate.
    Files.writeString(
        file("clients.pem"),
        Files.readString(file("client.pem")) + Files.readString(file("etcd.pem")));
    try (EtcdProgram etcd =
        new EtcdProgram(
            folder,
            "https",
            "--cert-file=" + file("etcd.pem"),
            "--key-file=" + file("etcd.key"),
            "--client-cert-auth",
            "--trusted-ca-file=" + file("clients.pem"))) {
      String address = "etcd:" + etcd.url();
      try (Directory directory = Directories.open(address, tls("etcd", "client"))) {
        etcd.await(directory);
        Heard heard = new Heard();
        directory.watch("", heard);
        long number = directory.create("a", "1", directory.lease(60_000));
        assertEquals(number, directory.get("a").number());
        for (int i = 0; heard.values().isEmpty() && i < 500; i++) {
          Thread.sleep(10);
        }
        assertEquals(number, heard.number("a"));
      }
      refused(address, tls("stranger", "client"));
      refused(address, tls("etcd", "stranger"));
      refused(address, new DirectoryTls(file("etcd.pem"), null, null));
      refused(address, DirectoryTls.NONE);
    }
  }

  private DirectoryTls tls(String ca, String own) {
    return new DirectoryTls(file(ca + ".pem"), file(own + ".pem"), file(own + ".key"));
  }

  private static void refused(String address, DirectoryTls tls) throws Exception {
    try (Directory directory = Directories.open(address, tls)) {
      assertThrows(DirectoryException.class, () -> directory.get("a"));
    }
  }
}

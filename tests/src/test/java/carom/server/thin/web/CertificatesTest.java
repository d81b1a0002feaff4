package carom.server.thin.web;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.suite.Needs;
import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.FileTime;
import java.security.KeyStore;
import java.security.cert.Certificate;
import java.security.cert.X509Certificate;
import java.util.Base64;
import java.util.List;
import java.util.Set;
import javax.net.ssl.SSLContext;
import javax.net.ssl.SSLSocket;
import javax.net.ssl.TrustManager;
import javax.net.ssl.X509TrustManager;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: the play port is encrypted with the operator's files, read again when they change, and bad
 * files are named. Method: keys that keytool makes, and TLS connections of the JDK.
 */
@Timeout(180)
@Needs("processes")
final class CertificatesTest {
  private static final char[] PASSWORD = "password".toCharArray();

  @TempDir private Path folder;

  /** Writes the certificate and the key of a name as PEM. */
  private void make(String name, String algorithm) throws Exception {
    Path store = folder.resolve(name + ".p12");
    Path keytool = Path.of(System.getProperty("java.home"), "bin", "keytool");
    Process process =
        new ProcessBuilder(
                keytool.toString(),
                "-genkeypair",
                "-alias",
                "a",
                "-keyalg",
                algorithm,
                "-dname",
                "CN=" + name,
                "-storetype",
                "PKCS12",
                "-storepass",
                new String(PASSWORD),
                "-keystore",
                store.toString())
            .redirectErrorStream(true)
            .redirectOutput(folder.resolve("keytool.txt").toFile())
            .start();
    assertEquals(0, process.waitFor(), Files.readString(folder.resolve("keytool.txt")));
    KeyStore keys = KeyStore.getInstance("PKCS12");
    try (InputStream in = Files.newInputStream(store)) {
      keys.load(in, PASSWORD);
    }
    StringBuilder chain = new StringBuilder("Bag Attributes\n    friendlyName: a\n");
    for (Certificate certificate : keys.getCertificateChain("a")) {
      chain.append(pem("CERTIFICATE", certificate.getEncoded()));
    }
    Files.writeString(folder.resolve(name + ".pem"), chain);
    Files.writeString(
        folder.resolve(name + ".key"), pem("PRIVATE KEY", keys.getKey("a", PASSWORD).getEncoded()));
  }

  private static String pem(String kind, byte[] bytes) {
    String text = Base64.getMimeEncoder(64, new byte[] {'\n'}).encodeToString(bytes);
    return "-----BEGIN " + kind + "-----\n" + text + "\n-----END " + kind + "-----\n";
  }

  private void use(String cert, String key) throws IOException {
    Files.copy(folder.resolve(cert + ".pem"), file("used.pem"), REPLACE);
    Files.copy(folder.resolve(key + ".key"), file("used.key"), REPLACE);
    for (String name : List.of("used.pem", "used.key")) {
      Files.setLastModifiedTime(file(name), FileTime.fromMillis(1_000_000L * ++changes));
    }
  }

  private static final StandardCopyOption REPLACE = StandardCopyOption.REPLACE_EXISTING;

  private int changes;

  private Path file(String name) {
    return folder.resolve(name);
  }

  /** Trusts whatever comes, and remembers it. */
  private static final class Anything implements X509TrustManager {
    private String name = "";

    @Override
    public void checkClientTrusted(X509Certificate[] chain, String type) {}

    @Override
    public void checkServerTrusted(X509Certificate[] chain, String type) {
      name = chain[0].getSubjectX500Principal().getName();
    }

    @Override
    public X509Certificate[] getAcceptedIssuers() {
      return new X509Certificate[0];
    }
  }

  /** Returns the name of the certificate that a new connection is shown. */
  private static String shown(PlayPort port) throws Exception {
    Anything trust = new Anything();
    SSLContext context = SSLContext.getInstance("TLS");
    context.init(null, new TrustManager[] {trust}, null);
    try (SSLSocket socket =
        (SSLSocket)
            context
                .getSocketFactory()
                .createSocket(InetAddress.getLoopbackAddress(), port.tcpPort())) {
      socket.setSoTimeout(30_000);
      socket.startHandshake();
      socket
          .getOutputStream()
          .write(
              "GET /play/ HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n"
                  .getBytes(UTF_8));
      String answer = new String(socket.getInputStream().readAllBytes(), UTF_8);
      assertTrue(answer.startsWith("HTTP/1.1 200 "), answer);
    }
    return trust.name;
  }

  @Test
  void encryptsAndFollowsTheFiles() throws Exception {
    make("one", "RSA");
    make("two", "EC");
    use("one", "one");
    Certificates certificates = Certificates.of(file("used.pem"), file("used.key"));
    InetAddress here = InetAddress.getLoopbackAddress();
    try (PlayPort port =
        new PlayPort(
            new PlayPort.Settings(List.of(here), 0, Set.of(), List.of(), 8, 8, certificates))) {
      assertTrue(port.url().startsWith("https://"), port.url());
      assertEquals("CN=one", shown(port));
      assertFalse(certificates.refresh());
      use("two", "one"); // half a renewal
      assertFalse(certificates.refresh());
      assertEquals("CN=one", shown(port));
      use("two", "two");
      assertTrue(certificates.refresh());
      assertEquals("CN=two", shown(port));
      Files.delete(file("used.key"));
      assertFalse(certificates.refresh());
      assertEquals("CN=two", shown(port));
      try (Socket plain = new Socket(here, port.tcpPort())) {
        plain.setSoTimeout(30_000);
        plain.getOutputStream().write("GET / HTTP/1.1\r\nHost: localhost\r\n\r\n".getBytes(UTF_8));
        String answer = new String(plain.getInputStream().readAllBytes(), UTF_8);
        assertFalse(answer.startsWith("HTTP"), answer);
      }
      assertEquals("CN=two", shown(port), "others go on");
    }
  }

  private String problem(String cert, String key) {
    IOException e = assertThrows(IOException.class, () -> Certificates.of(file(cert), file(key)));
    return e.getMessage().replace(folder.toString(), "F");
  }

  @Test
  void badFilesAreNamed() throws Exception {
    make("one", "RSA");
    make("two", "Ed25519");
    Certificates.of(file("two.pem"), file("two.key"));
    assertTrue(problem("no.pem", "one.key").startsWith("--tls-cert=F/no.pem can't be read: "));
    assertTrue(problem("one.key", "one.key").startsWith("--tls-cert=F/one.key has no certificate"));
    assertTrue(problem("one.pem", "one.pem").startsWith("--tls-key=F/one.pem has no key"));
    assertEquals(
        "--tls-key=F/two.key doesn't belong to the first certificate of --tls-cert=F/one.pem",
        problem("one.pem", "two.key"));
    Files.writeString(file("old.key"), pem("RSA PRIVATE KEY", new byte[64]));
    assertTrue(problem("one.pem", "old.key").contains("is of the form RSA; it must be PKCS #8"));
    Files.writeString(file("locked.key"), pem("ENCRYPTED PRIVATE KEY", new byte[64]));
    assertTrue(problem("one.pem", "locked.key").contains("is protected by a password"));
    Files.writeString(file("bad.key"), pem("PRIVATE KEY", new byte[64]));
    assertTrue(problem("one.pem", "bad.key").contains("is damaged"));
    Files.writeString(file("bad.pem"), pem("CERTIFICATE", new byte[64]));
    assertTrue(problem("bad.pem", "one.key").contains("a certificate that can't be read"));
    assertTrue(problem("", "one.key").startsWith("--tls-cert=F"), problem("", "one.key"));
  }
}

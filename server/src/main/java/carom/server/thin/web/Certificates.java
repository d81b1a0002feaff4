package carom.server.thin.web;

import carom.server.http.Pem;
import java.io.IOException;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.Principal;
import java.security.PrivateKey;
import java.security.cert.X509Certificate;
import java.time.Instant;
import java.util.List;
import javax.net.ssl.KeyManager;
import javax.net.ssl.SSLContext;
import javax.net.ssl.SSLEngine;
import javax.net.ssl.X509ExtendedKeyManager;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The server's certificates and their key, from two PEM files that are read again when they change.
 * Files that can't be used leave those before in force, as a renewal may be half done. New
 * connections get the newest; any thread.
 */
final class Certificates {
  private static final Logger LOG = LoggerFactory.getLogger(Certificates.class);
  private static final String ALIAS = "play";

  private final Path certFile;
  private final Path keyFile;
  private final SSLContext context;
  private volatile Pair pair;
  private String stamps;
  private String problemTold = "";

  /** A chain, the server's own certificate first, with its key. */
  private record Pair(List<X509Certificate> chain, PrivateKey key) {}

  private Certificates(Path certFile, Path keyFile) throws IOException {
    this.certFile = certFile;
    this.keyFile = keyFile;
    stamps = stamps();
    pair = read();
    try {
      context = SSLContext.getInstance("TLS");
      context.init(new KeyManager[] {new Newest()}, null, null);
    } catch (GeneralSecurityException e) {
      throw new IOException("TLS isn't available: " + e.getMessage(), e);
    }
  }

  /**
   * Reads the files.
   *
   * @param certFile certificates, PEM, the server's own first
   * @param keyFile its private key, PEM, PKCS #8 without a password
   * @throws IOException if they can't be used; names the file and says what is wrong
   */
  public static Certificates of(Path certFile, Path keyFile) throws IOException {
    return new Certificates(certFile, keyFile);
  }

  /** Returns the context of connections; it hands out the newest certificates. */
  public SSLContext context() {
    return context;
  }

  /** Returns when the server's own certificate ends. */
  public Instant end() {
    return pair.chain.get(0).getNotAfter().toInstant();
  }

  /**
   * Reads the files again if they have changed, and logs what came of it. One thread.
   *
   * @return whether other certificates are in force now
   */
  public boolean refresh() {
    String now = stamps();
    if (now.equals(stamps)) {
      return false;
    }
    try {
      pair = read();
      stamps = now;
      problemTold = "";
      LOG.info("play: certificate in {} read again, good until {}", certFile, end());
      return true;
    } catch (IOException e) {
      if (!e.getMessage().equals(problemTold)) {
        LOG.warn("play: the certificate before stays in force: {}", e.getMessage());
        problemTold = e.getMessage(); // and again next time: the other file may follow
      }
      return false;
    }
  }

  /** Returns a text that changes when a file does. */
  private String stamps() {
    return stamp(certFile) + stamp(keyFile);
  }

  private static String stamp(Path file) {
    try {
      return Files.size(file) + "@" + Files.getLastModifiedTime(file).toMillis() + " ";
    } catch (IOException e) {
      return "none ";
    }
  }

  private Pair read() throws IOException {
    List<X509Certificate> chain = Pem.certificates("--tls-cert", certFile);
    Instant end = chain.get(0).getNotAfter().toInstant();
    if (end.isBefore(Instant.now())) {
      LOG.warn("play: the certificate in {} ended on {}; browsers refuse it", certFile, end);
    }
    return new Pair(chain, Pem.key("--tls-key", keyFile, "--tls-cert=" + certFile, chain.get(0)));
  }

  /** Hands out the newest certificates. */
  private final class Newest extends X509ExtendedKeyManager {
    @Override
    public String chooseEngineServerAlias(String type, Principal[] issuers, SSLEngine engine) {
      return fits(type) ? ALIAS : null;
    }

    @Override
    public String chooseServerAlias(String type, Principal[] issuers, Socket socket) {
      return fits(type) ? ALIAS : null;
    }

    private boolean fits(String type) {
      String own = pair.key.getAlgorithm();
      return type.equals(own)
          || (own.equals("EdDSA") && type.startsWith("Ed"))
          || type.startsWith(own + "_");
    }

    @Override
    public String[] getServerAliases(String type, Principal[] issuers) {
      return fits(type) ? new String[] {ALIAS} : new String[0];
    }

    @Override
    public X509Certificate[] getCertificateChain(String alias) {
      return pair.chain.toArray(X509Certificate[]::new);
    }

    @Override
    public PrivateKey getPrivateKey(String alias) {
      return pair.key;
    }

    @Override
    public String[] getClientAliases(String type, Principal[] issuers) {
      return new String[0];
    }

    @Override
    public String chooseClientAlias(String[] types, Principal[] issuers, Socket socket) {
      return null;
    }
  }
}

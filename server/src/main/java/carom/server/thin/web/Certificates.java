package carom.server.thin.web;

import static java.nio.charset.StandardCharsets.ISO_8859_1;

import carom.text.FileErrors;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyFactory;
import java.security.Principal;
import java.security.PrivateKey;
import java.security.Signature;
import java.security.cert.CertificateException;
import java.security.cert.CertificateFactory;
import java.security.cert.X509Certificate;
import java.security.spec.PKCS8EncodedKeySpec;
import java.time.Instant;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
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
  private static final int MAX_FILE_BYTES = 1 << 20;
  private static final Pattern KEY =
      Pattern.compile("-----BEGIN ([A-Z ]*)PRIVATE KEY-----([^-]*)-----END");

  /**
   * Algorithms of keys, each with that of a signature by which key and certificate are compared.
   */
  private static final Map<String, String> ALGORITHMS =
      Map.of("RSA", "SHA256withRSA", "EC", "SHA256withECDSA", "EdDSA", "EdDSA");

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
    X509Certificate[] chain = certificates();
    PrivateKey key = key(chain[0]);
    return new Pair(List.of(chain), key);
  }

  private static String text(String flag, Path file) throws IOException {
    String text;
    try {
      text = Files.size(file) > MAX_FILE_BYTES ? null : Files.readString(file, ISO_8859_1);
    } catch (IOException e) {
      throw new IOException(flag + "=" + file + " can't be read: " + FileErrors.reason(e), e);
    }
    if (text == null) {
      throw new IOException(flag + "=" + file + " has more than " + MAX_FILE_BYTES + " bytes");
    }
    return text;
  }

  private X509Certificate[] certificates() throws IOException {
    String text = text("--tls-cert", certFile);
    if (!text.contains("-----BEGIN CERTIFICATE-----")) {
      throw new IOException(
          "--tls-cert="
              + certFile
              + " has no certificate; it must be PEM, with a line -----BEGIN CERTIFICATE-----");
    }
    String first = text.substring(text.indexOf("-----BEGIN CERTIFICATE-----"));
    try {
      X509Certificate[] chain =
          CertificateFactory.getInstance("X.509")
              .generateCertificates(new ByteArrayInputStream(first.getBytes(ISO_8859_1)))
              .toArray(X509Certificate[]::new);
      if (chain[0].getNotAfter().toInstant().isBefore(Instant.now())) {
        LOG.warn(
            "play: the certificate in {} ended on {}; browsers refuse it",
            certFile,
            chain[0].getNotAfter().toInstant());
      }
      return chain;
    } catch (CertificateException | ArrayStoreException e) {
      throw new IOException(
          "--tls-cert=" + certFile + " has a certificate that can't be read: " + e.getMessage(), e);
    }
  }

  private PrivateKey key(X509Certificate certificate) throws IOException {
    String name = "--tls-key=" + keyFile;
    Matcher found = KEY.matcher(text("--tls-key", keyFile));
    if (!found.find()) {
      throw new IOException(
          name + " has no key; it must be PEM, with a line -----BEGIN PRIVATE KEY-----");
    }
    String form = found.group(1).strip();
    if (!form.isEmpty()) {
      throw new IOException(
          name
              + " is "
              + (form.equals("ENCRYPTED") ? "protected by a password" : "of the form " + form)
              + "; it must be PKCS #8 without one: openssl pkcs8 -topk8 -nodes -in OLD -out NEW");
    }
    byte[] bytes;
    try {
      bytes = Base64.getMimeDecoder().decode(found.group(2));
    } catch (IllegalArgumentException e) {
      throw new IOException(name + " is damaged: " + e.getMessage(), e);
    }
    for (Map.Entry<String, String> algorithm : ALGORITHMS.entrySet()) {
      PrivateKey key = key(bytes, algorithm.getKey());
      if (key != null && belongs(key, certificate, algorithm.getValue())) {
        return key;
      } else if (key != null) {
        throw new IOException(
            name + " doesn't belong to the first certificate of --tls-cert=" + certFile);
      }
    }
    throw new IOException(name + " is damaged, or of none of the algorithms RSA, EC and Ed25519");
  }

  /** Returns the key, or null if it is none of an algorithm. */
  private static PrivateKey key(byte[] bytes, String algorithm) {
    try {
      return KeyFactory.getInstance(algorithm).generatePrivate(new PKCS8EncodedKeySpec(bytes));
    } catch (GeneralSecurityException e) {
      return null;
    }
  }

  private static boolean belongs(PrivateKey key, X509Certificate certificate, String algorithm) {
    byte[] text = {1, 2, 3};
    try {
      Signature signature = Signature.getInstance(algorithm);
      signature.initSign(key);
      signature.update(text);
      byte[] signed = signature.sign();
      signature.initVerify(certificate.getPublicKey());
      signature.update(text);
      return signature.verify(signed);
    } catch (GeneralSecurityException e) {
      return false; // a key of another algorithm
    }
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

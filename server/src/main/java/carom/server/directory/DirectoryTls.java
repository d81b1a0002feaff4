package carom.server.directory;

import carom.server.http.Pem;
import java.io.IOException;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.security.PrivateKey;
import java.security.cert.Certificate;
import java.security.cert.X509Certificate;
import java.util.List;
import javax.net.ssl.KeyManager;
import javax.net.ssl.KeyManagerFactory;
import javax.net.ssl.SSLContext;
import javax.net.ssl.TrustManager;
import javax.net.ssl.TrustManagerFactory;

/**
 * Files by which a server knows its directory, and the directory the server: PEM, read once.
 *
 * @param ca certificates of the authorities that the directory's own must come from; null for those
 *     of the JDK
 * @param cert the server's certificate, its own first; null if the directory asks for none
 * @param key its private key, PKCS #8 without a password; null without a certificate
 */
public record DirectoryTls(Path ca, Path cert, Path key) {
  private static final String CA_FLAG = "--directory-ca";
  private static final String CERT_FLAG = "--directory-cert";
  private static final String KEY_FLAG = "--directory-key";

  /** Trusts the authorities of the JDK and shows no certificate. */
  public static final DirectoryTls NONE = new DirectoryTls(null, null, null);

  /**
   * Reads the files.
   *
   * @throws IOException if they can't be used; says which and why
   */
  SSLContext context() throws IOException {
    if ((cert == null) != (key == null)) {
      throw new IOException(CERT_FLAG + " and " + KEY_FLAG + " belong together; one is missing");
    }
    try {
      SSLContext context = SSLContext.getInstance("TLS");
      context.init(keys(), authorities(), null);
      return context;
    } catch (GeneralSecurityException e) {
      throw new IOException("TLS isn't available: " + e.getMessage(), e);
    }
  }

  private TrustManager[] authorities() throws IOException, GeneralSecurityException {
    if (ca == null) {
      return null;
    }
    KeyStore store = KeyStore.getInstance(KeyStore.getDefaultType());
    store.load(null, null);
    int i = 0;
    for (X509Certificate certificate : Pem.certificates(CA_FLAG, ca)) {
      store.setCertificateEntry("ca" + i++, certificate);
    }
    TrustManagerFactory factory =
        TrustManagerFactory.getInstance(TrustManagerFactory.getDefaultAlgorithm());
    factory.init(store);
    return factory.getTrustManagers();
  }

  private KeyManager[] keys() throws IOException, GeneralSecurityException {
    if (cert == null) {
      return null;
    }
    List<X509Certificate> chain = Pem.certificates(CERT_FLAG, cert);
    PrivateKey own = Pem.key(KEY_FLAG, key, CERT_FLAG + "=" + cert, chain.get(0));
    KeyStore store = KeyStore.getInstance(KeyStore.getDefaultType());
    store.load(null, null);
    char[] password = new char[0];
    store.setKeyEntry("own", own, password, chain.toArray(new Certificate[0]));
    KeyManagerFactory factory =
        KeyManagerFactory.getInstance(KeyManagerFactory.getDefaultAlgorithm());
    factory.init(store, password);
    return factory.getKeyManagers();
  }
}

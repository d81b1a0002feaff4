package carom.server.http;

import static java.nio.charset.StandardCharsets.ISO_8859_1;

import carom.text.FileErrors;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyFactory;
import java.security.PrivateKey;
import java.security.Signature;
import java.security.cert.CertificateException;
import java.security.cert.CertificateFactory;
import java.security.cert.X509Certificate;
import java.security.spec.PKCS8EncodedKeySpec;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Reads certificates and keys that an operator keeps in PEM files. */
public final class Pem {
  private static final int MAX_FILE_BYTES = 1 << 20;
  private static final Pattern KEY =
      Pattern.compile("-----BEGIN ([A-Z ]*)PRIVATE KEY-----([^-]*)-----END");

  /**
   * Algorithms of keys, each with that of a signature by which key and certificate are compared.
   */
  private static final Map<String, String> ALGORITHMS =
      Map.of("RSA", "SHA256withRSA", "EC", "SHA256withECDSA", "EdDSA", "EdDSA");

  private Pem() {}

  /**
   * Reads certificates, in the order of the file.
   *
   * @param flag name of the setting, for errors
   * @throws IOException if the file has none or can't be read; says why
   */
  public static List<X509Certificate> certificates(String flag, Path file) throws IOException {
    String text = text(flag, file);
    if (!text.contains("-----BEGIN CERTIFICATE-----")) {
      throw new IOException(
          flag
              + "="
              + file
              + " has no certificate; it must be PEM, with a line -----BEGIN CERTIFICATE-----");
    }
    String first = text.substring(text.indexOf("-----BEGIN CERTIFICATE-----"));
    try {
      return List.of(
          CertificateFactory.getInstance("X.509")
              .generateCertificates(new ByteArrayInputStream(first.getBytes(ISO_8859_1)))
              .toArray(X509Certificate[]::new));
    } catch (CertificateException | ArrayStoreException e) {
      throw new IOException(
          flag + "=" + file + " has a certificate that can't be read: " + e.getMessage(), e);
    }
  }

  /**
   * Reads the private key of a certificate: PKCS #8 without a password.
   *
   * @param flag name of the setting, for errors
   * @param certificateFile setting and file of the certificate, for errors
   * @throws IOException if the file has none, or that of another certificate; says why
   */
  public static PrivateKey key(
      String flag, Path file, String certificateFile, X509Certificate certificate)
      throws IOException {
    String name = flag + "=" + file;
    Matcher found = KEY.matcher(text(flag, file));
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
            name + " doesn't belong to the first certificate of " + certificateFile);
      }
    }
    throw new IOException(name + " is damaged, or of none of the algorithms RSA, EC and Ed25519");
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
}

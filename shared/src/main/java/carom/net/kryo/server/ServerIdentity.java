package carom.net.kryo.server;

import carom.net.seal.Encryption;
import carom.net.seal.ExchangeKey;
import carom.net.seal.ServerKey;

/**
 * The encryption and the key by which clients know a server.
 *
 * @param encryption whether links are encrypted; a client that differs is refused
 * @param key the lasting pair of keys
 */
public record ServerIdentity(Encryption encryption, ExchangeKey key) {

  /** Returns a new identity, which is lost when the process ends. */
  public static ServerIdentity temporary(Encryption encryption) {
    return new ServerIdentity(encryption, ExchangeKey.random());
  }

  /** Returns the fingerprint of the key, for people. */
  public String fingerprint() {
    return ServerKey.fingerprint(key.publicKey());
  }
}

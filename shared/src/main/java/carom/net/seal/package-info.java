/**
 * Keys and sealed frames: how the two ends of a link agree on keys, and how they encrypt and
 * authenticate what they send. The handshake is Noise's NK, made of the JDK's own X25519,
 * HMAC-SHA256 and AES-GCM. It opens no socket.
 *
 * <p>Imports {@code carom.text}.
 *
 * <p>Read first: {@link carom.net.seal.KeyExchange}, {@link carom.net.seal.DatagramSealer}, {@link
 * carom.net.seal.KnownServers}.
 */
package carom.net.seal;

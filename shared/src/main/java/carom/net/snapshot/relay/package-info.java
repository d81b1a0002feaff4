/**
 * The relay section of a datagram: inputs of other players that are near.
 *
 * <p>May import {@code carom.net.codec}, {@code protocol} and {@code snapshot.frame}. Read first:
 * {@link carom.net.snapshot.relay.RelayCodec}.
 */
package carom.net.snapshot.relay;

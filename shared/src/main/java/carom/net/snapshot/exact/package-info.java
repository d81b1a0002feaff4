/**
 * The exact section of a datagram: the state of the own body and of the predicted set, bit for bit,
 * as far as the client can't compute it.
 *
 * <p>May import {@code carom.net.codec}, {@code snapshot.frame} and {@code snapshot.relay}. Read
 * first: {@link carom.net.snapshot.exact.OwnState}, {@link carom.net.snapshot.exact.NearState},
 * {@link carom.net.snapshot.exact.NearRowCodec}.
 */
package carom.net.snapshot.exact;

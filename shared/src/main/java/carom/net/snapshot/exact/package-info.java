/**
 * The exact section of a datagram: the state of the own body and of the predicted set, bit for bit,
 * as far as the client can't compute it.
 *
 * <p>May import {@code carom.net.codec}, {@code snapshot.frame}, {@code snapshot.relay}, and {@code
 * carom.physics.rows} for what a row holds. Read first: {@link carom.net.snapshot.exact.OwnState},
 * {@link carom.net.snapshot.exact.NearState}, {@link carom.net.snapshot.exact.NearRowCodec}.
 */
package carom.net.snapshot.exact;

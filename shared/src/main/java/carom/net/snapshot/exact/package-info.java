/**
 * The exact section of a datagram: the parts of the state of the own body and the predicted set
 * that the client can't compute, bit for bit; and the relay section: inputs of other players that
 * are near.
 *
 * <p>May import {@code carom.net.codec}, {@code carom.net.protocol}, {@code snapshot.frame}, {@code
 * snapshot.ledger}, and {@code carom.physics.rows} for what a row holds. Read first: {@link
 * carom.net.snapshot.exact.OwnState}, {@link carom.net.snapshot.exact.NearState}, {@link
 * carom.net.snapshot.exact.NearRowCodec}.
 */
package carom.net.snapshot.exact;

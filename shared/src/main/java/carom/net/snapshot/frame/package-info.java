/**
 * The quantised state of a room, tick by tick: what all sessions share before anything is coded;
 * and the events section of a datagram: each event reaches each client exactly once and in order.
 * The ring of frames also keeps the room's events.
 *
 * <p>May import {@code carom.net.codec}, {@code protocol} and {@code snapshot.ledger}. Read first:
 * {@link carom.net.snapshot.frame.FrameState}, {@link carom.net.snapshot.frame.FrameRing}, {@link
 * carom.net.snapshot.Predictor}.
 */
package carom.net.snapshot.frame;

/**
 * The quantised state of a room, tick by tick: what all sessions share before anything is coded.
 *
 * <p>May import {@code carom.net.codec}, {@code protocol} and {@code snapshot.event}: the ring of
 * frames also keeps the room's events. Read first: {@link carom.net.snapshot.frame.FrameState},
 * {@link carom.net.snapshot.frame.FrameRing}, {@link carom.net.snapshot.record.Predictor}.
 */
package carom.net.snapshot.frame;

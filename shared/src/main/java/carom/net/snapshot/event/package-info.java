/**
 * The events section of a datagram: each event reaches each client exactly once and in order.
 *
 * <p>May import {@code carom.net.codec}, {@code protocol} and {@code snapshot.ledger}. Read first:
 * {@link carom.net.snapshot.event.EventRecord}, {@link carom.net.snapshot.event.EventOutbox},
 * {@link carom.net.snapshot.event.EventInbox}.
 */
package carom.net.snapshot.event;

/**
 * The table section of a datagram: small state by key, such as the fields of players and entities
 * or the definitions of joints. Each client is told what it lacks of what it may know.
 *
 * <p>A {@link carom.net.snapshot.table.Table} has rows by key. A row has an identity and a fixed
 * number of int words, each of a fixed width, and begins at start values that both sides know. The
 * sender tells what differs:
 *
 * <pre>
 *    Table  (one per room)                TableOutbox (one per session)         TableInbox (client)
 *  ┌─────┬──────────┬──────────────┐    ┌──────────────────────────────┐      ┌──────────────────┐
 *  │ key │ identity │ words, ticks │    │ acked tick, audience by key  │      │ tick, identity,  │
 *  ├─────┼──────────┼──────────────┤ ─► │ due: in sight, changed since │ ───► │ words by key     │
 *  │  12 │       3  │ 100  0  7    │    │ the ack, not on its way      │      │                  │
 *  └─────┴──────────┴──────────────┘    └──────────────────────────────┘      └──────────────────┘
 *      put, remove          start values ↔ the row isn't sent          words unlike the acked ones
 * </pre>
 *
 * <p>A row is told whole, as its words that differ from the start, or as the words that changed
 * since the tick that the client acked. Rows are never queued: a lost one is healed by its newest
 * words.
 *
 * <p>Sees arrays, no world. May import {@code carom.net.codec}, {@code snapshot.frame}, {@code
 * snapshot.ledger} and {@code carom.physics.rows}. Read first: {@link
 * carom.net.snapshot.table.TableLayout}, {@link carom.net.snapshot.table.Table}, {@link
 * carom.net.snapshot.table.TableOutbox}.
 */
package carom.net.snapshot.table;

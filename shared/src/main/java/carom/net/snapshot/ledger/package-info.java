/**
 * The ledger of what one client was sent, and of what it got.
 *
 * <pre>
 *   section ── append(what) ──► DatagramLedger ◄── receive(acknowledgements)
 *           ◄─ acknowledged / lost, once for each thing appended ──┘
 *
 *   section                  appends for a datagram         sends again what has not arrived
 *   records: ClientKnowledge 64 neighbouring slots          newest state, in each snapshot
 *   own section: OwnAcks     that it is there               newest state, in each snapshot
 *   updates: UpdateDelivery  a range of rows                WHEN_LOST; two copies if the line loses
 *   rulings: RulingDelivery  each ruling                    WHEN_LOST; one copy more if it does
 *   events: EventOutbox      which events                   WHEN_OVERDUE; two copies at first
 *   tables: TableOutbox      each row                       WHEN_OVERDUE; urgent EACH_SNAPSHOT
 * </pre>
 *
 * <p>Imports nothing of Carom but {@code carom.net.codec}. Read first: {@link
 * carom.net.snapshot.ledger.DatagramLedger}, {@link carom.net.snapshot.ledger.Resend}.
 */
package carom.net.snapshot.ledger;

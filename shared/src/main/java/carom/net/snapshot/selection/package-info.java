/**
 * Selects the content of a snapshot from what a client knows of each entity.
 *
 * <p>{@code ClientKnowledge} answers which entities are news for the client and against which tick
 * they are coded. {@code Selection} orders them by the priority that they have collected.
 *
 * <p>Imports {@code carom.net.codec}, {@code carom.net.protocol} and the sections of the snapshot.
 *
 * <p>Read first: {@link carom.net.snapshot.selection.Interest}, {@link
 * carom.net.snapshot.selection.ClientKnowledge}, {@link carom.net.snapshot.selection.Selection}.
 */
package carom.net.snapshot.selection;

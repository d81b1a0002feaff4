/**
 * Decides who may wait at a server's door, and who gives way. It has groups of addresses, places
 * for connections that have proven little, budgets that refill, and a proof of work for times of
 * pressure. It knows no sockets.
 *
 * <p>Imports the JDK only.
 *
 * <p>Read first: {@link carom.net.admission.Entrance}, {@link carom.net.admission.WorkProof}.
 */
package carom.net.admission;

/**
 * A fleet: several servers that are one service. Each room belongs to one of them at a time, by a
 * claim in the fleet's directory; another one follows it and goes on with it if its owner dies.
 *
 * <p>Allowed imports: {@code carom.net.protocol}, {@code carom.net.seal}, {@code
 * carom.server.checkpoint}, {@code carom.server.command}, {@code carom.server.config}, {@code
 * carom.server.directory}, {@code carom.server.metrics}, {@code carom.server.room}, {@code
 * carom.server.session}, {@code carom.text}, the JDK, Jackson and SLF4J.
 *
 * <p>Read first: {@link carom.server.fleet.FleetMember}, {@link carom.server.fleet.FleetView},
 * {@link carom.server.fleet.Lease}.
 */
package carom.server.fleet;

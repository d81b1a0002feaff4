/**
 * Lays out the tables in which a game's fields are sent. Server and client derive the layouts from
 * the same declarations.
 *
 * <p>The one package of {@code carom.net} that knows of fields. May import {@code
 * carom.net.protocol}, {@code carom.net.snapshot.table}, {@code carom.sim.event}, {@code
 * carom.sim.field} and {@code carom.sim.message}. Read first: {@link carom.net.field.FieldTables}.
 */
package carom.net.field;

/**
 * The constants of a world: one list, which users change through {@code carom.physics.WorldDef} and
 * the stages of the step read.
 *
 * <p>Imports nothing, and is exported: the accessors of {@code WorldDef} are declared here.
 */
package carom.physics.settings;

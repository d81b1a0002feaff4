/**
 * The constants of a world: one row for each, from which all else follows. Users change them
 * through {@code carom.physics.WorldDef}, the stages of the step read them.
 *
 * <p>Imports {@code math} and {@code archive}, and is exported: the accessors of {@code WorldDef}
 * are declared here.
 */
package carom.physics.settings;

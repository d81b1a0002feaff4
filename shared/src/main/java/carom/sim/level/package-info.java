/**
 * Levels: the file format and its reader, archetypes and appearances.
 *
 * <p>May import {@code carom.physics} and what it exports. Read first: {@link
 * carom.sim.level.Level}, {@link carom.sim.level.ArchetypeDef}, {@link
 * carom.sim.level.LevelReader}.
 */
package carom.sim.level;

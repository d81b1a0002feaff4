/**
 * Numbers in a fixed order, from which a state can be made again: in a file, on another machine.
 *
 * <p>An {@link carom.physics.archive.Archive} is passed through a state, which names each of its
 * numbers once, for both directions: an {@link carom.physics.archive.ArchiveWriter} takes them, an
 * {@link carom.physics.archive.ArchiveReader} gives those that were taken, and trusts none.
 *
 * <p>Allowed imports: the language.
 */
package carom.physics.archive;

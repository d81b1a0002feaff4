/**
 * Archives: the numbers of a state in a fixed order, from which the state can be restored from a
 * file or on another machine.
 *
 * <p>A state passes each of its numbers once through an {@link carom.physics.archive.Archive}, for
 * both directions. An {@link carom.physics.archive.ArchiveWriter} collects the numbers. An {@link
 * carom.physics.archive.ArchiveReader} returns them and trusts none.
 *
 * <p>Allowed imports: the language.
 */
package carom.physics.archive;

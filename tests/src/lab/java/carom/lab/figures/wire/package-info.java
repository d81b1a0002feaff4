/**
 * Figures of what goes over the wire: sizes and times of snapshots, what a naive broadcast would
 * send instead, and the laboratory's own codec.
 *
 * <p>Read first: {@link carom.lab.figures.wire.SnapshotFigures}, {@link
 * carom.lab.figures.wire.EncodeFigures}.
 */
package carom.lab.figures.wire;

/**
 * The records section of a datagram: each entity in sight, absolute or as the difference to a
 * baseline.
 *
 * <p>May import {@code carom.net.codec}, {@code protocol} and {@code snapshot.frame}. Read first:
 * {@link carom.net.snapshot.record.RecordCodec}, {@link carom.net.snapshot.record.DeltaCodec},
 * {@link carom.net.snapshot.record.Predictor}, {@link carom.net.snapshot.record.Deltas}.
 */
package carom.net.snapshot.record;

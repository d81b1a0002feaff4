/**
 * Messages between a Carom server and programs with stock KryoNet: classes with public fields, and
 * nothing else of Carom. {@code docs/protocol/THIN.md} says what they mean.
 *
 * <p>Read first: {@link carom.plain.Plain}, {@link carom.plain.Input}, {@link
 * carom.plain.Snapshot}.
 */
package carom.plain;

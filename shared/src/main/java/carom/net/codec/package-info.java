/**
 * Bits, widths, quantisers, sequence numbers: the small tools that the wire is made of. Pure
 * functions and bounded readers; no worlds, no messages.
 *
 * <p>Imports the JDK only.
 *
 * <p>Read first: {@link carom.net.codec.BitWriter}, {@link carom.net.codec.BitReader}, {@link
 * carom.net.codec.Quantizer}.
 */
package carom.net.codec;

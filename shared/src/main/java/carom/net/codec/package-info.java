/**
 * Bit-level tools of the wire format: bits, widths, quantisers, sequence numbers and the arithmetic
 * coder. The package holds pure functions and bounded readers and writers; it knows no worlds and
 * no messages.
 *
 * <p>Imports the JDK only.
 *
 * <p>Read first: {@link carom.net.codec.BitWriter}, {@link carom.net.codec.BitReader}, {@link
 * carom.net.codec.Quantizer}.
 */
package carom.net.codec;

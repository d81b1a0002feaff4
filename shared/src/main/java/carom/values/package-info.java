/**
 * Immutable values, such as settings, of which changed copies are made.
 *
 * <p>Allowed imports: the JDK.
 *
 * <p>Read first: {@link carom.values.Records}.
 */
package carom.values;

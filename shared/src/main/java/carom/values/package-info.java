/**
 * Support for immutable values, such as settings, that are changed by copying.
 *
 * <p>Allowed imports: the JDK.
 *
 * <p>Read first: {@link carom.values.Records}.
 */
package carom.values;

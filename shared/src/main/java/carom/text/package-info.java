/**
 * Texts for people: the nearest known word, and texts of strangers made fit to be shown.
 *
 * <p>Allowed imports: the JDK.
 *
 * <p>Read first: {@link carom.text.Suggestion}, {@link carom.text.Texts}.
 */
package carom.text;

/**
 * Texts for people: the nearest known word, texts of strangers made fit to be shown, and why a file
 * can't be read or written.
 *
 * <p>Allowed imports: the JDK.
 *
 * <p>Read first: {@link carom.text.Suggestion}, {@link carom.text.Texts}, {@link
 * carom.text.FileErrors}.
 */
package carom.text;

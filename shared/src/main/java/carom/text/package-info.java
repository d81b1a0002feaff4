/**
 * Texts that people read and write: the nearest known word, texts of strangers made fit to be
 * shown, why a file can't be read or written, and strict reading of JSON, whose errors name the
 * line.
 *
 * <p>Allowed imports: Jackson's streaming parser, the JDK.
 *
 * <p>Read first: {@link carom.text.Suggestion}, {@link carom.text.Texts}, {@link
 * carom.text.FileErrors}, {@link carom.text.Json}.
 */
package carom.text;

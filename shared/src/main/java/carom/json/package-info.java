/**
 * Strict reading of JSON files whose errors name the line.
 *
 * <p>Allowed imports: {@code carom.text}, Jackson's streaming parser, the JDK.
 *
 * <p>Read first: {@link carom.json.Json}, {@link carom.json.JsonFields}.
 */
package carom.json;

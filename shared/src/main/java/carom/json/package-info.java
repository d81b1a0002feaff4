/**
 * Strict reading of JSON files whose errors name the line.
 *
 * <p>Allowed imports: Jackson's streaming parser, the JDK.
 *
 * <p>Read first: {@link carom.json.Json}.
 */
package carom.json;

/**
 * The read-only view that a player sees, its writer, and the composer that blends the interpolated
 * past with the predicted present.
 *
 * <p>Imports {@code carom.client.interpolation}, {@code carom.client.prediction}, {@code
 * carom.client.stats}, {@code carom.client.link}, {@code carom.net..} and {@code carom.sim}. One
 * thread. Read first: {@link carom.client.view.ClientView}, {@link carom.client.view.ViewComposer},
 * {@link carom.client.view.ViewWriter}.
 */
package carom.client.view;

/**
 * The program {@code carom-client}: its command line, and the window as a service.
 *
 * <p>This package knows no window toolkit. {@link java.util.ServiceLoader} finds the implementation
 * of {@link carom.client.app.Window}, which is {@code carom.client.desktop}.
 *
 * <p>Imports {@code carom.client..} but for {@code desktop} and {@code bots}, {@code carom.net..},
 * {@code carom.options} and {@code carom.sim..}. Read first: {@link carom.client.app.ClientMain},
 * {@link carom.client.app.NetworkOptions}, {@link carom.client.app.Window}.
 */
package carom.client.app;

package carom.server.web;

import carom.server.http.HttpPort;
import io.undertow.server.HttpServerExchange;
import io.undertow.util.Headers;
import io.undertow.util.StatusCodes;
import java.io.IOException;
import java.net.InetAddress;
import java.util.Locale;

/**
 * Answers {@code /healthz}, {@code /readyz} and {@code /metrics} and serves the {@link LivePage} on
 * {@linkplain HttpPort a port of its own}. The thread that reads and writes sockets answers for
 * health, and never waits; metrics, which take longer, by another.
 */
public final class WebServer implements AutoCloseable {
  private final LivePage page;
  private final Health health;
  private final Metrics metrics;
  private final HttpPort http;
  private volatile boolean stopping;

  /**
   * Opens the port and begins to answer.
   *
   * @param address address of this machine
   * @param port 1..65,535, or 0 for a free one
   * @param subject the server
   * @param page the live page, this server's to close from now on; null for none
   * @throws IOException if the port can't be opened; the message says what to do
   */
  public WebServer(InetAddress address, int port, WebSubject subject, LivePage page)
      throws IOException {
    this.page = page;
    health = new Health(subject.rooms(), System::nanoTime);
    metrics = new Metrics(subject);
    try {
      http =
          new HttpPort(
              HttpPort.Settings.plain(
                  "carom-web", address, port, visitor -> page != null && page.isProxy(visitor)),
              this::route);
    } catch (IOException e) {
      closeParts();
      throw new IOException(
          String.format(
              Locale.ROOT,
              "web-port=%d on %s can't be opened: %s; choose another with --web-port, or --no-web",
              port,
              address.getHostAddress(),
              e.getMessage()),
          e);
    }
  }

  /** Returns where browsers and other programs find this, such as {@code http://127.0.0.1:8090}. */
  public String url() {
    return http.url();
  }

  /** Tells {@code /readyz} that the server takes no more players, because it stops. */
  public void stopping() {
    stopping = true;
  }

  private void route(HttpServerExchange exchange) throws Exception {
    switch (exchange.getRequestPath()) {
      case "/healthz" -> sendProblem(exchange, health.problem());
      case "/readyz" -> sendProblem(exchange, notReady());
      case "/metrics" -> exchange.dispatch(this::sendMetrics);
      default -> {
        if (page != null) {
          page.handle(exchange);
        } else {
          HttpPort.answer(exchange, StatusCodes.NOT_FOUND, "/healthz /readyz /metrics");
        }
      }
    }
  }

  private void sendMetrics(HttpServerExchange exchange) {
    exchange
        .getResponseHeaders()
        .put(Headers.CONTENT_TYPE, "text/plain; version=0.0.4; charset=utf-8");
    exchange.getResponseSender().send(metrics.scrape());
  }

  private String notReady() {
    if (stopping) {
      return "the server stops";
    }
    return health.hasBegun() ? health.problem() : "the first tick is not computed yet";
  }

  private static void sendProblem(HttpServerExchange exchange, String problem) {
    boolean well = problem.isEmpty();
    HttpPort.answer(
        exchange, well ? StatusCodes.OK : StatusCodes.SERVICE_UNAVAILABLE, well ? "ok" : problem);
  }

  @Override
  public void close() {
    closeParts();
    http.close();
  }

  private void closeParts() {
    if (page != null) {
      page.close();
    }
    metrics.close();
  }
}

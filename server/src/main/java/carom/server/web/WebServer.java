package carom.server.web;

import carom.server.web.page.LivePage;
import io.undertow.Undertow;
import io.undertow.UndertowOptions;
import io.undertow.server.HttpHandler;
import io.undertow.server.HttpServerExchange;
import io.undertow.server.handlers.BlockingHandler;
import io.undertow.util.Headers;
import io.undertow.util.Methods;
import io.undertow.util.StatusCodes;
import java.io.IOException;
import java.net.BindException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.Locale;
import org.xnio.Options;

/**
 * Answers {@code /healthz}, {@code /readyz} and {@code /metrics} and serves the {@link LivePage} on
 * a port of its own, on two threads of its own.
 */
public final class WebServer implements AutoCloseable {
  private static final int BUFFER_BYTES = 16_384;
  private static final int IDLE_MS = 30_000;
  private static final long MAX_REQUEST_BYTES = 4_096;

  /** Time for which a request that hangs may hold the server's stop, ms. */
  private static final int STOP_MS = 1_000;

  private final Undertow undertow;
  private final LivePage page;
  private final HttpHandler answers = new BlockingHandler(this::answer);
  private final Health health;
  private final Metrics metrics;
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
    undertow =
        Undertow.builder()
            .addHttpListener(port, address.getHostAddress())
            .setIoThreads(1)
            .setWorkerThreads(1)
            .setDirectBuffers(false)
            .setBufferSize(BUFFER_BYTES)
            .setServerOption(UndertowOptions.NO_REQUEST_TIMEOUT, IDLE_MS)
            .setServerOption(UndertowOptions.MAX_ENTITY_SIZE, MAX_REQUEST_BYTES)
            .setServerOption(UndertowOptions.SHUTDOWN_TIMEOUT, STOP_MS)
            .setWorkerOption(Options.THREAD_DAEMON, true)
            .setHandler(this::route)
            .build();
    try {
      undertow.start();
    } catch (RuntimeException e) {
      close();
      String why =
          e.getCause() instanceof BindException ? "it is busy" : String.valueOf(e.getMessage());
      throw new IOException(
          String.format(
              Locale.ROOT,
              "web-port=%d on %s can't be opened: %s; choose another with --web-port, or --no-web",
              port,
              address.getHostAddress(),
              why),
          e);
    }
  }

  /** Returns where browsers and other programs find this, such as {@code http://127.0.0.1:8090}. */
  public String url() {
    InetSocketAddress address = (InetSocketAddress) undertow.getListenerInfo().get(0).getAddress();
    String host = address.getAddress().getHostAddress();
    return "http://" + (host.indexOf(':') < 0 ? host : "[" + host + "]") + ":" + address.getPort();
  }

  /** Tells {@code /readyz} that the server takes no more players, because it stops. */
  public void stopping() {
    stopping = true;
  }

  private void route(HttpServerExchange exchange) throws Exception {
    boolean isRead =
        exchange.getRequestMethod().equals(Methods.GET)
            || exchange.getRequestMethod().equals(Methods.HEAD);
    if (page != null && isRead && page.serves(exchange.getRequestPath())) {
      page.handle(exchange);
    } else {
      answers.handleRequest(exchange);
    }
  }

  private void answer(HttpServerExchange exchange) {
    if (!exchange.getRequestMethod().equals(Methods.GET)
        && !exchange.getRequestMethod().equals(Methods.HEAD)) {
      send(exchange, StatusCodes.METHOD_NOT_ALLOWED, "only GET\n");
      return;
    }
    switch (exchange.getRequestPath()) {
      case "/healthz" -> sendProblem(exchange, health.problem());
      case "/readyz" -> sendProblem(exchange, notReady());
      case "/metrics" -> {
        exchange
            .getResponseHeaders()
            .put(Headers.CONTENT_TYPE, "text/plain; version=0.0.4; charset=utf-8");
        exchange.getResponseSender().send(metrics.scrape());
      }
      default -> send(exchange, StatusCodes.NOT_FOUND, "/healthz /readyz /metrics\n");
    }
  }

  private String notReady() {
    if (stopping) {
      return "the server stops";
    }
    return health.hasBegun() ? health.problem() : "the first tick is not computed yet";
  }

  private static void sendProblem(HttpServerExchange exchange, String problem) {
    boolean well = problem.isEmpty();
    send(
        exchange,
        well ? StatusCodes.OK : StatusCodes.SERVICE_UNAVAILABLE,
        well ? "ok\n" : problem + "\n");
  }

  private static void send(HttpServerExchange exchange, int status, String text) {
    exchange.setStatusCode(status);
    exchange.getResponseHeaders().put(Headers.CONTENT_TYPE, "text/plain; charset=utf-8");
    exchange.getResponseSender().send(text);
  }

  @Override
  public void close() {
    if (page != null) {
      page.close();
    }
    undertow.stop();
    metrics.close();
  }
}

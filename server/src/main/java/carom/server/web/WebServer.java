package carom.server.web;

import carom.net.transport.AddressFamily;
import carom.server.web.page.LivePage;
import com.sun.management.UnixOperatingSystemMXBean;
import io.undertow.UndertowOptions;
import io.undertow.io.IoCallback;
import io.undertow.io.Sender;
import io.undertow.server.DefaultByteBufferPool;
import io.undertow.server.HttpServerExchange;
import io.undertow.server.protocol.http.HttpOpenListener;
import io.undertow.util.Headers;
import io.undertow.util.Methods;
import io.undertow.util.StatusCodes;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.net.BindException;
import java.net.Inet4Address;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.xnio.ChannelListeners;
import org.xnio.OptionMap;
import org.xnio.Options;
import org.xnio.StreamConnection;
import org.xnio.Xnio;
import org.xnio.XnioWorker;
import org.xnio.channels.AcceptingChannel;

/**
 * Answers {@code /healthz}, {@code /readyz} and {@code /metrics} and serves the {@link LivePage} on
 * a port of its own, by Undertow, on three threads of its own.
 *
 * <p>Whatever a visitor does, it costs the game nothing and holds up no other: connections have
 * {@linkplain ConnectionPlaces few places}; a request's head has {@value #HEAD_MS} ms, a silent
 * connection {@value #IDLE_MS} ms, one that neither reads nor writes {@value #STALLED_MS} ms; no
 * request has a body. Health is told by the thread that reads and writes sockets, which waits for
 * nobody; metrics, which take longer, by another.
 */
public final class WebServer implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(WebServer.class);
  private static final int BUFFER_BYTES = 16_384;

  /** Time for the head of a request from its first byte on, ms. */
  static final int HEAD_MS = 5_000;

  /** Time between two requests of a connection, and before the first, ms. */
  static final int IDLE_MS = 30_000;

  /** Time in which an answer's reader must take some of it, ms. Hidden pages speak each minute. */
  static final int STALLED_MS = 90_000;

  /** Most connections, where the system has descriptors enough, and least ones. */
  static final int MOST_CONNECTIONS = 256;

  private static final int LEAST_CONNECTIONS = 64;

  /** The port takes at most one in so many of the process's descriptors: the rest is the game's. */
  private static final int DESCRIPTOR_SHARE = 16;

  private static final int MOST_HEAD_BYTES = 16_384;
  private static final int MOST_HEADERS = 64;
  private static final int MOST_PARAMETERS = 16;

  /** Connections that may wait to be accepted. */
  private static final int BACKLOG = 128;

  /** Time for which a request that hangs may hold the server's stop, ms. */
  private static final int STOP_MS = 1_000;

  private final XnioWorker worker;
  private final DefaultByteBufferPool buffers =
      new DefaultByteBufferPool(false, BUFFER_BYTES, -1, 4);
  private final ConnectionPlaces places;
  private final LivePage page;
  private final Health health;
  private final Metrics metrics;
  private AcceptingChannel<StreamConnection> listener;
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
    HttpOpenListener http =
        new HttpOpenListener(
            buffers,
            OptionMap.builder()
                .set(UndertowOptions.REQUEST_PARSE_TIMEOUT, HEAD_MS)
                .set(UndertowOptions.NO_REQUEST_TIMEOUT, IDLE_MS)
                .set(UndertowOptions.IDLE_TIMEOUT, STALLED_MS)
                .set(UndertowOptions.MAX_HEADER_SIZE, MOST_HEAD_BYTES)
                .set(UndertowOptions.MAX_HEADERS, MOST_HEADERS)
                .set(UndertowOptions.MAX_PARAMETERS, MOST_PARAMETERS)
                .getMap());
    http.setRootHandler(this::route);
    places =
        new ConnectionPlaces(
            affordableConnections(),
            visitor -> page != null && page.isProxy(visitor),
            visitor -> AddressFamily.of(address) == null || visitor instanceof Inet4Address,
            http);
    worker =
        Xnio.getInstance(WebServer.class.getClassLoader())
            .createWorker(
                OptionMap.builder()
                    .set(Options.WORKER_NAME, "carom-web")
                    .set(Options.WORKER_IO_THREADS, 1)
                    .set(Options.WORKER_TASK_CORE_THREADS, 1)
                    .set(Options.WORKER_TASK_MAX_THREADS, 1)
                    .set(Options.THREAD_DAEMON, true)
                    .getMap());
    try {
      listener =
          worker.createStreamConnectionServer(
              new InetSocketAddress(address, port),
              ChannelListeners.openListenerAdapter(places),
              OptionMap.builder()
                  .set(Options.TCP_NODELAY, true)
                  .set(Options.REUSE_ADDRESSES, true)
                  .set(Options.BACKLOG, BACKLOG)
                  .getMap());
      listener.resumeAccepts();
    } catch (IOException e) {
      close();
      String why = e instanceof BindException ? "it is busy" : String.valueOf(e.getMessage());
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

  /** Returns how many connections this process can spare descriptors for. */
  static int affordableConnections() {
    long descriptors =
        ManagementFactory.getOperatingSystemMXBean() instanceof UnixOperatingSystemMXBean system
            ? system.getMaxFileDescriptorCount()
            : Long.MAX_VALUE;
    return (int)
        Math.max(LEAST_CONNECTIONS, Math.min(MOST_CONNECTIONS, descriptors / DESCRIPTOR_SHARE));
  }

  /** Returns where browsers and other programs find this, such as {@code http://127.0.0.1:8090}. */
  public String url() {
    InetSocketAddress address = (InetSocketAddress) listener.getLocalAddress();
    String host = address.getAddress().getHostAddress();
    return "http://" + (host.indexOf(':') < 0 ? host : "[" + host + "]") + ":" + address.getPort();
  }

  /** Tells {@code /readyz} that the server takes no more players, because it stops. */
  public void stopping() {
    stopping = true;
  }

  private void route(HttpServerExchange exchange) throws Exception {
    places.asks(exchange);
    boolean isRead =
        exchange.getRequestMethod().equals(Methods.GET)
            || exchange.getRequestMethod().equals(Methods.HEAD);
    if (!isRead || !exchange.isRequestComplete()) {
      refuseBody(exchange, isRead);
      return;
    }
    switch (exchange.getRequestPath()) {
      case "/healthz" -> sendProblem(exchange, health.problem());
      case "/readyz" -> sendProblem(exchange, notReady());
      case "/metrics" -> exchange.dispatch(this::sendMetrics);
      default -> {
        if (page != null) {
          page.handle(exchange);
        } else {
          send(exchange, StatusCodes.NOT_FOUND, "/healthz /readyz /metrics\n");
        }
      }
    }
  }

  /** Answers a request that would change something or goes on behind its head, and hangs up. */
  private static void refuseBody(HttpServerExchange exchange, boolean isRead) {
    exchange.setPersistent(false);
    exchange.setStatusCode(
        isRead ? StatusCodes.REQUEST_ENTITY_TOO_LARGE : StatusCodes.METHOD_NOT_ALLOWED);
    exchange
        .getResponseSender()
        .send(
            isRead ? "no body\n" : "only GET\n",
            new IoCallback() {
              @Override
              public void onComplete(HttpServerExchange done, Sender sender) {
                hangUp(done);
              }

              @Override
              public void onException(HttpServerExchange done, Sender sender, IOException e) {
                hangUp(done);
              }
            });
  }

  /** Ends a connection whose rest nobody waits for. */
  private static void hangUp(HttpServerExchange exchange) {
    try {
      exchange.getConnection().close();
    } catch (IOException e) {
      // it is gone either way
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
    try {
      if (listener != null && !worker.isShutdown()) {
        listener.close();
      }
      worker.shutdownNow();
      worker.awaitTermination(STOP_MS, TimeUnit.MILLISECONDS);
    } catch (IOException e) {
      LOG.debug("the port for HTTP: {}", e.toString());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    buffers.close();
    metrics.close();
  }
}

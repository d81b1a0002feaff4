package carom.server.http;

import carom.net.admission.AddressGroup;
import carom.net.transport.AddressFamily;
import com.sun.management.UnixOperatingSystemMXBean;
import io.undertow.UndertowOptions;
import io.undertow.io.IoCallback;
import io.undertow.io.Sender;
import io.undertow.protocols.ssl.UndertowXnioSsl;
import io.undertow.server.DefaultByteBufferPool;
import io.undertow.server.HttpHandler;
import io.undertow.server.HttpServerExchange;
import io.undertow.server.protocol.http.HttpOpenListener;
import io.undertow.util.Headers;
import io.undertow.util.Methods;
import io.undertow.util.SameThreadExecutor;
import io.undertow.util.StatusCodes;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.net.BindException;
import java.net.Inet4Address;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import javax.net.ssl.SSLContext;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.xnio.ChannelListener;
import org.xnio.ChannelListeners;
import org.xnio.OptionMap;
import org.xnio.Options;
import org.xnio.StreamConnection;
import org.xnio.Xnio;
import org.xnio.XnioWorker;
import org.xnio.channels.AcceptingChannel;

/**
 * A port for HTTP and WebSocket by Undertow, on three threads of its own.
 *
 * <p>Whatever a visitor does, it costs the game nothing and holds up no other: connections have
 * {@linkplain ConnectionPlaces few places}; a request's head has {@value #HEAD_MS} ms, a silent
 * connection {@value #IDLE_MS} ms, one that neither reads nor writes {@value #STALLED_MS} ms; no
 * request has a body.
 */
public final class HttpPort implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(HttpPort.class);
  private static final int BUFFER_BYTES = 16_384;

  /** Time for the head of a request from its first byte on, ms. */
  static final int HEAD_MS = 5_000;

  /** Time between two requests of a connection, and before the first, ms. */
  static final int IDLE_MS = 30_000;

  /** Time in which an answer's reader must take some of it, ms. Hidden pages speak each minute. */
  static final int STALLED_MS = 90_000;

  /** Most connections, where the system has descriptors enough, and least ones. */
  public static final int MOST_CONNECTIONS = 256;

  private static final int LEAST_CONNECTIONS = 64;

  /** The port takes at most one in so many of the process's descriptors: the rest is the game's. */
  private static final int DESCRIPTOR_SHARE = 16;

  private static final int MOST_HEAD_BYTES = 16_384;
  private static final int MOST_HEADERS = 64;
  private static final int MOST_PARAMETERS = 16;

  /** Connections that may wait to be accepted. */
  private static final int BACKLOG = 128;

  /** Time that a visitor has to send the rest and read why its request is refused, ms. */
  private static final int LINGER_MS = 1_000;

  /** Time for which a request that hangs may hold the server's stop, ms. */
  private static final int STOP_MS = 1_000;

  private final XnioWorker worker;
  private final DefaultByteBufferPool buffers =
      new DefaultByteBufferPool(false, BUFFER_BYTES, -1, 4);
  private final List<AcceptingChannel<? extends StreamConnection>> listeners = new ArrayList<>();
  private final ConnectionPlaces places;
  private final HttpHandler handler;
  private final boolean encrypted;

  /**
   * Settings of a port. Immutable.
   *
   * @param threads begin of the names of its threads, such as {@code carom-web}
   * @param addresses of this machine; empty for all
   * @param port 1..65,535, or 0 for a free one
   * @param isProxy whether an address stands for many visitors, and may have all places
   * @param sendBufferBytes what the system may keep for a visitor that doesn't read; 0 for its own
   *     choice
   * @param bytesPerSecond what one connection may send in the long run; 0 for any number
   * @param burstBytes what it may send at once
   * @param tls certificates, or null for a port without encryption
   */
  public record Settings(
      String threads,
      List<InetAddress> addresses,
      int port,
      Predicate<InetAddress> isProxy,
      int sendBufferBytes,
      int bytesPerSecond,
      int burstBytes,
      SSLContext tls) {
    /** Copies the list. */
    public Settings {
      addresses = List.copyOf(addresses);
    }

    /** Returns settings of a port without encryption whose visitors send little. */
    public static Settings plain(
        String threads, InetAddress address, int port, Predicate<InetAddress> isProxy) {
      return new Settings(threads, List.of(address), port, isProxy, 0, 0, 0, null);
    }
  }

  /**
   * Opens the port and begins to answer.
   *
   * @param handler answers requests without a body, on the thread that reads and writes sockets
   * @throws IOException if the port can't be opened; the message says why, such as {@code it is
   *     busy}
   */
  public HttpPort(Settings settings, HttpHandler handler) throws IOException {
    this.handler = handler;
    encrypted = settings.tls() != null;
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
    ChannelListener<StreamConnection> metered =
        connection -> {
          if (settings.bytesPerSecond() > 0) {
            connection
                .getSourceChannel()
                .setConduit(
                    new InboundBudget(
                        connection.getSourceChannel().getConduit(),
                        settings.bytesPerSecond(),
                        settings.burstBytes()));
          }
          http.handleEvent(connection);
        };
    List<InetAddress> addresses = settings.addresses();
    places =
        new ConnectionPlaces(
            affordableConnections(),
            settings.isProxy(),
            visitor -> hears(addresses, visitor),
            metered);
    Xnio xnio = Xnio.getInstance(HttpPort.class.getClassLoader());
    worker =
        xnio.createWorker(
            OptionMap.builder()
                .set(Options.WORKER_NAME, settings.threads())
                .set(Options.WORKER_IO_THREADS, 1)
                .set(Options.WORKER_TASK_CORE_THREADS, 1)
                .set(Options.WORKER_TASK_MAX_THREADS, 1)
                .set(Options.THREAD_DAEMON, true)
                .getMap());
    try {
      if (addresses.isEmpty()) {
        open(new InetSocketAddress(settings.port()), settings, xnio);
      }
      for (InetAddress address : addresses) {
        int port = listeners.isEmpty() ? settings.port() : port();
        open(new InetSocketAddress(address, port), settings, xnio);
      }
      listeners.forEach(AcceptingChannel::resumeAccepts);
    } catch (IOException e) {
      close();
      String why = e instanceof BindException ? "it is busy" : String.valueOf(e.getMessage());
      throw new IOException(why, e);
    }
  }

  private static boolean hears(List<InetAddress> addresses, InetAddress visitor) {
    return addresses.isEmpty()
        || visitor instanceof Inet4Address
        || addresses.stream().anyMatch(address -> AddressFamily.of(address) == null);
  }

  private void open(InetSocketAddress at, Settings settings, Xnio xnio) throws IOException {
    OptionMap.Builder options =
        OptionMap.builder()
            .set(Options.TCP_NODELAY, true)
            .set(Options.REUSE_ADDRESSES, true)
            .set(Options.BACKLOG, BACKLOG);
    if (settings.sendBufferBytes() > 0) {
      options.set(Options.SEND_BUFFER, settings.sendBufferBytes());
    }
    if (encrypted) {
      listeners.add(
          new UndertowXnioSsl(xnio, OptionMap.EMPTY, buffers, settings.tls())
              .createSslConnectionServer(
                  worker, at, ChannelListeners.openListenerAdapter(places), options.getMap()));
    } else {
      listeners.add(
          worker.createStreamConnectionServer(
              at, ChannelListeners.openListenerAdapter(places), options.getMap()));
    }
  }

  /** Returns how many connections this process can spare descriptors for. */
  public static int affordableConnections() {
    long descriptors =
        ManagementFactory.getOperatingSystemMXBean() instanceof UnixOperatingSystemMXBean system
            ? system.getMaxFileDescriptorCount()
            : Long.MAX_VALUE;
    return (int)
        Math.max(LEAST_CONNECTIONS, Math.min(MOST_CONNECTIONS, descriptors / DESCRIPTOR_SHARE));
  }

  /** Returns the port, as it was opened. */
  public int port() {
    return ((InetSocketAddress) listeners.get(0).getLocalAddress()).getPort();
  }

  /**
   * Returns where browsers and other programs of this machine find this, such as {@code
   * http://127.0.0.1:8090}.
   */
  public String url() {
    InetSocketAddress address = (InetSocketAddress) listeners.get(0).getLocalAddress();
    String place =
        address.getAddress().isAnyLocalAddress()
            ? "localhost:" + address.getPort()
            : AddressGroup.remote(address.getAddress(), address.getPort());
    return (encrypted ? "https://" : "http://") + place;
  }

  /** Runs a task again and again, on the thread that reads and writes sockets. */
  public void every(int ms, Runnable task) {
    worker.getIoThread().executeAtInterval(task, ms, TimeUnit.MILLISECONDS);
  }

  private void route(HttpServerExchange exchange) throws Exception {
    places.asks(exchange);
    boolean isRead =
        exchange.getRequestMethod().equals(Methods.GET)
            || exchange.getRequestMethod().equals(Methods.HEAD);
    if (!isRead || !exchange.isRequestComplete()) {
      // Dispatched: else the exchange would end as this returns, and with it the connection, while
      // the body is on its way.
      exchange.dispatch(SameThreadExecutor.INSTANCE, () -> refuseBody(exchange, isRead));
    } else {
      handler.handleRequest(exchange);
    }
  }

  /**
   * Answers a request that would change something or goes on behind its head, and hangs up. The
   * answer says its length, and the connection ends a moment later: what is left unread would
   * otherwise make the system reset the connection, and the visitor lose the answer.
   */
  private static void refuseBody(HttpServerExchange exchange, boolean isRead) {
    String text = isRead ? "no body\n" : "only GET\n";
    exchange.setPersistent(false);
    exchange.setResponseContentLength(text.length());
    exchange.setStatusCode(
        isRead ? StatusCodes.REQUEST_ENTITY_TOO_LARGE : StatusCodes.METHOD_NOT_ALLOWED);
    exchange
        .getResponseSender()
        .send(
            text,
            new IoCallback() {
              @Override
              public void onComplete(HttpServerExchange done, Sender sender) {
                done.getIoThread()
                    .executeAfter(() -> hangUp(done), LINGER_MS, TimeUnit.MILLISECONDS);
              }

              @Override
              public void onException(HttpServerExchange done, Sender sender, IOException e) {
                hangUp(done);
              }
            });
  }

  /** Ends a connection whose remaining bytes don't matter. */
  private static void hangUp(HttpServerExchange exchange) {
    try {
      exchange.getConnection().close();
    } catch (IOException e) {
      // it is gone either way
    }
  }

  /** Answers with a status and a line of text. */
  public static void answer(HttpServerExchange exchange, int status, String text) {
    exchange.setStatusCode(status);
    exchange.getResponseHeaders().put(Headers.CONTENT_TYPE, "text/plain; charset=utf-8");
    exchange.getResponseSender().send(text + "\n");
  }

  /** Closes the port and all connections. */
  @Override
  public void close() {
    try {
      for (AcceptingChannel<? extends StreamConnection> listener : listeners) {
        if (!worker.isShutdown()) {
          listener.close();
        }
      }
      worker.shutdownNow();
      worker.awaitTermination(STOP_MS, TimeUnit.MILLISECONDS);
    } catch (IOException e) {
      LOG.debug("the port for HTTP: {}", e.toString());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    buffers.close();
  }
}

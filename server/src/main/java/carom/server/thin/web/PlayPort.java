package carom.server.thin.web;

import carom.net.admission.AddressGroup;
import carom.net.transport.HandshakeLine;
import carom.net.transport.Impairment;
import carom.net.transport.Link;
import carom.net.transport.NetworkCounter;
import carom.net.transport.ServerTransport;
import carom.net.transport.SurvivedErrors;
import carom.net.transport.Troubles;
import carom.server.access.AddressRange;
import carom.server.http.HttpPort;
import carom.server.http.Origins;
import carom.server.http.RequestGuard;
import carom.server.http.SiteFiles;
import io.undertow.server.HttpServerExchange;
import io.undertow.util.AttachmentKey;
import io.undertow.util.Headers;
import io.undertow.util.StatusCodes;
import io.undertow.websockets.WebSocketProtocolHandshakeHandler;
import io.undertow.websockets.core.WebSocketChannel;
import io.undertow.websockets.spi.WebSocketHttpExchange;
import java.io.IOException;
import java.net.InetAddress;
import java.util.List;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicLong;

/**
 * The play port: HTTP and WebSocket for thin clients. {@code /thin} is the WebSocket, {@code /play}
 * the page that plays.
 *
 * <pre>
 *   browser, program ──GET /thin──► may it come? ──► WebLink ──accept──► lobby
 *   browser ──GET /play/──► file
 * </pre>
 */
public final class PlayPort implements ServerTransport {
  private static final String SOCKET = "/thin";
  private static final String PAGE = "/play";
  private static final String LOOKS = "/play/look/";
  private static final AttachmentKey<Comer> COMER = AttachmentKey.create(Comer.class);

  /** Bytes that the system may keep for a client that reads slowly: half a second of a game. */
  private static final int SEND_BUFFER_BYTES = 32_768;

  private static final int MAX_BYTES_PER_SECOND = 65_536;
  private static final int BURST_BYTES = 4 * MAX_BYTES_PER_SECOND;
  private static final int SECOND_MS = 1_000;

  /** Time between two looks at the files of certificates, ms. */
  private static final int REFRESH_MS = 10_000;

  /** A client that gets a link: its address and port, and whether others can read what it says. */
  private record Comer(String remote, boolean isPlainText) {}

  private final SiteFiles files =
      new SiteFiles(
          PlayPort.class,
          List.of(
              "play/index.html",
              "play/play.css",
              "play/play.js",
              "play/thin.js",
              "play/world.js",
              "play/picture.js",
              "play/controls.js",
              "play/sounds.js",
              "play/qr.js",
              "play/look.js",
              "play/sparks.js",
              "/carom/server/web/painter.js",
              "/carom/server/web/icon.svg"));
  private final LookSite looks = new LookSite();
  private final boolean encrypted;
  private final RequestGuard guard;
  private final Origins origins;
  private final HttpPort http;
  private final WebSocketProtocolHandshakeHandler handshake =
      new WebSocketProtocolHandshakeHandler(this::connected);
  private final Queue<Link> opened = new ConcurrentLinkedQueue<>();
  private final Set<WebLink> links = ConcurrentHashMap.newKeySet();
  private final AtomicLong openedCount = new AtomicLong();
  private final AtomicLong refusedCount = new AtomicLong();
  private final AtomicLong foreignCount = new AtomicLong();
  private final AtomicLong malformedCount = new AtomicLong();
  private final AtomicLong bytesIn = new AtomicLong();
  private final AtomicLong bytesOut = new AtomicLong();
  private final SurvivedErrors errors = new SurvivedErrors();
  private volatile HandshakeLine network;
  private volatile Runnable wake = () -> {};
  private volatile int most;
  private volatile int mostPerAddress;

  /**
   * Settings of the port. Immutable.
   *
   * @param addresses of this machine; empty for all
   * @param port 1..65,535, or 0 for a free one
   * @param hosts names under which browsers may reach the server, beside addresses and {@code
   *     localhost}, and whose pages may connect; lower case
   * @param proxies addresses of proxies, which tell from where their requests come
   * @param most links in all
   * @param mostPerAddress links of one IPv4 address or IPv6 /64 network, as soon as half of all are
   *     taken
   * @param tls certificates, or null for a port without encryption
   */
  public record Settings(
      List<InetAddress> addresses,
      int port,
      Set<String> hosts,
      List<AddressRange> proxies,
      int most,
      int mostPerAddress,
      Certificates tls) {
    /** Copies the lists. */
    public Settings {
      addresses = List.copyOf(addresses);
      hosts = Set.copyOf(hosts);
      proxies = List.copyOf(proxies);
    }

    /** Returns settings without names, proxies and encryption. */
    public static Settings plain(List<InetAddress> addresses, int port, int most) {
      return new Settings(addresses, port, Set.of(), List.of(), most, most, null);
    }
  }

  /**
   * Opens the port and begins to answer.
   *
   * @throws IOException if the port can't be opened; the message says what to do
   */
  public PlayPort(Settings settings) throws IOException {
    encrypted = settings.tls() != null;
    guard = new RequestGuard(settings.hosts());
    origins = new Origins(settings.proxies());
    most = settings.most();
    mostPerAddress = settings.mostPerAddress();
    try {
      http =
          new HttpPort(
              new HttpPort.Settings(
                  "carom-play",
                  settings.addresses(),
                  settings.port(),
                  origins::isProxy,
                  SEND_BUFFER_BYTES,
                  MAX_BYTES_PER_SECOND,
                  BURST_BYTES,
                  settings.tls() == null ? null : settings.tls().context()),
              this::route);
    } catch (IOException e) {
      throw new IOException(
          "play-port="
              + settings.port()
              + " can't be opened: "
              + e.getMessage()
              + "; choose another with --play-port",
          e);
    }
    http.every(SECOND_MS, this::second);
    if (settings.tls() != null) {
      http.every(REFRESH_MS, settings.tls()::refresh);
    }
  }

  private void second() {
    for (WebLink link : links) {
      link.second();
    }
  }

  private void route(HttpServerExchange exchange) throws Exception {
    String path = exchange.getRequestPath();
    if (path.equals(SOCKET)) {
      connect(exchange);
    } else if (!guard.acceptsHost(exchange)) {
      refuse(
          exchange,
          "this server isn't known by this name; its operator lists names with --play-host");
    } else if (path.equals("/") || path.equals(PAGE)) {
      exchange.setStatusCode(StatusCodes.FOUND);
      exchange.getResponseHeaders().put(Headers.LOCATION, "play/");
      exchange.endExchange();
    } else if (path.startsWith(LOOKS)
        ? !looks.send(exchange, path.substring(LOOKS.length()))
        : !path.startsWith(PAGE + "/") || !files.send(exchange, fileName(path))) {
      HttpPort.answer(exchange, StatusCodes.NOT_FOUND, "/play /thin");
    }
  }

  private static String fileName(String path) {
    String name = path.substring(PAGE.length() + 1);
    return name.isEmpty() ? "index.html" : name;
  }

  private void connect(HttpServerExchange exchange) throws Exception {
    InetAddress address = origins.of(exchange).address();
    String host = AddressGroup.of(address).host();
    if (!guard.acceptsPage(exchange)) {
      foreignCount.incrementAndGet();
      refuse(
          exchange,
          "only pages of this server may connect; its operator lists others with --play-host");
    } else if (!exchange.getRequestHeaders().contains(Headers.UPGRADE)) {
      HttpPort.answer(exchange, StatusCodes.BAD_REQUEST, "this is for WebSockets");
    } else if (links.size() >= most) {
      refusedCount.incrementAndGet();
      HttpPort.answer(
          exchange, StatusCodes.SERVICE_UNAVAILABLE, "the server is full; try again in a moment");
    } else if (links.size() >= most / 2 && countOf(host) >= mostPerAddress) {
      refusedCount.incrementAndGet();
      HttpPort.answer(
          exchange, StatusCodes.TOO_MANY_REQUESTS, "too many links from your address are open");
    } else {
      int port = exchange.getSourceAddress().getPort();
      exchange.putAttachment(
          COMER,
          new Comer(
              AddressGroup.remote(address, port),
              !encrypted && !origins.isEncryptedByProxy(exchange)));
      handshake.handleRequest(exchange);
    }
  }

  private int countOf(String host) {
    int count = 0;
    for (WebLink link : links) {
      count += AddressGroup.ofRemote(link.remote()).host().equals(host) ? 1 : 0;
    }
    return count;
  }

  private static void refuse(HttpServerExchange exchange, String why) {
    HttpPort.answer(exchange, StatusCodes.FORBIDDEN, why);
  }

  private void connected(WebSocketHttpExchange exchange, WebSocketChannel channel) {
    Comer comer = exchange.getAttachment(COMER);
    WebLink link = new WebLink(channel, comer.remote, comer.isPlainText, errors::add);
    HandshakeLine simulated = network;
    if (simulated != null) {
      link.simulate(simulated);
    }
    links.add(link);
    openedCount.incrementAndGet();
    channel.addCloseTask(closed -> ended(link));
    opened.add(link);
    link.begin();
    wake.run();
  }

  private void ended(WebLink link) {
    if (links.remove(link)) {
      malformedCount.addAndGet(link.counters().malformed.get());
      bytesIn.addAndGet(link.counters().messageBytesIn.get());
      bytesOut.addAndGet(bytesTo(link));
    }
  }

  private static long bytesTo(WebLink link) {
    return link.counters().messageBytesOut.get() + link.counters().datagramBytesOut.get();
  }

  /** Makes the network bad on purpose, for links from now on: latency and jitter. */
  public void simulate(Impairment impairment) {
    network = new HandshakeLine(impairment);
  }

  @Override
  public Link accept() {
    return opened.poll();
  }

  @Override
  public boolean onOpened(Runnable newWake) {
    wake = newWake;
    return true;
  }

  @Override
  public void limitLinks(int newMost, int newMostPerAddress) {
    most = newMost;
    mostPerAddress = newMostPerAddress;
  }

  /** Returns the port, as it was opened. */
  @Override
  public int tcpPort() {
    return http.port();
  }

  @Override
  public int udpPort() {
    return 0;
  }

  /** Returns where browsers find the page, such as {@code http://127.0.0.1:8080/play}. */
  public String url() {
    return http.url() + PAGE;
  }

  @Override
  public String troubles() {
    return new Troubles()
        .add(refusedCount.get(), "links refused as too many")
        .add(foreignCount.get(), "pages of others refused")
        .add(malformedCount.get(), "messages not understood")
        .add(errors.get(), "errors")
        .under("play port: ");
  }

  @Override
  public List<NetworkCounter> networkCounters() {
    return List.of(
        new NetworkCounter("play.opened", "WebSockets of thin clients opened.", openedCount::get),
        new NetworkCounter(
            "play.refused", "WebSockets refused as too many were open.", refusedCount::get),
        new NetworkCounter(
            "play.foreign", "WebSockets refused to pages of other sites.", foreignCount::get),
        new NetworkCounter(
            "play.malformed",
            "Messages of thin clients that couldn't be understood, of links that ended.",
            malformedCount::get),
        new NetworkCounter(
            "play.bytes.in", "Payload bytes of WebSockets that ended, received.", bytesIn::get),
        new NetworkCounter(
            "play.bytes.out", "Payload bytes of WebSockets that ended, sent.", bytesOut::get),
        new NetworkCounter(
            "play.errors", "Unexpected errors of WebSockets, each a bug.", errors::get));
  }

  @Override
  public Throwable nextError() {
    return errors.take();
  }

  @Override
  public void close() {
    HandshakeLine simulated = network;
    if (simulated != null) {
      simulated.close();
    }
    http.close();
    links.forEach(WebLink::end);
  }
}

package carom.server.web;

import carom.server.command.Caller;
import carom.server.command.CommandRegistry;
import carom.server.command.Quoting;
import carom.server.command.Role;
import carom.server.fleet.FleetFigures;
import carom.server.http.Origins;
import carom.server.http.RequestGuard;
import carom.server.http.SiteFiles;
import carom.server.room.Room;
import carom.server.threads.LastingThread;
import carom.text.Json;
import carom.text.JsonException;
import io.undertow.server.HttpServerExchange;
import io.undertow.util.AttachmentKey;
import io.undertow.util.Headers;
import io.undertow.util.StatusCodes;
import io.undertow.websockets.WebSocketProtocolHandshakeHandler;
import io.undertow.websockets.core.AbstractReceiveListener;
import io.undertow.websockets.core.BufferedTextMessage;
import io.undertow.websockets.core.WebSocketChannel;
import io.undertow.websockets.spi.WebSocketHttpExchange;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The page: its files, its WebSocket at {@value #SOCKET}, and two threads. {@code carom-page} sends
 * pictures and figures; {@code carom-page-commands} carries out commands, which may take seconds.
 */
final class LivePage implements AutoCloseable {
  /** Most pages that may be open at once without the secret. */
  static final int MAX_VIEWERS = 32;

  /** Most pages that may be open at once with it. */
  static final int MAX_OPERATORS = 16;

  private static final Logger LOG = LoggerFactory.getLogger(LivePage.class);
  private static final String SOCKET = "/live";
  private static final AttachmentKey<Origins.Origin> ORIGIN =
      AttachmentKey.create(Origins.Origin.class);
  private static final int MAX_MESSAGE_BYTES = 8_192;
  private static final int MAX_COMMANDS = 16;
  private static final long PICTURE_MS = 66;
  private static final double NS_PER_S = 1e9;

  /** Silence after which a page counts as gone. Hidden pages may speak once a minute. */
  private static final long SILENCE_NS = 150_000_000_000L;

  private final PageConfig config;
  private final RequestGuard guard;
  private final Origins origins;
  private final SiteFiles files =
      new SiteFiles(
          LivePage.class,
          List.of(
              "index.html",
              "page.css",
              "app.js",
              "scene.js",
              "painter.js",
              "charts.js",
              "icon.svg"));
  private final Downloads downloads;
  private final ProcessFigures begin = ProcessFigures.now();
  private final List<Room> rooms;
  private final FleetFigures fleet; // or null
  private final List<Viewer> viewers = new CopyOnWriteArrayList<>();
  private final WebSocketProtocolHandshakeHandler handshake =
      new WebSocketProtocolHandshakeHandler(this::connected);
  private final ScheduledThreadPoolExecutor clock;
  private final ThreadPoolExecutor commands;

  // The thread that reads and writes sockets only.
  private boolean proxyTold;

  // The page's thread only. Both are in the order of the rooms.
  private final Map<Room, RoomHistory> histories = new LinkedHashMap<>();
  private final Map<Room, RoomFeed> feeds = new LinkedHashMap<>();
  private ScheduledFuture<?> pictures; // null while nobody watches
  private long sampledNs = System.nanoTime();

  /** Begins to note figures; {@link #handle} shows them. */
  @SuppressWarnings(
      "FutureReturnValueIgnored") // The guarded tasks throw nothing, and end with the clock.
  public LivePage(PageConfig config, WebSubject subject) {
    this.config = config;
    rooms = subject.rooms();
    fleet = subject.fleet();
    guard = new RequestGuard(config.hosts());
    origins = new Origins(config.proxies());
    downloads = new Downloads(config.recordings(), System::nanoTime);
    followRooms();
    clock = new ScheduledThreadPoolExecutor(1, daemon("carom-page"));
    clock.setRemoveOnCancelPolicy(true);
    commands =
        new ThreadPoolExecutor(
            1,
            1,
            1,
            TimeUnit.MINUTES,
            new ArrayBlockingQueue<>(MAX_COMMANDS),
            daemon("carom-page-commands"));
    clock.scheduleAtFixedRate(LastingThread.guarded(this::second), 1, 1, TimeUnit.SECONDS);
  }

  private static ThreadFactory daemon(String name) {
    return task -> {
      Thread thread = new Thread(task, name);
      thread.setDaemon(true);
      return thread;
    };
  }

  /** Returns whether an address is that of a proxy, and so stands for many visitors. Any thread. */
  public boolean isProxy(InetAddress address) {
    return origins.isProxy(address);
  }

  /** Answers a request, on the thread that reads and writes sockets. */
  public void handle(HttpServerExchange exchange) throws Exception {
    if (!guard.acceptsHost(exchange)) {
      refuse(
          exchange,
          "this server isn't known by this name; use its address, or list the name: --web-host");
    } else if (exchange.getRequestPath().equals(SOCKET)) {
      if (!guard.acceptsOrigin(exchange)) {
        refuse(exchange, "only the page itself may connect");
      } else if (!exchange.getRequestHeaders().contains(Headers.UPGRADE)) {
        exchange.setStatusCode(StatusCodes.BAD_REQUEST);
        exchange.getResponseSender().send("this is for WebSockets\n");
      } else {
        warnOfProxy(exchange);
        exchange.putAttachment(ORIGIN, origins.of(exchange));
        handshake.handleRequest(exchange);
      }
    } else if (exchange.getRequestPath().equals(Downloads.PATH)) {
      SiteFiles.protect(exchange);
      downloads.send(exchange);
    } else if (!files.send(exchange, fileName(exchange))) {
      exchange.setStatusCode(StatusCodes.NOT_FOUND);
      exchange.getResponseSender().send("/ /healthz /readyz /metrics\n");
    }
  }

  private static String fileName(HttpServerExchange exchange) {
    String path = exchange.getRequestPath();
    return path.equals("/") ? "index.html" : path.substring(1);
  }

  /** Tells the operator once that visitors share the address of a proxy. */
  private void warnOfProxy(HttpServerExchange exchange) {
    if (!proxyTold && origins.isByUnknownProxy(exchange)) {
      proxyTold = true;
      LOG.warn(
          "page: a proxy at {} hands on requests, and its visitors share its address; if it is"
              + " yours: --web-behind {}",
          exchange.getSourceAddress().getAddress().getHostAddress(),
          exchange.getSourceAddress().getAddress().getHostAddress());
    }
  }

  private static void refuse(HttpServerExchange exchange, String why) {
    exchange.setStatusCode(StatusCodes.FORBIDDEN);
    exchange.getResponseSender().send(why + "\n");
  }

  private void connected(WebSocketHttpExchange exchange, WebSocketChannel channel) {
    Viewer viewer = new Viewer(channel, exchange.getAttachment(ORIGIN), System.nanoTime());
    viewers.add(viewer);
    strangerGivesWay();
    channel.addCloseTask(closed -> viewers.remove(viewer));
    channel
        .getReceiveSetter()
        .set(
            new AbstractReceiveListener() {
              @Override
              protected long getMaxTextBufferSize() {
                return MAX_MESSAGE_BYTES;
              }

              @Override
              protected long getMaxBinaryBufferSize() {
                return 1;
              }

              @Override
              protected void onFullTextMessage(WebSocketChannel from, BufferedTextMessage message) {
                receive(viewer, message.getData());
              }
            });
    channel.resumeReceives();
    clock.execute(LastingThread.guarded(() -> begin(viewer)));
  }

  private void begin(Viewer viewer) {
    if (pictures == null) {
      pictures =
          clock.scheduleWithFixedDelay(
              LastingThread.guarded(this::pictures), 0, PICTURE_MS, TimeUnit.MILLISECONDS);
    }
    greet(viewer);
  }

  /**
   * Ends the oldest page without the secret, of the address that has most of them, if there are too
   * many: strangers keep neither each other nor an operator out.
   */
  private void strangerGivesWay() {
    List<Viewer> strangers = viewers.stream().filter(viewer -> !viewer.isAdmin()).toList();
    if (strangers.size() <= MAX_VIEWERS) {
      return;
    }
    Map<InetAddress, Long> counts =
        strangers.stream().collect(Collectors.groupingBy(Viewer::address, Collectors.counting()));
    strangers.stream()
        .min(Comparator.comparing(viewer -> -counts.get(viewer.address()))) // the first of equals
        .ifPresent(
            viewer -> {
              viewers.remove(viewer);
              viewer.refuse("too many pages are open");
            });
  }

  private boolean watches(Viewer viewer) {
    return viewer.isAdmin() || (config.strangersWatch() && viewer.isHere());
  }

  private void greet(Viewer viewer) {
    viewer.send(
        PageJson.hello(config, List.copyOf(histories.values()), viewer.isAdmin(), watches(viewer)));
  }

  /** Takes a message of a viewer; one that breaks a rule ends its connection. */
  private void receive(Viewer viewer, String text) {
    if (!viewer.heard(System.nanoTime())) {
      viewer.refuse("too many messages");
      return;
    }
    try {
      Json message = Json.parse(text.getBytes(StandardCharsets.UTF_8));
      switch (string(message, "do")) {
        case "alive" -> {}
        case "look" -> look(viewer, message);
        case "login" -> login(viewer, string(message, "secret"));
        default -> command(viewer, message);
      }
    } catch (JsonException e) {
      viewer.refuse("the message isn't JSON");
    }
  }

  private static String string(Json message, String field) {
    Json value = message.fields.get(field);
    return value == null ? "" : value.text;
  }

  private static int number(Json message, String field, int otherwise) {
    Json value = message.fields.get(field);
    return value == null || value.kind != Json.Kind.NUMBER ? otherwise : (int) value.number;
  }

  private static boolean truth(Json message, String field) {
    Json value = message.fields.get(field);
    return value != null && value.truth;
  }

  private void look(Viewer viewer, Json message) {
    String room = string(message, "room");
    viewer.look(
        new Viewer.Gaze(
            watches(viewer) && rooms.stream().anyMatch(each -> each.name().equals(room))
                ? room
                : null,
            truth(message, "cells"),
            truth(message, "contacts"),
            number(message, "priority", -1)));
  }

  private void login(Viewer viewer, String secret) {
    if (config.throttle().mustWait(viewer.address())) {
      viewer.send(PageJson.refused("too many wrong tries; wait a minute"));
    } else if (!config.secret().matches(secret)) {
      config.throttle().wrong(viewer.address());
      LOG.warn("page: a wrong token from {}", viewer.address().getHostAddress());
      viewer.send(PageJson.refused("wrong token"));
    } else if (viewers.stream().filter(Viewer::isAdmin).count() >= MAX_OPERATORS) {
      viewer.send(PageJson.refused("too many pages of operators are open; close one"));
    } else {
      config.throttle().right(viewer.address());
      LOG.info("page: {} logged in", viewer.address().getHostAddress());
      viewer.becomeAdmin();
      clock.execute(LastingThread.guarded(() -> greet(viewer)));
    }
  }

  private void command(Viewer viewer, Json message) {
    if (!viewer.isAdmin()) {
      viewer.send(PageJson.refused("log in first"));
      return;
    }
    String what = string(message, "do");
    int id = number(message, "id", 0);
    String text = string(message, "text");
    try {
      commands.execute(LastingThread.guarded(() -> carryOut(viewer, what, id, text)));
    } catch (RejectedExecutionException e) {
      viewer.send(
          PageJson.answer(
              id, new CommandRegistry.Answer(false, "too many commands; wait a moment")));
    }
  }

  private void carryOut(Viewer viewer, String what, int id, String text) {
    switch (what) {
      case "run" -> {
        viewer.send(PageJson.answer(id, config.commands().run(text, caller(viewer))));
      }
      case "complete" -> {
        List<Quoting.Word> words = Quoting.begunWords(text);
        int last = words.size() - 1;
        boolean begun =
            last >= 0
                && (words.get(last).isOpen()
                    || !Character.isWhitespace(text.charAt(text.length() - 1)));
        String start = begun ? words.get(last).text() : "";
        String before = begun ? text.substring(0, words.get(last).begin()) : text;
        List<String> whole =
            words.stream().limit(begun ? last : last + 1).map(Quoting.Word::text).toList();
        List<String> next = config.commands().complete(whole, caller(viewer));
        List<String> fitting =
            next.stream()
                .filter(word -> startsWith(word, start))
                .limit(20)
                .map(Quoting::shown)
                .toList();
        viewer.send(PageJson.words(id, before, fitting));
      }
      case "recordings" -> viewer.send(PageJson.recordings(downloads.list()));
      case "download" -> {
        String address = downloads.ticket(text);
        viewer.send(
            address == null
                ? PageJson.refused("there is no such recording")
                : PageJson.download(address));
      }
      default -> viewer.refuse("there is no such message");
    }
  }

  private static Caller caller(Viewer viewer) {
    return new Caller(Role.OPERATOR, "page", viewer.address().getHostAddress());
  }

  private static boolean startsWith(String word, String start) {
    return word.regionMatches(true, 0, start, 0, start.length());
  }

  private void pictures() {
    if (viewers.isEmpty()) {
      pictures.cancel(false);
      pictures = null;
      return;
    }
    long nowNs = System.nanoTime();
    feeds.forEach(
        (room, feed) ->
            feed.turn(
                viewers.stream().filter(v -> room.name().equals(v.gaze().room())).toList(), nowNs));
  }

  /**
   * Begins with the rooms that have come, ends with those that have gone, and tells the viewers.
   */
  private void followRooms() {
    List<Room> now = List.copyOf(rooms);
    if (List.copyOf(histories.keySet()).equals(now)) {
      return;
    }
    Map<Room, RoomHistory> known = new HashMap<>(histories);
    histories.clear();
    now.forEach(
        room ->
            histories.put(
                room, known.containsKey(room) ? known.get(room) : new RoomHistory(room, begin)));
    feeds.keySet().retainAll(now);
    now.forEach(room -> feeds.computeIfAbsent(room, RoomFeed::new));
    viewers.forEach(this::greet);
  }

  private void second() {
    followRooms();
    long nowNs = System.nanoTime();
    double seconds = Math.max(1e-3, (nowNs - sampledNs) / NS_PER_S);
    sampledNs = nowNs;
    ProcessFigures process = ProcessFigures.now();
    histories.values().forEach(history -> history.sample(seconds, process));
    if (viewers.isEmpty()) {
      return;
    }
    String figures = PageJson.second(List.copyOf(histories.values()));
    String fleetNow = fleet == null ? null : PageJson.fleet(fleet.report());
    for (Viewer viewer : viewers) {
      if (nowNs - viewer.heardNs() > SILENCE_NS) {
        viewer.refuse("no sign of life");
      } else if (watches(viewer)) {
        viewer.send(figures);
        if (fleetNow != null) {
          viewer.send(fleetNow);
        }
      }
      if (viewer.isAdmin()) {
        sendLog(viewer);
      }
    }
  }

  private void sendLog(Viewer viewer) {
    List<LogTail.Line> lines = config.log().after(viewer.logSeen());
    if (!lines.isEmpty()) {
      viewer.logSeen(lines.get(lines.size() - 1).number());
      viewer.send(PageJson.log(lines));
    }
  }

  /** Ends the threads and closes all pages. */
  @Override
  public void close() {
    clock.shutdownNow();
    commands.shutdownNow();
    viewers.forEach(Viewer::close);
  }
}

package carom.server;

import static java.nio.charset.StandardCharsets.UTF_8;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The sidecar of Agones as its REST is documented, with the errors that it really gives: status 500
 * and a text for a value that is there already or isn't there.
 */
final class FakeSidecar implements AutoCloseable {
  private static final Pattern VALUE = Pattern.compile("\"value\":\"([^\"]*)\"");
  private static final Pattern NUMBER = Pattern.compile("\"(count|capacity)\":\"(\\d+)\"");

  final List<String> calls = new CopyOnWriteArrayList<>();
  final AtomicInteger healths = new AtomicInteger();
  final AtomicInteger watches = new AtomicInteger();
  final TreeSet<String> players = new TreeSet<>(); // guarded by this
  final Map<String, Integer> rooms = new TreeMap<>(Map.of("count", 0, "capacity", 2));
  volatile boolean failing;
  volatile boolean hanging;
  volatile boolean lists = true;
  volatile String state = "Scheduled";
  volatile String label = "";
  volatile int capacity = 4;
  private final String ports;
  private final List<HttpExchange> streams = new ArrayList<>(); // guarded by this
  private final ExecutorService threads =
      Executors.newCachedThreadPool(
          task -> {
            Thread thread = new Thread(task, "fake-sidecar");
            thread.setDaemon(true);
            return thread;
          });
  private final HttpServer server;

  /** Starts a sidecar at any free port, of a GameServer with these ports, as JSON. */
  FakeSidecar(String ports) throws IOException {
    this(0, ports);
  }

  FakeSidecar(int port, String ports) throws IOException {
    this.ports = ports;
    server = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), port), 0);
    server.setExecutor(threads);
    server.createContext("/", this::serve);
    server.start();
  }

  int port() {
    return server.getAddress().getPort();
  }

  private synchronized String json() {
    return "{\"object_meta\":{\"name\":\"carom-1\",\"generation\":\"1\",\"annotations\":{\"a\":\"x\\n"
               + "y\"},\"labels\":{"
        + label
        + "}},\"spec\":{\"health\":{\"period_seconds\":5}},\"status\":{\"state\":\""
        + state
        + "\",\"address\":\"127.0.0.1\",\"ports\":["
        + ports
        + "],\"counters\":{},\"lists\":{}}}";
  }

  private void serve(HttpExchange exchange) throws IOException {
    String body = new String(exchange.getRequestBody().readAllBytes(), UTF_8);
    String path = exchange.getRequestURI().getPath();
    String call = exchange.getRequestMethod() + " " + path;
    if (hanging) {
      return; // without an answer
    }
    if (failing) {
      answer(exchange, 503, "{\"code\":14,\"message\":\"of the test\"}");
      return;
    }
    if (call.equals("GET /watch/gameserver")) {
      watch(exchange);
      return;
    }
    if (call.equals("POST /health")) {
      healths.incrementAndGet();
    } else if (!call.startsWith("GET ")) {
      calls.add(call + (body.equals("{}") ? "" : " " + body));
    }
    switch (call) {
      case "GET /gameserver" -> answer(exchange, 200, json());
      case "POST /health" -> answer(exchange, 200, "{}");
      case "POST /ready" -> become(exchange, "Ready");
      case "POST /allocate" -> become(exchange, "Allocated");
      case "POST /shutdown" -> become(exchange, "Shutdown");
      case "PUT /metadata/label" -> answer(exchange, 200, "{}");
      default -> count(exchange, call, body);
    }
  }

  private void count(HttpExchange exchange, String call, String body) throws IOException {
    Matcher value = VALUE.matcher(body);
    String name = value.find() ? value.group(1) : "";
    Matcher number = NUMBER.matcher(body);
    synchronized (this) {
      if (!lists) {
        error(exchange, "CountsAndLists not enabled");
      } else if (call.equals("PATCH /v1beta1/counters/rooms") && number.find()) {
        rooms.put(number.group(1), Integer.parseInt(number.group(2)));
        if (number.find() || rooms.get("count") > rooms.get("capacity")) {
          error(exchange, "out of range");
          return;
        }
        answer(exchange, 200, "{\"name\":\"rooms\"}");
      } else if (call.equals("POST /v1beta1/lists/players:addValue")) {
        if (players.size() >= capacity) {
          error(exchange, "out of range. No available capacity.");
        } else if (!players.add(name)) {
          error(exchange, "already exists. Value: " + name);
        } else {
          answer(exchange, 200, "{}");
        }
      } else if (call.equals("POST /v1beta1/lists/players:removeValue")) {
        if (players.remove(name)) {
          answer(exchange, 200, "{}");
        } else {
          error(exchange, "not found. Value: " + name);
        }
      } else if (call.equals("GET /v1beta1/counters/rooms")) {
        answer(
            exchange, 200, "{\"name\":\"rooms\",\"capacity\":\"" + rooms.get("capacity") + "\"}");
      } else if (call.startsWith("GET /v1beta1/")) {
        answer(exchange, 200, "{}");
      } else {
        answer(exchange, 404, "{\"code\":5,\"message\":\"Not Found\"}");
      }
    }
  }

  private static void error(HttpExchange exchange, String message) throws IOException {
    answer(exchange, 500, "{\"code\":2,\"message\":\"" + message + "\"}");
  }

  private static void answer(HttpExchange exchange, int status, String body) throws IOException {
    byte[] bytes = body.getBytes(UTF_8);
    exchange.getResponseHeaders().set("Content-Type", "application/json");
    exchange.sendResponseHeaders(status, bytes.length);
    try (OutputStream out = exchange.getResponseBody()) {
      out.write(bytes);
    }
  }

  private void become(HttpExchange exchange, String newState) throws IOException {
    answer(exchange, 200, "{}");
    say(newState);
  }

  private void watch(HttpExchange exchange) throws IOException {
    exchange.sendResponseHeaders(200, 0);
    synchronized (this) {
      streams.add(exchange);
      line(exchange);
    }
    watches.incrementAndGet(); // it can be broken from now on
  }

  private void line(HttpExchange exchange) throws IOException {
    OutputStream out = exchange.getResponseBody();
    out.write(("{\"result\":" + json() + "}\n").getBytes(UTF_8));
    out.flush();
  }

  /** Changes the GameServer's state, and tells all who watch. */
  synchronized void say(String newState) {
    state = newState;
    for (HttpExchange stream : List.copyOf(streams)) {
      try {
        line(stream);
      } catch (IOException e) {
        streams.remove(stream);
      }
    }
  }

  /** Gives the GameServer a label, and tells all who watch. */
  synchronized void label(String key, String value) {
    label = "\"" + key + "\":\"" + value + "\"";
    say(state);
  }

  /** Ends all watches. */
  synchronized void breakWatches() {
    streams.forEach(HttpExchange::close);
    streams.clear();
  }

  /** Returns the calls that change the GameServer's state. */
  List<String> states() {
    return calls.stream().filter(call -> call.matches("POST /[a-z]+")).toList();
  }

  synchronized String playersNow() {
    return String.join(",", players);
  }

  synchronized String roomsNow() {
    return rooms.get("count") + "/" + rooms.get("capacity");
  }

  @Override
  public void close() {
    breakWatches();
    server.stop(0);
    threads.shutdownNow();
  }
}

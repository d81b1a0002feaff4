package carom.server.thin.web;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.suite.Needs;
import carom.text.Json;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.ByteBuffer;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Goal: programs play by WebSocket. Method: the JDK's WebSocket at a real server's port. */
@Timeout(120)
@Needs("sockets")
final class PlayServerTest {
  private static final long PATIENCE_NS = TimeUnit.SECONDS.toNanos(40);

  private PlayServer server;

  @BeforeEach
  void start() throws Exception {
    server = new PlayServer("arena");
  }

  @AfterEach
  void stop() {
    server.close();
  }

  /** A client that keeps what it was told. */
  private static final class Told implements AutoCloseable {
    final WebPlayer player;
    final ThinBooks books = new ThinBooks();
    final Map<Integer, Map<Integer, ThinBooks.Body>> shown = new TreeMap<>();
    final StringBuilder chat = new StringBuilder();
    String secret;
    int id;
    int count;
    boolean binary;

    Told(WebPlayer player, String join) throws InterruptedException {
      this.player = player;
      player.say("{\"join\": " + join + "}");
      secret = player.await("welcome").fields.get("secret").text;
      id = (int) player.await("match").fields.get("player").number;
    }

    /** Takes over what has come. */
    void read() {
      for (Object next; (next = player.told.poll()) != null; ) {
        if (next instanceof ByteBuffer bytes) {
          binary = true;
          books.bytes(bytes);
          shown.put(books.tick, new TreeMap<>(books.bodies));
          continue;
        }
        Map.Entry<String, Json> only =
            WebPlayer.parsed((String) next).fields.entrySet().iterator().next();
        switch (only.getKey()) {
          case "snapshot" -> {
            books.text(only.getValue());
            shown.put(books.tick, new TreeMap<>(books.bodies));
          }
          case "chat" -> chat.append(only.getValue().fields.get("text").text).append('\n');
          default -> {}
        }
      }
    }

    void press(double moveX) {
      player.say(
          String.format(
              Locale.ROOT,
              "{\"input\": {\"count\": %d, \"seen\": %d, \"inputs\": [[0, %s, 0, 0]]}}",
              ++count,
              books.tick,
              moveX));
    }

    ThinBooks.Body body() {
      read();
      for (ThinBooks.Body body : books.bodies.values()) {
        if (body.owner() == id) {
          return body;
        }
      }
      return null;
    }

    @Override
    public void close() {
      player.close();
    }
  }

  /** Returns the ticks that both were told of. */
  private static Set<Integer> common(Told one, Told other) {
    Set<Integer> ticks = new TreeSet<>(one.shown.keySet());
    ticks.retainAll(other.shown.keySet());
    return ticks;
  }

  private static void await(BooleanSupplier what) throws InterruptedException {
    long endNs = System.nanoTime() + PATIENCE_NS;
    while (!what.getAsBoolean()) {
      assertTrue(System.nanoTime() < endNs, "it doesn't happen");
      Thread.sleep(5);
    }
  }

  @Test
  void joinsMovesChatsAndLeaves() throws Exception {
    try (Told ann = new Told(server.player(), "{\"name\": \"Ann\"}");
        Told bob = new Told(server.player(), "{\"name\": \"Bob\", \"binary\": true}")) {
      await(() -> ann.body() != null && bob.body() != null);
      assertTrue(bob.binary);
      assertFalse(ann.binary);
      int before = ann.body().x();
      ann.press(1);
      await(() -> Math.abs(ann.body().x() - before) > 256);
      assertEquals(ann.count, ann.books.input);
      ann.press(0);
      ann.player.say("{\"chat\": {\"text\": \"h\u00e9llo \ud83d\ude00\"}}");
      await(() -> bob.body() != null && bob.chat.toString().contains("h\u00e9llo \ud83d\ude00"));
      // What both were told of a tick is the same, in either form. With fewer snapshots than ticks,
      // their ticks may differ.
      ann.player.say("{\"rate\": {\"perSecond\": 60}}");
      bob.player.say("{\"rate\": {\"perSecond\": 60}}");
      await(
          () -> {
            ann.read();
            bob.read();
            return common(ann, bob).size() >= 20;
          });
      for (int tick : common(ann, bob)) {
        assertEquals(ann.shown.get(tick), bob.shown.get(tick), "tick=" + tick);
      }
      ann.player.say("{\"leave\": {}}");
      Json goodbye = ann.player.await("goodbye");
      assertEquals("LEFT", goodbye.fields.get("reason").text);
      assertTrue(ann.player.awaitEnd().startsWith("1000"), ann.player.ended);
      await(() -> server.server.rooms().get(0).seats().takenCount() == 1);
    }
  }

  @Test
  void aLostLinkTakesItsSeatAgain() throws Exception {
    Told ann = new Told(server.player(), "{\"name\": \"Ann\"}");
    ann.close();
    try (Told again =
        new Told(server.player(), "{\"name\": \"Ann\", \"secret\": \"" + ann.secret + "\"}")) {
      assertEquals(ann.id, again.id);
      await(() -> again.body() != null);
    }
    try (Told other =
        new Told(server.player(), "{\"name\": \"Eve\", \"secret\": \"00000000000000ff\"}")) {
      assertNotEquals(ann.id, other.id, "a wrong secret is a newcomer's");
    }
  }

  @Test
  void whatCannotJoinIsRefusedWithATextForPeople() throws Exception {
    try (WebPlayer player = server.player()) {
      player.say("{\"join\": {\"name\": \"Ann\", \"room\": \"nowhere\"}}");
      Json refused = player.await("refused");
      assertEquals("ROOM_UNKNOWN", refused.fields.get("reason").text);
      assertFalse(refused.fields.get("text").text.isEmpty());
      assertTrue(player.awaitEnd().startsWith("1000"), player.ended);
    }
    try (WebPlayer player = server.player()) {
      player.say("{\"rooms\": {}}");
      Json rooms = player.await("rooms");
      assertEquals("arena", rooms.fields.get("rooms").items.get(0).fields.get("game").text);
      player.say("{\"join\": {\"name\": \"Ann\", \"room\": \"1\"}}");
      player.await("match");
      player.say("{\"chat\": {\"text\": 5}}");
      Json goodbye = player.await("goodbye");
      assertEquals("PROTOCOL_ERROR", goodbye.fields.get("reason").text);
      assertEquals("chat.text=5 must be a text", goodbye.fields.get("text").text);
      assertEquals("1000 chat.text=5 must be a text", player.awaitEnd());
    }
  }

  @Test
  void thePagesFilesAreServed() throws Exception {
    HttpClient http = HttpClient.newBuilder().followRedirects(HttpClient.Redirect.ALWAYS).build();
    for (String path : new String[] {"/", "/play", "/play/"}) {
      URI uri = URI.create("http://127.0.0.1:" + server.port.tcpPort() + path);
      HttpResponse<String> page =
          http.send(HttpRequest.newBuilder(uri).build(), HttpResponse.BodyHandlers.ofString());
      assertEquals(200, page.statusCode());
      assertTrue(page.body().startsWith("<!doctype html>"), page.body());
      assertTrue(page.uri().getPath().equals("/play/"), page.uri().toString());
      assertEquals("nosniff", page.headers().firstValue("X-Content-Type-Options").orElse(""));
    }
    URI none = URI.create("http://127.0.0.1:" + server.port.tcpPort() + "/play/../x");
    assertEquals(
        404,
        http.send(HttpRequest.newBuilder(none).build(), HttpResponse.BodyHandlers.discarding())
            .statusCode());
  }

  @Test
  void theLookOfAGameIsServedAndNothingBesideIt() throws Exception {
    HttpClient http = HttpClient.newHttpClient();
    for (String[] asked :
        new String[][] {
          {"200", "shooter/look.json"},
          {"200", "shooter/sky.png"},
          {"200", "platformer/look.json"},
          {"204", "nowhere/look.json"},
          {"404", "shooter/nothing.png"},
          {"404", "shooter/ShooterView.class"},
          {"404", "shooter/"},
          {"404", ""},
          {"404", "shooter/../shooter/sky.png"},
          {"404", "../../server/web/app.js"},
          {"404", "..%2f..%2fcarom%2fserver%2fweb/app.js"},
          {"404", "shooter%2f..%2f..%2f..%2flevels/arena.json"},
          {"404", "/shooter/sky.png"},
          {"404", "shooter/%2e%2e/sky.png"},
        }) {
      URI uri = URI.create("http://127.0.0.1:" + server.port.tcpPort() + "/play/look/" + asked[1]);
      HttpResponse<byte[]> answer =
          http.send(HttpRequest.newBuilder(uri).build(), HttpResponse.BodyHandlers.ofByteArray());
      assertEquals(asked[0], String.valueOf(answer.statusCode()), asked[1]);
      assertEquals(asked[0].equals("200"), answer.body().length > 400, asked[1]);
    }
  }
}

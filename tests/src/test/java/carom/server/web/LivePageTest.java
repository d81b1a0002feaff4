package carom.server.web;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.server.access.LoginThrottle;
import carom.suite.Needs;
import carom.text.Json;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.http.WebSocket;
import java.net.http.WebSocketHandshakeException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Goal: strangers can do no harm through the page. Method: what they would send. */
@Needs("sockets")
@Timeout(120)
final class LivePageTest {
  @TempDir private Path folder;

  private final HttpClient client = HttpClient.newHttpClient();

  /** A page as the server sees it. */
  private final class Page implements WebSocket.Listener {
    private static final String CLOSED = "{\"t\":\"closed\"}";

    private final BlockingQueue<String> texts = new LinkedBlockingQueue<>();
    private final BlockingQueue<ByteBuffer> pictures = new LinkedBlockingQueue<>();
    private final StringBuilder text = new StringBuilder();
    private final WebSocket socket;

    Page(PageRig rig) {
      this(rig, rig.web.url());
    }

    Page(PageRig rig, String origin, String... headers) {
      WebSocket.Builder builder = client.newWebSocketBuilder();
      if (origin != null) {
        builder.header("Origin", origin);
      }
      for (int i = 0; i < headers.length; i += 2) {
        builder.header(headers[i], headers[i + 1]);
      }
      URI address = URI.create(rig.web.url().replace("http:", "ws:") + "/live");
      socket = builder.buildAsync(address, this).join();
    }

    @Override
    public CompletionStage<?> onText(WebSocket from, CharSequence data, boolean last) {
      text.append(data);
      if (last) {
        texts.add(text.toString());
        text.setLength(0);
      }
      from.request(1);
      return null;
    }

    @Override
    public CompletionStage<?> onBinary(WebSocket from, ByteBuffer data, boolean last) {
      pictures.add(ByteBuffer.allocate(data.remaining()).put(data).flip());
      from.request(1);
      return null;
    }

    @Override
    public CompletionStage<?> onClose(WebSocket from, int code, String reason) {
      texts.add("{\"t\":\"closed\",\"why\":\"" + reason + "\"}");
      return null;
    }

    @Override
    public void onError(WebSocket from, Throwable error) {
      texts.add(CLOSED);
    }

    void say(String message) {
      socket.sendText(message.replace('\'', '"'), true).join();
    }

    void login(String secret) {
      say("{'do':'login','secret':'" + secret + "'}");
    }

    /** Returns the next message of a kind. */
    Json next(String kind) throws Exception {
      while (true) {
        String message = texts.poll(30, TimeUnit.SECONDS);
        assertTrue(message != null, "no " + kind);
        Json json = Json.parse(message.getBytes(StandardCharsets.UTF_8));
        if (json.fields.get("t").text.equals(kind)) {
          return json;
        }
      }
    }
  }

  private static String raw(PageRig rig, String host, String path) throws IOException {
    URI url = URI.create(rig.web.url());
    try (Socket socket = new Socket(url.getHost(), url.getPort())) {
      OutputStream out = socket.getOutputStream();
      out.write(
          ("GET " + path + " HTTP/1.1\r\nHost: " + host + "\r\nConnection: close\r\n\r\n")
              .getBytes(StandardCharsets.US_ASCII));
      InputStream in = socket.getInputStream();
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    }
  }

  @Test
  void anotherNameForThisMachineIsRefused() throws Exception {
    try (PageRig rig = new PageRig(folder, true)) {
      String port = ":" + URI.create(rig.web.url()).getPort();
      assertTrue(raw(rig, "evil.example" + port, "/").startsWith("HTTP/1.1 403"));
      assertTrue(raw(rig, "evil.example" + port, "/live").startsWith("HTTP/1.1 403"));
      assertTrue(raw(rig, "127.0.0.1.evil.example", "/app.js").startsWith("HTTP/1.1 403"));
      assertTrue(raw(rig, "127.0.0.1" + port, "/").startsWith("HTTP/1.1 200"));
      assertTrue(raw(rig, "localhost" + port, "/").startsWith("HTTP/1.1 200"));
      assertTrue(raw(rig, "carom.example", "/").startsWith("HTTP/1.1 200"));
      // Probes and scrapers use any name, and learn nothing secret.
      assertTrue(raw(rig, "pod-7.cluster", "/healthz").startsWith("HTTP/1.1 200"));
    }
  }

  @Test
  void anotherSitesPageIsRefused() throws Exception {
    try (PageRig rig = new PageRig(folder, true)) {
      for (String origin : new String[] {"http://evil.example", "null", null}) {
        CompletionException e =
            assertThrows(CompletionException.class, () -> new Page(rig, origin), origin);
        WebSocketHandshakeException refused = (WebSocketHandshakeException) e.getCause();
        assertEquals(403, refused.getResponse().statusCode());
      }
      assertEquals("Carom test", new Page(rig).next("hello").fields.get("title").text);
    }
  }

  @Test
  void theBrowserMayLoadNothingFromElsewhere() throws Exception {
    try (PageRig rig = new PageRig(folder, true)) {
      for (String path : Set.of("/", "/app.js", "/scene.js", "/charts.js", "/page.css")) {
        HttpResponse<String> answer =
            client.send(
                HttpRequest.newBuilder(URI.create(rig.web.url() + path)).build(),
                HttpResponse.BodyHandlers.ofString());
        assertEquals(200, answer.statusCode(), path);
        String policy = answer.headers().firstValue("Content-Security-Policy").orElse("");
        assertTrue(policy.startsWith("default-src 'none'; script-src 'self'"), policy);
        assertFalse(policy.contains("unsafe"), policy);
        assertEquals("nosniff", answer.headers().firstValue("X-Content-Type-Options").orElse(""));
        assertFalse(answer.body().contains("innerHTML"), path);
        assertFalse(answer.body().replace("http://www.w3.org/", "").contains("http://"), path);
      }
      assertTrue(raw(rig, "localhost", "/..%2f..%2fadmin.token").startsWith("HTTP/1.1 404"));
    }
  }

  @Test
  void aStrangerWatchesButCommandsNothing() throws Exception {
    try (PageRig rig = new PageRig(folder, true)) {
      Page page = new Page(rig);
      Json hello = page.next("hello");
      assertTrue(hello.fields.get("watches").truth);
      assertFalse(hello.fields.get("admin").truth);
      page.say("{'do':'look','room':'1','cells':true,'contacts':true}");
      assertEquals("1", page.next("match").fields.get("room").text);
      assertFalse(page.next("looks").fields.get("bodies").items.isEmpty());
      Json players = page.next("players");
      assertEquals(2, players.fields.get("players").items.size());
      assertNull(players.fields.get("players").items.get(0).fields.get("address"));
      for (String what : Set.of("run", "complete", "recordings", "download")) {
        page.say("{'do':'" + what + "','id':1,'text':'kick Ann'}");
        assertEquals("log in first", page.next("refused").fields.get("why").text);
      }
      ByteBuffer picture = page.pictures.poll(10, TimeUnit.SECONDS).order(ByteOrder.LITTLE_ENDIAN);
      assertTrue(picture.getInt(4) > 10, "bodies=" + picture.getInt(4));
    }
  }

  @Test
  void beyondLoopbackAStrangerSeesNothing() throws Exception {
    try (PageRig rig = new PageRig(folder, false)) {
      Page page = new Page(rig);
      Json hello = page.next("hello");
      assertFalse(hello.fields.get("watches").truth);
      assertNull(hello.fields.get("rooms"));
      page.say("{'do':'look','room':'1'}");
      page.login("wrong");
      assertEquals("wrong token", page.next("refused").fields.get("why").text);
      assertNull(page.pictures.poll(1, TimeUnit.SECONDS));
      page.login(PageRig.TOKEN);
      assertTrue(page.next("hello").fields.get("admin").truth);
      page.say("{'do':'look','room':'1'}");
      assertTrue(page.pictures.poll(20, TimeUnit.SECONDS) != null);
      assertTrue(
          page.next("players").fields.get("players").items.get(0).fields.containsKey("address"));
    }
  }

  @Test
  void strangersKeepNoOperatorOutNorEachOther() throws Exception {
    try (PageRig rig = new PageRig(folder, false)) {
      List<Page> strangers = new ArrayList<>();
      for (int i = 0; i < 2 * LivePage.MAX_VIEWERS; i++) {
        strangers.add(new Page(rig));
      }
      Page operator = new Page(rig);
      assertFalse(operator.next("hello").fields.get("admin").truth);
      operator.login(PageRig.TOKEN);
      assertTrue(operator.next("hello").fields.get("admin").truth);
      assertEquals(
          "too many pages are open", strangers.get(0).next("closed").fields.get("why").text);
      for (int i = 0; i < LivePage.MAX_VIEWERS; i++) {
        strangers.add(new Page(rig));
      }
      operator.say("{'do':'complete','id':1,'text':'kic'}");
      operator.next("words");
    }
    try (PageRig rig = new PageRig(folder, true)) {
      Page first = new Page(rig);
      for (int i = 0; i < LivePage.MAX_VIEWERS; i++) {
        assertTrue(new Page(rig).next("hello").fields.get("watches").truth);
      }
      assertEquals("too many pages are open", first.next("closed").fields.get("why").text);
    }
  }

  private Page from(PageRig rig, String address) {
    return new Page(rig, rig.web.url(), "X-Forwarded-For", address);
  }

  @Test
  void behindAProxyNobodyWatchesAndWrongTokensLockOutTheirSendersAlone() throws Exception {
    try (PageRig rig = new PageRig(folder, "127.0.0.0/8")) {
      for (int i = 0; i < 2 * LivePage.MAX_VIEWERS; i++) {
        Page stranger = from(rig, "203.0.113." + i % 4);
        assertFalse(stranger.next("hello").fields.get("watches").truth);
        stranger.login("guess " + i);
      }
      Page guesser = from(rig, "203.0.113.1");
      guesser.login(PageRig.TOKEN);
      assertTrue(guesser.next("refused").fields.get("why").text.startsWith("too many wrong tries"));
      Page spoofer = from(rig, "198.51.100.7, 203.0.113.1");
      spoofer.login(PageRig.TOKEN);
      assertTrue(spoofer.next("refused").fields.get("why").text.startsWith("too many wrong tries"));
      Page operator = from(rig, "203.0.113.1, 198.51.100.7");
      operator.login(PageRig.TOKEN);
      operator.next("hello");
      assertTrue(operator.next("hello").fields.get("admin").truth);
      assertFalse(new Page(rig).next("hello").fields.get("watches").truth);
    }
  }

  @Test
  void aVisitorByAProxyThatNobodyNamedDoesNotWatch() throws Exception {
    try (PageRig rig = new PageRig(folder, true)) {
      assertTrue(new Page(rig).next("hello").fields.get("watches").truth);
      for (String header :
          List.of("X-Forwarded-For", "Forwarded", "Via", "X-Real-IP", "X-Forwarded-Proto")) {
        Page page = new Page(rig, rig.web.url(), header, "127.0.0.1");
        assertFalse(page.next("hello").fields.get("watches").truth, header);
      }
    }
  }

  @Test
  void guessingIsSlow() throws Exception {
    try (PageRig rig = new PageRig(folder, true)) {
      Page page = new Page(rig);
      for (int i = 0; i < LoginThrottle.MOST; i++) {
        page.login("guess " + i);
        assertEquals("wrong token", page.next("refused").fields.get("why").text);
      }
      Page another = new Page(rig);
      another.login(PageRig.TOKEN); // even the right one has to wait now
      assertTrue(another.next("refused").fields.get("why").text.startsWith("too many wrong tries"));
    }
  }

  @Test
  void anUpgradeThatNamesNoProtocolIsABadRequest() throws Exception {
    try (PageRig rig = new PageRig(folder, true)) {
      URI url = URI.create(rig.web.url());
      String request =
          "GET /live HTTP/1.1\r\nHost: localhost\r\nOrigin: http://localhost\r\n"
              + "Connection: Upgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
              + "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n";
      try (Socket socket = new Socket(url.getHost(), url.getPort())) {
        socket.getOutputStream().write(request.getBytes(StandardCharsets.US_ASCII));
        byte[] answer = socket.getInputStream().readNBytes(12);
        assertEquals("HTTP/1.1 400", new String(answer, StandardCharsets.US_ASCII));
      }
    }
  }

  @Test
  void whoFloodsOrSendsNonsenseIsCutOff() throws Exception {
    try (PageRig rig = new PageRig(folder, true)) {
      for (int i = 0; i < 50; i++) {
        Page nonsense = new Page(rig);
        nonsense.say("{'do':");
        assertEquals("the message isn't JSON", nonsense.next("closed").fields.get("why").text);
      }
      Page list = new Page(rig);
      list.say("[1,2]");
      list.say("{'do':{'a':1},'x':null}");
      assertEquals("log in first", list.next("refused").fields.get("why").text);
      Page large = new Page(rig);
      large.say("{'do':'login','secret':'" + "x".repeat(20_000) + "'}");
      large.next("closed");
      Page flood = new Page(rig);
      assertThrows(
          CompletionException.class,
          () -> {
            for (int i = 0; i < 100_000; i++) {
              flood.say("{'do':'alive'}");
            }
          });
    }
  }

  @Test
  void aRecordingIsDownloadedOnceForATicket() throws Exception {
    try (PageRig rig = new PageRig(folder, true)) {
      Path recordings = Files.createDirectories(folder.resolve("recordings"));
      Files.writeString(recordings.resolve("a game.carom"), "0123456789");
      Files.writeString(recordings.resolve("notes.txt"), "private");
      Page page = new Page(rig);
      page.login(PageRig.TOKEN);
      page.say("{'do':'recordings'}");
      Json files = page.next("recordings").fields.get("files");
      assertEquals(1, files.items.size());
      assertEquals("a game.carom", files.items.get(0).fields.get("name").text);
      for (String name : Set.of("notes.txt", "../admin.token", "x.carom", "")) {
        page.say("{'do':'download','text':'" + name + "'}");
        assertEquals("there is no such recording", page.next("refused").fields.get("why").text);
      }
      page.say("{'do':'download','text':'a game.carom'}");
      URI address = URI.create(rig.web.url() + page.next("download").fields.get("address").text);
      HttpRequest request = HttpRequest.newBuilder(address).build();
      HttpResponse<String> answer = client.send(request, HttpResponse.BodyHandlers.ofString());
      assertEquals("0123456789", answer.body());
      assertEquals(
          "attachment; filename=\"a_game.carom\"",
          answer.headers().firstValue("Content-Disposition").orElse(""));
      assertEquals(403, client.send(request, HttpResponse.BodyHandlers.discarding()).statusCode());
    }
  }

  @Test
  void anAddressIsThatOfTheMachineThatTries() {
    long[] now = {0};
    LoginThrottle throttle = new LoginThrottle(() -> now[0]);
    InetAddress one = InetAddress.getLoopbackAddress();
    assertFalse(throttle.mustWait(one));
    for (int i = 0; i < LoginThrottle.MOST; i++) {
      assertFalse(throttle.mustWait(one));
      throttle.wrong(one);
    }
    assertTrue(throttle.mustWait(one));
    now[0] += 60_000_000_000L;
    assertFalse(throttle.mustWait(one));
  }
}

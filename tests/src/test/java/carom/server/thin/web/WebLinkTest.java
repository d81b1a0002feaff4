package carom.server.thin.web;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.protocol.ClientMessage;
import carom.net.transport.Link;
import carom.net.transport.LinkHandler;
import carom.server.thin.ThinNews;
import carom.server.thin.ThinServerMessage;
import carom.server.thin.ThinSnapshot;
import carom.suite.Needs;
import carom.text.Json;
import java.io.IOException;
import java.net.InetAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Goal: the door carries what both ends say. Method: the JDK's WebSocket at a port without rooms.
 */
@Timeout(120)
@Needs("sockets")
final class WebLinkTest {
  private static final List<InetAddress> HERE = List.of(InetAddress.getLoopbackAddress());

  private final List<Object> heard = new ArrayList<>();
  private final LinkHandler handler =
      new LinkHandler() {
        @Override
        public void message(Link link, Object message) {
          heard.add(message);
        }

        @Override
        public void datagram(Link link, byte[] bytes, int length) {}

        @Override
        public void closed(Link link, String reason) {
          heard.add("closed: " + reason);
        }
      };
  private PlayPort port;

  @BeforeEach
  void open() throws IOException {
    port = new PlayPort(PlayPort.Settings.plain(HERE, 0, 8));
  }

  @AfterEach
  void close() {
    port.close();
  }

  private WebLink accept() throws InterruptedException {
    for (Link link; ; Thread.sleep(2)) {
      if ((link = port.accept()) != null) {
        return (WebLink) link;
      }
    }
  }

  private Object hear(WebLink link) throws InterruptedException {
    long endNs = System.nanoTime() + TimeUnit.SECONDS.toNanos(30);
    while (heard.isEmpty() && System.nanoTime() < endNs) {
      link.poll(handler, 10);
      Thread.sleep(2);
    }
    return heard.remove(0);
  }

  private static ThinSnapshot snapshot(int tick) {
    ThinSnapshot snapshot = new ThinSnapshot();
    snapshot.tick = tick;
    snapshot.input = 7;
    snapshot.id = new int[] {3, 300};
    snapshot.x = new int[] {512 * tick, -1};
    snapshot.y = new int[] {-256, 10};
    snapshot.angle = new int[] {1_023, 512};
    snapshot.archetype = new int[] {tick == 1 ? 5 : -1, -1};
    snapshot.owner = new int[] {-1, -1};
    snapshot.count = tick == 1 ? 1 : 2;
    snapshot.archetype[1] = tick == 2 ? 0 : -1;
    snapshot.gone = new int[] {9, 12};
    snapshot.goneCount = tick == 2 ? 2 : 0;
    return snapshot;
  }

  @Test
  void textsGoBothWays() throws Exception {
    try (WebPlayer player = new WebPlayer(port.tcpPort())) {
      WebLink link = accept();
      player.say("{\"join\": {\"name\": \"Ann\", \"room\": \"cup\", \"more\": [1, {}]}}");
      ClientMessage.Hello hello = (ClientMessage.Hello) hear(link);
      assertEquals("Ann", hello.name());
      assertTrue(link.isPlainText());
      link.news(List.of(new ThinNews(new ThinServerMessage.Welcome(1, -2, 60, 30))));
      Json welcome = player.await("welcome");
      assertEquals("fffffffffffffffe", welcome.fields.get("secret").text);
      assertEquals(60, welcome.fields.get("tickRate").number);
      player.say(
          "{\"input\": {\"count\": 5, \"seen\": 4, \"inputs\": [[1, 0, -2, 0], [2,0,0,0]]}}");
      while (link.inputCount() != 5) {
        Thread.sleep(1);
      }
      long input = link.takeInput();
      assertEquals(1, input & 0xffff, "the first input of a client stands alone");
      assertEquals(-127, (byte) (input >> 24), "moves are cut");
      awaitRoom(link);
      link.show(snapshot(1));
      Json told = player.await("snapshot");
      assertEquals(1, told.fields.get("tick").number);
      Json body = told.fields.get("bodies").items.get(0);
      assertEquals(List.of("3", "1", "-0.5", "6.277", "5", "-1"), texts(body));
      player.say("{\"leave\": {}}");
      assertEquals(new ClientMessage.Leave(), hear(link));
    }
  }

  private static ThinNews event(int kind) {
    return new ThinNews(new ThinServerMessage.Event(kind, 9, 1, -0.5f, 2, -1, 3, -1, 0));
  }

  @Test
  void eventsThatAreToldTogetherAreOneTextAndKeepTheirOrder() throws Exception {
    try (WebPlayer player = new WebPlayer(port.tcpPort())) {
      WebLink link = accept();
      ThinNews chat = new ThinNews(new ThinServerMessage.Chat(1, "hi", false));
      link.news(List.of(event(0), event(1), chat, event(2)));
      Json two = player.await("events").fields.get("events");
      assertEquals(2, two.items.size());
      assertEquals(0, two.items.get(0).fields.get("kind").number);
      assertEquals(-0.5, two.items.get(1).fields.get("y").number);
      assertEquals("hi", player.await("chat").fields.get("text").text);
      assertEquals(1, player.await("events").fields.get("events").items.size());
    }
  }

  @Test
  void nothingFollowsTheLastWordsWhateverIsToldMeanwhile() throws Exception {
    for (int round = 0; round < 20; round++) {
      try (WebPlayer player = new WebPlayer(port.tcpPort())) {
        WebLink link = accept();
        Thread room =
            new Thread(
                () -> {
                  int sent = 0; // fewer than may wait
                  while (sent < 20_000 && link.news(List.of(event(0)))) {
                    sent++;
                  }
                });
        room.start();
        player.await("events");
        player.say("[]");
        assertTrue(player.awaitEnd() != null, "round=" + round);
        room.join();
        String last = "";
        for (Object text; (text = player.told.poll()) != null; ) {
          last = (String) text;
        }
        assertTrue(last.startsWith("{\"refused\""), "round=" + round + " last=" + last);
      }
    }
  }

  private static void awaitRoom(WebLink link) throws InterruptedException {
    while (!link.takesSnapshot()) {
      Thread.sleep(1);
    }
  }

  private static List<String> texts(Json list) {
    return list.items.stream().map(item -> item.text).toList();
  }

  @Test
  void whatIsWrongIsSaid() throws Exception {
    for (String[] wrong :
        new String[][] {
          {"{\"join\": {\"name\": 5}}", "join.name=5 must be a text"},
          {"{\"jion\": {}}", "there is no message \"jion\"; did you mean \"join\"?"},
          {"{\"rate\": {}}", "rate.perSecond is missing"},
          {"{\"input\": {\"count\": 1, \"inputs\": [[1, 2]]}}", "input.inputs[0]=a list must be"},
          {"[]", "a message is an object with one key"},
          {"{\"alive\": {}", "not JSON: Unexpected end-of-input"},
          {
            "{\"chat\": {\"text\": \"x\", \"team\": \"y\"}}",
            "chat.team=\"y\" must be true or false"
          }
        }) {
      try (WebPlayer player = new WebPlayer(port.tcpPort())) {
        WebLink link = accept();
        player.say(wrong[0]);
        Json refused = player.await("refused");
        assertEquals("BAD_REQUEST", refused.fields.get("reason").text);
        assertTrue(
            refused.fields.get("text").text.startsWith(wrong[1]), refused.fields.get("text").text);
        assertTrue(player.awaitEnd().startsWith("1000 " + wrong[1].substring(0, 3)), player.ended);
        assertTrue(hear(link).toString().startsWith("closed: "));
      }
    }
  }

  @Test
  void aClientThatDoesNotReadGetsNoSnapshots() throws Exception {
    try (WebPlayer player = new WebPlayer(port.tcpPort())) {
      WebLink link = accept();
      awaitRoom(link);
      ThinSnapshot large = new ThinSnapshot();
      large.id = new int[200];
      large.x = new int[200];
      large.y = new int[200];
      large.angle = new int[200];
      large.archetype = new int[200];
      large.owner = new int[200];
      large.count = 200;
      player.pause();
      int shown = 0;
      long endNs = System.nanoTime() + TimeUnit.SECONDS.toNanos(3);
      while (System.nanoTime() < endNs) {
        if (link.takesSnapshot()) {
          large.tick = ++shown;
          link.show(large);
        }
        Thread.sleep(2);
      }
      assertTrue(shown <= 64, "shown=" + shown);
      assertFalse(link.takesSnapshot());
      player.resume();
      awaitRoom(link);
    }
  }
}

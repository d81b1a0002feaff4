package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.kryo.KryoClientTransport;
import carom.net.kryo.server.KryoServerTransport;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.Protocol;
import carom.net.transport.Link;
import carom.server.config.RoomConfig;
import carom.server.config.ServerConfig;
import carom.server.match.HandedInMatch;
import carom.server.metrics.Counter;
import carom.server.room.Room;
import carom.suite.Needs;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.classic.spi.ThrowableProxyUtil;
import ch.qos.logback.core.read.ListAppender;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.slf4j.LoggerFactory;

/**
 * Goal: a game that hangs costs its own room a few seconds, and the others nothing. Method: a
 * server with threads and sockets; a callback that waits on demand, or loops where the others are
 * looked at.
 */
@Needs("sockets")
@Timeout(120)
class HangTest {
  @TempDir Path folder;
  private final TestGame[] games = new TestGame[32];
  private int made;

  /** Makes the set-up of games that are made from now on loop. */
  private boolean setUpsHang;

  private Server server;
  private KryoClientTransport transport;

  @AfterEach
  void end() throws Exception {
    synchronized (this) {
      setUpsHang = false; // first: a thread that comes back makes another game
    }
    for (TestGame game : games) {
      if (game != null) {
        game.hangs = false;
        game.loops = false;
        game.hangsInSetUp = false;
      }
    }
    transport.close();
    server.close();
    await("no thread hangs any longer", () -> !hangsInTestGame());
  }

  private static boolean hangsInTestGame() {
    return Thread.getAllStackTraces().values().stream()
        .flatMap(Arrays::stream)
        .anyMatch(frame -> frame.getClassName().equals(TestGame.class.getName()));
  }

  private synchronized TestGame make() {
    games[made] = new TestGame(2);
    games[made].hangsInSetUp = setUpsHang;
    return games[made++];
  }

  private void start(boolean keeps) throws Exception {
    start(keeps, 0);
  }

  private void start(boolean keeps, int more) throws Exception {
    KryoServerTransport sockets = new KryoServerTransport(0, 0);
    List<RoomConfig> rooms = new ArrayList<>();
    rooms.add(new RoomConfig("hangs", "", List.of("test"), 4, 1, Map.of()));
    rooms.add(new RoomConfig("goes-on", "", List.of("test"), 4, 2, Map.of()));
    for (int i = 0; i < more; i++) {
      rooms.add(new RoomConfig("more-" + i, "", List.of("test"), 4, 3 + i, Map.of()));
    }
    server =
        new Server(
            KeptServer.CONFIG.with(ServerConfig.ROOM_THREADS, more == 0 ? 2 : 3),
            rooms,
            new HandedInMatch(this::make, TestGame.shortLevel()),
            sockets,
            System::nanoTime);
    if (keeps) {
      server.checkpoint(folder, 1);
    }
    server.start();
    transport = new KryoClientTransport();
  }

  private FakeClient join(String name, String room, long secret) throws Exception {
    FakeClient client =
        new FakeClient(transport.connect("127.0.0.1", server.tcpPort(), server.udpPort()));
    await("the link is open", () -> client.link.state() == Link.State.OPEN);
    client.link.send(
        new ClientMessage.Hello(
            Protocol.VERSION, Protocol.physicsDigest(), name, secret, room, "", "", ""));
    return client;
  }

  private void play(FakeClient client, Room room) throws Exception {
    await(
        "it plays",
        () -> {
          client.step(room.tick());
          return client.decoder != null && client.decoder.hasAck();
        });
  }

  private static void await(String what, BooleanSupplier done) throws Exception {
    long endNs = System.nanoTime() + TimeUnit.SECONDS.toNanos(30);
    while (!done.getAsBoolean()) {
      assertTrue(System.nanoTime() < endNs, what + " isn't so after 30 s");
      Thread.sleep(5);
    }
  }

  @Test
  void aRoomWhoseGameHangsGoesOnFromItsCheckpointAndTheOtherNoticesNothing() throws Exception {
    start(true);
    Room hanging = server.rooms().get(0);
    Room other = server.rooms().get(1);
    FakeClient ann = join("Ann", "hangs", 0);
    play(ann, hanging);
    await("checkpoints are there", () -> hanging.counters().get(Counter.CHECKPOINTS) >= 2);
    int tick = hanging.tick();
    int age = other.age();
    long beganNs = System.nanoTime();
    games[0].loops = true;
    await("it is found", () -> server.count(Counter.CALLBACKS_ABANDONED) == 1);
    await(
        "its thread has the lowest priority",
        () ->
            Thread.getAllStackTraces().keySet().stream()
                .anyMatch(
                    thread ->
                        thread.getName().startsWith("carom-rooms-")
                            && thread.getPriority() == Thread.MIN_PRIORITY));
    await(
        "the link is closed",
        () -> {
          ann.step(0);
          return ann.closed;
        });
    await("another room is in its place", () -> server.rooms().get(0) != hanging);
    Room next = server.rooms().get(0);
    FakeClient back = join("Ann", "", ann.welcome.sessionSecret());
    play(back, next);
    double seconds = (System.nanoTime() - beganNs) * 1e-9;
    assertEquals("hangs", back.welcome.room());
    assertEquals(ann.welcome.playerId(), back.welcome.playerId());
    assertTrue(next.tick() > tick - 60, "tick=" + next.tick() + " after " + tick);
    assertEquals(1, server.count(Counter.ROOMS_RESUMED));
    assertSame(other, server.rooms().get(1));
    assertTrue(other.age() - age > 20 * seconds, "ticks=" + (other.age() - age) + " in " + seconds);
    assertFalse(server.hasFailed());
  }

  /** Rooms have three threads here. Two that hang leave one, and two more come. */
  @Test
  void twoOfManyRoomsHangAndTheOthersKeepTheirPace() throws Exception {
    start(false, 22);
    List<Room> before = List.copyOf(server.rooms());
    await("all run", () -> before.stream().allMatch(room -> room.age() > 60));
    int[] ages = before.stream().mapToInt(Room::age).toArray();
    long beganNs = System.nanoTime();
    games[4].loops = true;
    games[17].loops = true;
    await("both are found", () -> server.count(Counter.CALLBACKS_ABANDONED) == 2);
    double seconds = (System.nanoTime() - beganNs) * 1e-9;
    for (int i = 0; i < ages.length; i++) {
      int ticks = before.get(i).age() - ages[i];
      boolean hangs = i == 4 || i == 17;
      assertTrue(hangs ? ticks < 60 : ticks > 20 * seconds, i + ": " + ticks + " in " + seconds);
    }
    await(
        "both begin anew",
        () ->
            server.rooms().get(4) != before.get(4)
                && server.rooms().get(17) != before.get(17)
                && server.rooms().stream().allMatch(room -> room.age() > 60));
    assertFalse(server.hasFailed());
  }

  @Test
  void withoutCheckpointsTheRoomBeginsAnew() throws Exception {
    start(false);
    Room hanging = server.rooms().get(0);
    games[0].hangs = true;
    await("another room is in its place", () -> server.rooms().get(0) != hanging);
    FakeClient ann = join("Ann", "hangs", 0);
    play(ann, server.rooms().get(0));
    assertEquals(0, server.count(Counter.ROOMS_RESUMED));
  }

  @Test
  void withTwoAbandonedThreadsOfTwoTheServerEndsForItsSupervisor() throws Exception {
    start(true);
    Room hanging = server.rooms().get(0);
    games[0].hangs = true;
    await("another room is in its place", () -> server.rooms().get(0) != hanging);
    assertFalse(server.hasFailed());
    games[1].hangs = true;
    server.awaitStop(); // the test's timeout would end it
    assertTrue(server.hasFailed(), "so that the process ends with another code than 0");
  }

  /** Ends the match of a room's game; waits until the next one is made, which loops or doesn't. */
  private TestGame matchOver(TestGame game, boolean nextHangs) throws Exception {
    int before;
    synchronized (this) {
      before = made;
      setUpsHang = nextHangs;
    }
    game.over = true;
    await("another game is made", () -> made() > before);
    return games[before];
  }

  private synchronized int made() {
    return made;
  }

  @Test
  void aSetUpThatHangsIsNamedAndTheOtherRoomsRotateOn() throws Exception {
    Logger logger = (Logger) LoggerFactory.getLogger(HangingRooms.class);
    ListAppender<ILoggingEvent> lines = new ListAppender<>();
    lines.start();
    logger.addAppender(lines);
    try {
      start(false);
      Room hanging = server.rooms().get(0);
      Room other = server.rooms().get(1);
      long beganNs = System.nanoTime();
      matchOver(games[0], true);
      synchronized (this) {
        setUpsHang = false;
      }
      int age = hanging.age();
      games[1].over = true; // waits behind the one that hangs
      await("the other room plays its next match", () -> other.match().number() == 2);
      double seconds = (System.nanoTime() - beganNs) * 1e-9;
      assertTrue(seconds > 9, "found after " + seconds + " s");
      assertEquals(1, hanging.counters().get(Counter.CALLBACKS_ABANDONED));
      assertEquals(0, other.counters().get(Counter.CALLBACKS_ABANDONED));
      assertEquals(List.of(hanging, other), server.rooms());
      assertEquals(1, hanging.match().number());
      assertTrue(hanging.age() - age > 20 * (seconds - 1), "ticks=" + (hanging.age() - age));
      assertTrue(
          Thread.getAllStackTraces().keySet().stream()
              .anyMatch(
                  thread ->
                      thread.getName().equals("carom-loader")
                          && thread.getPriority() == Thread.MIN_PRIORITY));
      ILoggingEvent event = lines.list.get(0);
      String line = event.getFormattedMessage();
      assertTrue(
          line.startsWith(
              "room hangs: game=\"test\" level=\"test\": its set-up hangs in setUp of "
                  + TestGame.class.getName()),
          line);
      String stack = ThrowableProxyUtil.asString(event.getThrowableProxy());
      assertTrue(stack.contains(TestGame.class.getName() + ".setUp(TestGame.java:"), stack);
      await( // ten seconds later: a match that failed isn't tried again at once
          "the room plays its next match, too",
          () -> {
            games[0].over = true;
            return hanging.match().number() > 1;
          });
      assertFalse(server.hasFailed());
    } finally {
      logger.detachAppender(lines);
    }
  }

  @Test
  void aSetUpAndACallbackThatHangAreTwoAbandonedThreads() throws Exception {
    start(true);
    matchOver(games[0], true);
    await("it is found", () -> server.count(Counter.CALLBACKS_ABANDONED) == 1);
    assertFalse(server.hasFailed());
    games[1].hangs = true;
    server.awaitStop(); // the test's timeout would end it
    assertTrue(server.hasFailed());
  }

  @Test
  void aRoomWhoseSetUpHangsWhenItBeginsAgainEndsTheServer() throws Exception {
    ListAppender<ILoggingEvent> lines = new ListAppender<>();
    lines.start();
    Logger logger = (Logger) LoggerFactory.getLogger(HangingRooms.class);
    logger.addAppender(lines);
    try {
      start(true);
      synchronized (this) {
        setUpsHang = true;
      }
      games[0].hangs = true;
      server.awaitStop(); // the test's timeout would end it
      assertTrue(server.hasFailed());
      String second = lines.list.get(1).getFormattedMessage();
      assertTrue(
          second.startsWith("room hangs: its set-up hangs in setUp of " + TestGame.class.getName()),
          second);
    } finally {
      logger.detachAppender(lines);
    }
  }

  @Test
  void anOperatorWhoseMatchHangsInItsSetUpIsToldAndTheRoomGoesOn() throws Exception {
    start(false);
    Room room = server.rooms().get(0);
    synchronized (this) {
      setUpsHang = true;
    }
    int age = room.age();
    long beganNs = System.nanoTime();
    String answer = room.operator().change("test", "");
    double seconds = (System.nanoTime() - beganNs) * 1e-9;
    String where = "setUp of " + TestGame.class.getName();
    assertEquals("not changed: its set-up hangs in " + where, answer);
    assertEquals(1, room.counters().get(Counter.CALLBACKS_ABANDONED));
    assertTrue(room.age() - age > 20 * seconds, "ticks=" + (room.age() - age) + " in " + seconds);
    synchronized (this) {
      setUpsHang = false;
    }
    answer = room.operator().change("test", "");
    assertEquals("playing game=test level=test", answer);
    assertFalse(server.hasFailed());
  }

  @Test
  void anOperatorWhoWaitsForAMatchIsToldThatTheServerEnds() throws Exception {
    start(false);
    Room room = server.rooms().get(0);
    synchronized (this) {
      setUpsHang = true;
    }
    CompletableFuture<String> answer =
        CompletableFuture.supplyAsync(() -> room.operator().change("test", ""));
    await("the set-up hangs", () -> made() > 2);
    server.close();
    assertEquals("not changed: the server ends", answer.get(30, TimeUnit.SECONDS));
    assertEquals("not changed: the server ends", room.operator().change("test", ""));
  }
}

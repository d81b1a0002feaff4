package carom.client;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.link.ConnectionPhase;
import carom.client.view.ClientView;
import carom.net.frame.Frame;
import carom.net.kryo.KryoClientTransport;
import carom.net.kryo.server.KryoServerTransport;
import carom.net.protocol.GoodbyeReason;
import carom.net.protocol.PackedLevel;
import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.RefusalReason;
import carom.net.protocol.ServerMessage;
import carom.net.seal.Encryption;
import carom.physics.rows.BodyRow;
import carom.sim.level.Level;
import carom.suite.Needs;
import carom.text.Texts;
import java.io.DataOutputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Goal: a hostile server hurts no client: each attempt ends with a sentence for the player, or the
 * client goes on within its limits, and nothing is thrown. Method: the real client over sockets,
 * against servers that send bytes of their own, and against one that speaks the protocol and lies.
 */
@Needs("sockets")
@Timeout(180)
final class HostileServerTest {
  private static final long SEED = Long.getLong("carom.seed", System.nanoTime());
  private static final String EVIL = "\u001b]0;owned\u0007\u001b[2J\u202e\u009b31m\n\r";
  private static final int LONGEST_S = 60;
  private static final long MAX_GROWTH = 64 << 20;

  private final KryoClientTransport transport = new KryoClientTransport();
  private KryoServerTransport sockets;
  private ScriptedServer server;
  private GameClient client;

  @AfterEach
  void close() {
    if (client != null) {
      client.close();
    }
    if (sockets != null) {
      sockets.close();
    }
    transport.close();
  }

  /** What a server that speaks no protocol does with a connection. */
  private enum Raw {
    SILENT {
      @Override
      void talk(DataOutputStream out) {}
    },
    GARBAGE {
      @Override
      void talk(DataOutputStream out) throws IOException {
        byte[] bytes = new byte[1_000];
        for (Random random = new Random(SEED); ; out.write(bytes)) {
          random.nextBytes(bytes);
        }
      }
    },
    HUGE_LENGTH {
      @Override
      void talk(DataOutputStream out) throws IOException {
        out.writeInt(Integer.MAX_VALUE);
        endless(out, new byte[10_000], 0);
      }
    },
    NEGATIVE_LENGTH {
      @Override
      void talk(DataOutputStream out) throws IOException {
        out.writeInt(-1);
        endless(out, new byte[10_000], 0);
      }
    },
    EMPTY_FRAMES {
      @Override
      void talk(DataOutputStream out) throws IOException {
        endless(out, new byte[4], 0);
      }
    },
    HALF_A_FRAME {
      @Override
      void talk(DataOutputStream out) throws IOException {
        out.writeInt(1 + Frame.GREETING_BYTES);
        out.write(greeting(), 0, 20);
      }
    },
    A_FRAME_THAT_NEVER_ENDS {
      @Override
      void talk(DataOutputStream out) throws IOException {
        out.writeInt(16_000);
        endless(out, new byte[] {Frame.REGISTER_TCP}, 20);
      }
    },
    GREETINGS_WITHOUT_END {
      @Override
      void talk(DataOutputStream out) throws IOException {
        endless(out, frame(greeting()), 1);
      }
    },
    GREETING_AND_NOTHING {
      @Override
      void talk(DataOutputStream out) throws IOException {
        out.write(frame(greeting()));
      }
    },
    SIGNS_OF_LIFE_WITHOUT_END {
      @Override
      void talk(DataOutputStream out) throws IOException {
        out.write(frame(greeting()));
        endless(out, frame(new byte[] {Frame.KEEP_ALIVE}), 20);
      }
    },
    A_KEY_THAT_IS_NONE {
      @Override
      void talk(DataOutputStream out) throws IOException {
        out.write(frame(greeting()));
        out.write(frame(new byte[] {Frame.REGISTER_UDP}));
        byte[] answer = new byte[49];
        answer[0] = Frame.KEY_ANSWER;
        out.write(frame(answer));
      }
    },
    A_PROOF_THAT_IS_WRONG {
      @Override
      void talk(DataOutputStream out) throws IOException {
        out.write(frame(greeting()));
        out.write(frame(new byte[] {Frame.REGISTER_UDP}));
        byte[] answer = new byte[49];
        new Random(SEED).nextBytes(answer);
        answer[0] = Frame.KEY_ANSWER;
        out.write(frame(answer));
      }
    },
    MESSAGES_IN_THE_CLEAR {
      @Override
      void talk(DataOutputStream out) throws IOException {
        out.write(frame(greeting()));
        endless(out, frame(new byte[] {Frame.MESSAGE, 1, 2, 3, 4}), 1);
      }
    },
    MORE_WORK_THAN_THERE_IS {
      @Override
      void talk(DataOutputStream out) throws IOException {
        byte[] greeting = greeting();
        greeting[16] = (byte) 255;
        out.write(frame(greeting));
      }
    },
    A_GOODBYE_WITH_ESCAPES {
      @Override
      void talk(DataOutputStream out) throws IOException {
        byte[] text = EVIL.getBytes(StandardCharsets.UTF_8);
        byte[] bye = new byte[1 + text.length];
        bye[0] = Frame.BYE;
        System.arraycopy(text, 0, bye, 1, text.length);
        out.write(frame(bye));
      }
    };

    abstract void talk(DataOutputStream out) throws IOException;

    static byte[] greeting() {
      ByteBuffer bytes = ByteBuffer.allocate(1 + Frame.GREETING_BYTES);
      bytes.put(Frame.REGISTER_TCP).putInt(7).putLong(0x0123456789abcdefL).putShort((short) 9);
      bytes.put((byte) Encryption.ON.ordinal()).put((byte) 0);
      byte[] key = new byte[32];
      new Random(SEED).nextBytes(key);
      return bytes.put(key).array();
    }

    static byte[] frame(byte[] content) {
      return ByteBuffer.allocate(4 + content.length).putInt(content.length).put(content).array();
    }

    /** Repeats bytes until the client closes. */
    static void endless(DataOutputStream out, byte[] bytes, int pauseMs) throws IOException {
      try {
        while (true) {
          out.write(bytes);
          out.flush();
          Thread.sleep(pauseMs);
        }
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
    }
  }

  private void serve(ServerSocket socket, Raw raw) {
    Thread.currentThread().setName("hostile-" + raw);
    while (!socket.isClosed()) {
      try (Socket link = socket.accept()) {
        raw.talk(new DataOutputStream(link.getOutputStream()));
        while (link.getInputStream().read() >= 0) {
          // until the client has enough
        }
      } catch (IOException e) {
        // the client closed, as it should
      }
    }
  }

  private GameClient client(int tcpPort, int udpPort) {
    return client(transport, tcpPort, udpPort);
  }

  private static GameClient client(KryoClientTransport transport, int tcpPort, int udpPort) {
    return new GameClient(
        ClientConfig.of("tester")
            .withServer("127.0.0.1", tcpPort, udpPort)
            .with(ClientConfig.RECONNECT, false),
        transport,
        InputSource.IDLE);
  }

  private void await(BooleanSupplier condition, Object what) throws InterruptedException {
    long deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(LONGEST_S);
    while (!condition.getAsBoolean()) {
      assertTrue(
          System.nanoTime() < deadline,
          () -> what + ": " + client.view().phase() + ", " + client.view().message());
      turn();
      Thread.sleep(4);
    }
  }

  private void turn() {
    long now = System.nanoTime();
    if (server != null) {
      server.tick(now);
    }
    client.update(now);
  }

  private void play(double seconds) throws InterruptedException {
    long end = System.nanoTime() + (long) (seconds * 1e9);
    while (System.nanoTime() < end) {
      turn();
      Thread.sleep(8);
    }
  }

  private static void assertClean(String text) {
    assertEquals(Texts.clean(text), text);
  }

  private void assertEndsInWords(Object what) throws InterruptedException {
    await(() -> client.view().phase() == ConnectionPhase.ENDED, what);
    assertInWords("" + what, client.view().message());
  }

  private static void assertInWords(String what, String words) {
    assertFalse(words.isBlank(), what);
    assertClean(words);
    assertTrue(words.length() < 1_000, words);
  }

  /** All at once, since some attempts take as long as a client waits for a sign of life. */
  @Test
  void serversThatSpeakNoProtocolEndTheAttemptInWords() throws Exception {
    long before = usedBytes();
    List<AutoCloseable> opened = new ArrayList<>();
    Map<Raw, GameClient> clients = new EnumMap<>(Raw.class);
    try {
      for (Raw raw : Raw.values()) {
        ServerSocket socket = new ServerSocket(0, 50, InetAddress.getByName("127.0.0.1"));
        opened.add(socket);
        Thread thread = new Thread(() -> serve(socket, raw));
        thread.setDaemon(true);
        thread.start();
        KryoClientTransport own = new KryoClientTransport();
        opened.add(own);
        int port = socket.getLocalPort();
        clients.put(raw, client(own, port, port));
      }
      long deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(LONGEST_S);
      while (clients.values().stream().anyMatch(c -> c.view().phase() != ConnectionPhase.ENDED)) {
        long now = System.nanoTime();
        clients.forEach(
            (raw, c) ->
                assertTrue(now < deadline, () -> raw + " seed=" + SEED + ": " + c.view().phase()));
        clients.values().forEach(c -> c.update(now));
        Thread.sleep(4);
      }
      clients.forEach((raw, c) -> assertInWords(raw + " seed=" + SEED, c.view().message()));
      assertTrue(usedBytes() - before < MAX_GROWTH, "bytes more=" + (usedBytes() - before));
    } finally {
      clients.values().forEach(GameClient::close);
      for (AutoCloseable each : opened) {
        each.close();
      }
    }
  }

  private static long usedBytes() {
    System.gc();
    Runtime runtime = Runtime.getRuntime();
    return runtime.totalMemory() - runtime.freeMemory();
  }

  private void start(ScriptedServer.Script script) throws Exception {
    sockets = new KryoServerTransport(0, 0);
    server = new ScriptedServer(sockets, PredictionScenarioTest.arena());
    server.script = script;
    client = client(sockets.tcpPort(), sockets.udpPort());
  }

  private ScriptedServer.Guest startToPlay(ScriptedServer.Script script) throws Exception {
    start(script);
    await(() -> client.view().phase() == ConnectionPhase.PLAYING, "play");
    return server.guests.get(0);
  }

  private static ServerMessage.Welcome welcome(int levelSize, int packedSize, String name) {
    return new ServerMessage.Welcome(
        77,
        ScriptedServer.EPOCH,
        0,
        60,
        name,
        1,
        0,
        5,
        0,
        0,
        1,
        "arena",
        name + ".json",
        0,
        levelSize,
        packedSize,
        0,
        0,
        false,
        List.of());
  }

  /** A server that promises a level and sends bytes of its own. */
  private static ScriptedServer.Script level(int levelSize, byte[] packed, boolean onlyTheFirst) {
    return new ScriptedServer.Script() {
      @Override
      boolean hello(ScriptedServer.Guest guest) {
        guest.link.send(welcome(levelSize, packed.length, "bomb"));
        return false;
      }

      @Override
      void level(ScriptedServer.Guest guest, int offset) {
        int from = onlyTheFirst ? 0 : offset;
        int to = Math.min(packed.length, from + ProtocolLimits.MAX_LEVEL_CHUNK_BYTES);
        guest.link.send(new ServerMessage.LevelChunk(from, Arrays.copyOfRange(packed, from, to)));
      }
    };
  }

  @Test
  void aLevelThatUnpacksToMoreThanPromisedIsRefused() throws Exception {
    start(level(1_000, PackedLevel.pack(new byte[Level.MAX_BYTES]), false));
    assertEndsInWords("more than promised");
  }

  @Test
  void aLevelOfMillionsOfValuesIsRefused() throws Exception {
    long before = usedBytes();
    byte[] json = "[0,".repeat(Level.MAX_BYTES / 3 - 1).getBytes(StandardCharsets.UTF_8);
    start(level(json.length, PackedLevel.pack(json), false));
    assertEndsInWords("depth");
    assertTrue(usedBytes() - before < MAX_GROWTH);
  }

  @Test
  void aLevelThatNeverEndsIsGivenUp() throws Exception {
    byte[] noise = new byte[Level.MAX_BYTES / 4];
    new Random(SEED).nextBytes(noise);
    start(level(Level.MAX_BYTES, noise, true));
    assertEndsInWords("the same chunk again and again, seed=" + SEED);
  }

  @Test
  void aRefusalOfAnotherVersionWithEscapesIsReadWithoutThem() throws Exception {
    start(
        new ScriptedServer.Script() {
          @Override
          boolean hello(ScriptedServer.Guest guest) {
            guest.link.send(new ServerMessage.Refused(RefusalReason.PROTOCOL_VERSION, EVIL));
            return false;
          }
        });
    assertEndsInWords("refused");
    assertTrue(client.view().message().contains("owned"), client.view().message());
  }

  @Test
  void aServerThatSendsAroundInCirclesIsLeft() throws Exception {
    start(
        new ScriptedServer.Script() {
          @Override
          boolean hello(ScriptedServer.Guest guest) {
            String other = guest.server().guests.size() % 2 == 0 ? "127.0.0.1:" : "localhost:";
            int port = sockets.tcpPort();
            guest.link.send(new ServerMessage.Redirect(other + port, "", "", ""));
            return false;
          }
        });
    assertEndsInWords("circles");
    assertTrue(server.guests.size() <= 5, "guests=" + server.guests.size());
  }

  @Test
  void escapesInEveryTextOfAGameAreShownNowhere() throws Exception {
    ScriptedServer.Guest guest = startToPlay(new ScriptedServer.Script());
    guest.link.send(
        new ServerMessage.Roster(
            List.of(
                new ServerMessage.RosterEntry(
                    3, "Eve" + "\u202e", 0, 1, false, false, true, 1, 31))));
    guest.link.send(new ServerMessage.Notice("notice" + EVIL));
    guest.link.send(
        new ServerMessage.RoomList(
            0,
            List.of(
                new ServerMessage.RoomEntry(
                    "room" + EVIL,
                    "game" + EVIL,
                    "level" + EVIL,
                    "ph\u001b[2J",
                    1,
                    2,
                    0,
                    Map.of("k\u001b", "v" + EVIL)))));
    await(() -> !client.view().notices().isEmpty() && !client.view().rooms().isEmpty(), "texts");
    ClientView view = client.view();
    view.notices().forEach(notice -> assertClean(notice.text()));
    view.players().forEach(player -> assertClean(player.name()));
    for (ServerMessage.RoomEntry room : view.rooms()) {
      assertClean(room.name() + room.game() + room.level() + room.phase());
      room.metadata().forEach((key, value) -> assertClean(key + value));
    }
    guest.link.send(new ServerMessage.Goodbye(GoodbyeReason.KICKED, EVIL));
    assertEndsInWords("goodbye");
  }

  @Test
  void aFloodOfMessagesLeavesTheClientWithinItsMemory() throws Exception {
    ScriptedServer.Guest guest = startToPlay(new ScriptedServer.Script());
    long before = usedBytes();
    byte[] bytes = new byte[ProtocolLimits.MAX_GAME_MESSAGE_BYTES];
    for (int i = 0; i < 300 && client.view().phase() == ConnectionPhase.PLAYING; i++) {
      for (int k = 0; k < 20; k++) {
        guest.link.send(new ServerMessage.Notice("n" + i + "." + k + "x".repeat(400)));
        guest.link.send(new ServerMessage.GameMessage(i + 1, bytes));
        guest.link.send(new ServerMessage.PoolChunk(256 * 1_024, 0, new byte[4_000]));
        guest.link.send(
            new ServerMessage.Roster(
                List.of(
                    new ServerMessage.RosterEntry(
                        (i * 20 + k) % 1_024, "P" + k, 0, i, false, false, true, 1, 0))));
        guest.link.send(welcome(1_000, 900, "r" + k));
      }
      turn();
      Thread.sleep(1);
    }
    play(1);
    assertTrue(client.view().notices().size() <= 64, "" + client.view().notices().size());
    assertTrue(usedBytes() - before < MAX_GROWTH, "bytes more=" + (usedBytes() - before));
    assertClean(client.view().message());
  }

  /** Plays on snapshots whose bits behind the head are flipped, one in three. */
  @Test
  void snapshotsWithFlippedBitsAreCountedAndDrawnAsFiniteNumbers() throws Exception {
    Random random = new Random(SEED);
    startToPlay(
        new ScriptedServer.Script() {
          @Override
          void datagram(byte[] bytes, int length) {
            for (int i = 0; length > 4 && random.nextInt(3) == 0 && i < 4; i++) {
              bytes[3 + random.nextInt(length - 3)] ^= (byte) (1 << random.nextInt(8));
            }
          }
        });
    play(5);
    assertDrawsFiniteNumbers();
  }

  @Test
  void exactStatesThatAreNoNumbersOrOutOfTheWorldAreDrawnAsFiniteNumbers() throws Exception {
    int[] evil = {
      Float.floatToRawIntBits(Float.NaN),
      Float.floatToRawIntBits(Float.POSITIVE_INFINITY),
      Float.floatToRawIntBits(-Float.MAX_VALUE),
      Float.floatToRawIntBits(Float.MIN_VALUE),
      0xffffffff
    };
    Random random = new Random(SEED);
    startToPlay(
        new ScriptedServer.Script() {
          @Override
          void own(ScriptedServer.Guest guest) {
            if (guest.own.slot >= 0 && random.nextInt(3) == 0) {
              int at = random.nextInt(BodyRow.MOTION_INTS);
              guest.own.values[at] = evil[random.nextInt(evil.length)];
            }
          }
        });
    play(5);
    assertDrawsFiniteNumbers();
  }

  /** Plays on lists of near bodies that lack the own body, which each honest list has. */
  @Test
  void listsWithoutTheOwnBodyDespawnNothing() throws Exception {
    startToPlay(
        new ScriptedServer.Script() {
          @Override
          void own(ScriptedServer.Guest guest) {
            if (guest.own.near.present()) {
              guest.own.near.begin(0);
            }
          }
        });
    play(2);
    assertDrawsFiniteNumbers();
  }

  private void assertDrawsFiniteNumbers() {
    ClientView view = client.view();
    assertNotNull(view);
    for (int i = 0; i < view.entityCount(); i++) {
      ClientView.Drawn drawn = view.entity(i);
      float sum = drawn.x() + drawn.y() + drawn.angle() + drawn.velocityX() + drawn.velocityY();
      assertTrue(Float.isFinite(sum), "entity " + drawn.id() + ": " + sum + ", seed=" + SEED);
    }
    assertClean(view.message());
  }
}

package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.ClientConfig;
import carom.client.replay.RecordingDownload;
import carom.fixtures.PlainGame;
import carom.game.arena.ArenaGame;
import carom.net.kryo.KryoMessageCodec;
import carom.net.protocol.ClientMessage;
import carom.net.transport.ClientTransport;
import carom.net.transport.InProcessNetwork;
import carom.physics.Material;
import carom.physics.geometry.Circle;
import carom.replay.RecordingReader;
import carom.replay.Replay;
import carom.server.config.ServerConfig;
import carom.sim.Game;
import carom.sim.Match;
import carom.sim.SetUp;
import carom.sim.entity.Entity;
import carom.sim.entity.Player;
import carom.sim.event.Audience;
import carom.sim.event.EventKind;
import carom.sim.field.Count;
import carom.sim.field.Field;
import carom.sim.field.Scope;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import carom.sim.message.BuiltInKinds;
import carom.sim.message.MessageKind;
import carom.sim.message.MessageKind.Direction;
import carom.sim.message.MessageKinds;
import carom.suite.Needs;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * Goal: nothing that a team alone may know reaches spectators before the match is over. Method:
 * what they were sent, computed as they could, while the game goes on and after it.
 */
@Needs("sockets")
@Timeout(120)
final class SpectatorSecretsTest {
  private static final long SLICE_NS = 5_000_000;

  /** Ways in which a game can let a team alone know something. */
  private enum Way {
    NOTHING,
    FIELD,
    ENTITY,
    EVENT,
    MESSAGE,
    HEARD_CHAT
  }

  /** A game with something for a team alone, from two seconds on. */
  private static class SecretGame extends PlainGame {
    private static final Count PLAN =
        Field.count("plan", 0, 9).of(Scope.PLAYER).to(Audience.TEAM).startsAt(0);
    private static final MessageKind ORDER =
        MessageKind.named("order").fromServer().count("what", 0, 9);

    private final Way way;
    private EventKind whisper;
    volatile boolean ends;

    SecretGame(Way way) {
      super("secret");
      this.way = way;
    }

    @Override
    public void setUp(SetUp s) {
      s.archetype(new ArchetypeDef("ball").shape(new Circle(0.4f), new Material(1, 0, 1)));
      s.message(ORDER);
      whisper = s.event("whisper", 0xffffff, 0, "");
    }

    @Override
    public List<Field<?>> fields() {
      return way == Way.FIELD ? List.of(PLAN) : List.of();
    }

    @Override
    public void join(Match s, Player p) {
      s.team(p, 1);
      s.spawn(s.archetype("ball"), 0, 0, 0, p);
    }

    @Override
    public void beforeStep(Match m) {
      for (Player p : m.players()) {
        if (m.tick() % 60 == 0 && m.tick() > 120 && way == Way.EVENT) {
          m.emit(whisper).by(p).to(Audience.TEAM);
        } else if (m.tick() % 60 == 0 && m.tick() > 120 && way == Way.MESSAGE) {
          m.send(ORDER.of(7)).toTeam(1);
        }
      }
    }

    @Override
    public Audience audience(Match s, Entity e) {
      return way == Way.ENTITY && s.tick() > 120 ? Audience.TEAM : Audience.NEAR;
    }

    @Override
    public void afterStep(Match s) {
      if (ends) {
        ends = false;
        s.matchOver();
      }
    }
  }

  /** The same game that looks at what players say. */
  private static final class HearingGame extends SecretGame {
    HearingGame() {
      super(Way.HEARD_CHAT);
    }

    @Override
    public String chat(Match s, Player p, String text) {
      return text;
    }
  }

  @TempDir private Path folder;
  private final InProcessNetwork network = new InProcessNetwork(new KryoMessageCodec());
  private final ClientTransport transport = network.client();
  private final MessageKinds kinds = new MessageKinds();
  private FakeClient ann;
  private int said;
  private long nowNs = 1_000_000_000L;
  private Server server;
  private RecordingDownload spectator;

  private void start(Supplier<Game> game, Level level, Game known) throws Exception {
    server =
        new Server(
            ServerConfig.defaults().with(ServerConfig.STATUS_INTERVAL, 0),
            game,
            level,
            network.server(),
            () -> nowNs);
    server.allowSpectators(1);
    ann = new FakeClient(transport.connect("", 0, 0)).hello("Ann");
    ann.game = known;
    run(2);
    ann.link.send(new ClientMessage.Heard(0));
    run(0.1);
    spectator = new RecordingDownload(ClientConfig.of("s"), 1, transport, folder.resolve("seen"));
  }

  @AfterEach
  void close() {
    if (spectator != null) {
      spectator.close();
    }
    server.close();
  }

  private void say(boolean team, String text) {
    byte[] bytes = kinds.encode(BuiltInKinds.SAY.of(team, text), Direction.FROM_CLIENT);
    ann.link.send(new ClientMessage.GameMessage(++said, bytes));
  }

  private void run(double seconds) throws InterruptedException {
    for (long endNs = nowNs + (long) (seconds * 1e9); nowNs < endNs; nowNs += SLICE_NS) {
      server.tick(nowNs);
      ann.step(server.rooms().get(0).tick());
      if (spectator != null) {
        spectator.update(nowNs);
      }
    }
    Thread.sleep(30); // the file is written by a thread of its own, in real time
  }

  /** Returns everything that is said in what the spectator has, which must be computed equally. */
  private String said() throws IOException {
    StringBuilder said = new StringBuilder();
    try (RecordingReader reader = RecordingReader.open(folder.resolve("seen"))) {
      Replay replay = new Replay(reader);
      while (replay.step() == Replay.Progress.TICK) {
        replay
            .simulation()
            .outbox()
            .drainMessages(
                d -> {
                  if (d.message().is(BuiltInKinds.SAID)) {
                    said.append(d.message().text("text")).append('\n');
                  }
                });
      }
      assertNull(replay.divergence());
    }
    return said.toString();
  }

  @Test
  void spectatorsNeverGetALineToATeam() throws Exception {
    start(ArenaGame::new, Level.builtIn("arena"), null);
    run(1);
    say(true, "left at dawn");
    say(false, "hello all");
    for (int i = 0; i < 40 && (i < 10 || !said().contains("hello all")); i++) {
      run(0.5);
    }
    assertEquals("hello all\n", said());
  }

  private static Level level() throws Exception {
    String json =
        """
        {
          "name": "secret", "game": "secret", "gravity": [0, 0],
          "bounds": { "min": [-10, -10], "max": [10, 10] },
          "spawns": [ { "name": "player", "at": [0, 0] } ]
        }
        """;
    return Level.parse("secret", json.getBytes(StandardCharsets.UTF_8));
  }

  @ParameterizedTest
  @EnumSource
  void aMatchWithWhatATeamAloneMayKnowIsShownWhenItIsOver(Way way) throws Exception {
    List<SecretGame> games = new ArrayList<>();
    start(
        () -> {
          games.add(way == Way.HEARD_CHAT ? new HearingGame() : new SecretGame(way));
          return games.get(games.size() - 1);
        },
        level(),
        new SecretGame(way));
    run(1.5);
    say(true, "left at dawn");
    run(4);
    long early = spectator.received();
    run(4);
    long late = spectator.received();
    assertEquals(way == Way.NOTHING, late > early, way + ": " + early + " and then " + late);
    if (way == Way.FIELD) {
      assertEquals(0, early, "it is known from the start");
    }
    games.get(0).ends = true;
    for (int i = 0; i < 40 && spectator.received() <= late; i++) {
      run(0.5);
    }
    assertTrue(spectator.received() > late, "the match is over");
    assertTrue(Files.size(folder.resolve("seen")) >= spectator.received());
  }
}

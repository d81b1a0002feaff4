package carom.client;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.bots.Bot;
import carom.client.link.ConnectionPhase;
import carom.client.view.ClientView;
import carom.fixtures.Slice;
import carom.game.Games;
import carom.net.kryo.KryoMessageCodec;
import carom.net.snapshot.EntityHistory;
import carom.net.snapshot.frame.FrameState;
import carom.net.transport.ClientTransport;
import carom.net.transport.ImpairedClientTransport;
import carom.net.transport.Impairment;
import carom.net.transport.InProcessNetwork;
import carom.net.transport.Link;
import carom.server.Server;
import carom.server.config.ServerConfig;
import carom.sim.entity.HostEntity;
import carom.sim.level.Level;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/**
 * Goal: the real server and real clients, in good and bad networks. Method: virtual time, an
 * in-process network, bots that play; the oracle is the server's own frame states.
 */
final class ClientServerScenarioTest {
  private static final long STEP_NS = 1_000_000_000L / 240;
  private static final long SEED = Long.getLong("carom.seed", 42);

  private final InProcessNetwork network = new InProcessNetwork(new KryoMessageCodec());
  private final List<GameClient> clients = new ArrayList<>();
  private final List<Link> links = new ArrayList<>();
  private long now = 1_000_000L;
  private Server server;
  private long compared;

  private void serve(String game) throws Exception {
    Level level = Level.builtIn(game);
    server =
        new Server(
            ServerConfig.defaults()
                .with(ServerConfig.GAME, game)
                .with(ServerConfig.STATUS_INTERVAL, 0),
            () -> Games.create(game),
            level,
            network.server(),
            () -> now);
  }

  private GameClient join(Impairment impairment, InputSource input) {
    ClientTransport remember =
        new ClientTransport() {
          @Override
          public Link connect(String host, int tcpPort, int udpPort) {
            Link link = network.client().connect(host, tcpPort, udpPort);
            links.add(link);
            return link;
          }

          @Override
          public void close() {}
        };
    long seed = impairment.seed() + 1_000L * clients.size();
    GameClient client =
        new GameClient(
            ClientConfig.of("player" + clients.size()).withServer("memory", 0, 0),
            new ImpairedClientTransport(
                remember, impairment.withSeed(seed), new KryoMessageCodec(), () -> now),
            input,
            () -> 0);
    clients.add(client);
    return client;
  }

  private void run(double seconds) {
    long end = now + (long) (seconds * 1e9);
    while (now < end) {
      now += STEP_NS;
      server.tick(now);
      for (GameClient client : clients) {
        int before = client.decoder() == null ? -1 : client.decoder().newestTick();
        client.update(now);
        if (client.decoder() != null && client.decoder().newestTick() > before) {
          compareWithServer(client);
        }
      }
    }
  }

  /** Each state the client decoded for its newest tick is the server's, to the last quantum. */
  private void compareWithServer(GameClient client) {
    int tick = client.decoder().newestTick();
    FrameState truth = server.rooms().get(0).frames().at(tick);
    if (truth == null) {
      return;
    }
    for (int slot = 0; slot < client.decoder().slotLimit(); slot++) {
      EntityHistory h = client.decoder().history(slot);
      if (h == null || h.size() == 0 || h.tick(0) != tick) {
        continue;
      }
      String what = "slot " + slot + " at tick " + tick + ", seed " + SEED;
      assertEquals(truth.alive(slot), h.alive(0), what);
      if (h.alive(0)) {
        assertEquals(truth.x(slot), h.x(0), what);
        assertEquals(truth.y(slot), h.y(0), what);
        assertEquals(truth.angle(slot), h.angle(0), what);
        assertEquals(truth.still(slot), h.still(0), what);
        assertEquals(truth.archetype(slot), h.archetype(0), what);
        assertEquals(truth.ownership(slot), h.ownership(0), what);
        compared++;
      }
    }
  }

  @AfterEach
  void stop() {
    for (GameClient client : clients) {
      client.close();
    }
    if (server != null) {
      server.close();
    }
  }

  @Test
  void aPictureWithoutNumbersIsRefusedWhereItIsShown() throws Exception {
    serve("arena");
    GameClient client = join(Impairment.NONE, InputSource.IDLE);
    for (float[] wrong :
        new float[][] {
          {Float.NaN, 0, 8, 6},
          {0, Float.NEGATIVE_INFINITY, 8, 6},
          {0, 0, Float.NaN, 6},
          {0, 0, 8, -1},
          {0, 0, Float.POSITIVE_INFINITY, 6}
        }) {
      String message =
          assertThrows(
                  IllegalArgumentException.class,
                  () -> client.look(wrong[0], wrong[1], wrong[2], wrong[3]))
              .getMessage();
      assertTrue(message.contains("must be finite, with sizes of 0 or more"), message);
    }
    run(1);
    client.look(1, 2, 16, 9);
    run(1);
    assertEquals(ConnectionPhase.PLAYING, client.view().phase());
  }

  @Test
  void playersOfTheArenaAgreeWithTheServerInEveryNetwork() throws Exception {
    agree("arena");
  }

  @Test
  void playersOfThePlatformerAgreeWithTheServerInEveryNetwork() throws Exception {
    agree("platformer");
  }

  private void agree(String game) throws Exception {
    Impairment[] conditions = {
      Impairment.NONE,
      Impairment.NONE.withSeed(SEED).withLoss(10),
      Impairment.NONE.withSeed(SEED).withLatency(100, 50),
      Impairment.NONE.withSeed(SEED).withBursts(10, 5).withLatency(40, 10).withReorder(5, 5),
    };
    serve(game);
    for (int i = 0; i < conditions.length; i++) {
      join(conditions[i], new Bot(SEED + i));
    }
    run(20);
    for (int i = 0; i < conditions.length; i++) {
      GameClient client = clients.get(i);
      String what = game + " " + conditions[i] + " " + client.view().message();
      assertEquals(ConnectionPhase.PLAYING, client.view().phase(), what);
      assertEquals(0, client.stats().reconnects(), what);
      assertEquals(0, client.stats().malformed(), what);
      assertEquals(conditions.length, client.view().players().size(), what);
      for (int wait = 0; wait < 15 && client.view().own() == null; wait++) {
        run(0.1); // who fell is back a second later
      }
      assertNotNull(client.view().own(), what);
    }
    assertTrue(compared > 5_000, "compared " + compared);
  }

  @Test
  void theOwnBodyMovesAtOnceHoweverFarTheServer() throws Exception {
    serve("arena");
    boolean[] go = {false};
    GameClient client =
        join(Impairment.NONE.withLatency(150, 0), (view, tick, out) -> out.move(0, go[0] ? 1 : 0));
    run(3);
    float y = client.view().own().y();
    go[0] = true;
    run(0.1);
    float moved = client.view().own().y() - y;
    assertTrue(moved > 0.15, "moved " + moved + " m in 100 ms at 300 ms round trip");
    run(0.6);
    assertEquals(0, client.stats().corrections(), "and all of it was right");
  }

  @Test
  void whatIsDrawnNeverJumps() throws Exception {
    serve("arena");
    for (int i = 0; i < 6; i++) {
      join(Impairment.NONE.withSeed(SEED).withLatency(50, 8).withLoss(1), new Bot(SEED + i));
    }
    run(3);
    GameClient watched = clients.get(0);
    float[] x = new float[4_096];
    float[] y = new float[4_096];
    int[] seen = new int[4_096];
    int jumps = 0;
    int frames = 0;
    for (int frame = 2; frame < 60 * Slice.of(12, 20); frame++) {
      run(1 / 60.0);
      ClientView view = watched.view();
      for (int i = 0; i < view.entityCount(); i++) {
        ClientView.Drawn d = view.entity(i);
        int identity = d.id() << 3 | d.generation() & 7;
        if (seen[identity] == frame - 1) {
          double step = Math.hypot(d.x() - x[identity], d.y() - y[identity]);
          double speed = Math.hypot(d.velocityX(), d.velocityY());
          frames++;
          jumps += step > 0.25 + 2.5 * speed / 60 ? 1 : 0;
        }
        seen[identity] = frame;
        x[identity] = d.x();
        y[identity] = d.y();
      }
    }
    assertTrue(
        jumps * 1_000L < frames, jumps + " jumps in " + frames + " drawn poses, seed " + SEED);
  }

  @Test
  void comesBackToTheSameBody() throws Exception {
    serve("arena");
    GameClient client = join(Impairment.NONE.withLatency(20, 0), InputSource.IDLE);
    run(2);
    int id = client.view().own().id();
    int player = client.view().playerId();
    HostEntity body = server.rooms().get(0).simulation().player(player).entity();
    links.get(0).close("cable cut");
    run(0.1);
    assertEquals(ConnectionPhase.RECONNECTING, client.view().phase());
    run(2);
    assertEquals(ConnectionPhase.PLAYING, client.view().phase());
    assertEquals(player, client.view().playerId());
    assertEquals(id, client.view().own().id());
    assertEquals(body, server.rooms().get(0).simulation().player(player).entity());
    assertEquals(1, client.stats().reconnects());
  }

  @Test
  void aLateJoinerSeesEverybody() throws Exception {
    serve("arena");
    for (int i = 0; i < 5; i++) {
      join(Impairment.NONE, new Bot(i));
    }
    run(5);
    GameClient late = join(Impairment.NONE.withLatency(30, 0), InputSource.IDLE);
    run(1);
    assertEquals(6, late.view().players().size());
    for (int picture = 0; picture < 60; picture++) {
      run(1 / 60.0);
      eachPlayerHasOneBody(late);
    }
  }

  /** Requires of a picture that it has each player's body once; sparks belong to players, too. */
  private void eachPlayerHasOneBody(GameClient late) {
    for (int player = 0; player < 6; player++) {
      List<Integer> bodies = new ArrayList<>();
      for (int i = 0; i < late.view().entityCount(); i++) {
        ClientView.Drawn drawn = late.view().entity(i);
        boolean spark = drawn.archetype().name().equals("spark");
        if (drawn.ownerId() == player && !spark) {
          bodies.add(drawn.id());
        }
      }
      HostEntity body = server.rooms().get(0).simulation().player(player).entity();
      assertEquals(List.of(body.id()), bodies, "bodies of player " + player);
    }
  }
}

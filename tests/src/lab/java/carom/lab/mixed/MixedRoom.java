package carom.lab.mixed;

import carom.client.ClientConfig;
import carom.client.GameClient;
import carom.client.PredictionMode;
import carom.client.bots.Bot;
import carom.client.bots.PlainDoor;
import carom.client.bots.ThinFarm;
import carom.client.bots.ThinPicture;
import carom.client.bots.WebDoor;
import carom.client.link.ConnectionPhase;
import carom.client.view.ClientView;
import carom.game.Games;
import carom.lab.mixed.ServerStates.Pose;
import carom.net.kryo.KryoClientTransport;
import carom.net.kryo.server.KryoServerTransport;
import carom.net.transport.ClientTransport;
import carom.net.transport.ServerTransports;
import carom.server.Server;
import carom.server.config.ServerConfig;
import carom.server.thin.plain.PlainFlags;
import carom.server.thin.web.PlayFlags;
import carom.server.thin.web.PlayPort;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import java.io.IOException;
import java.net.InetAddress;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;

/**
 * A server with all its doors, and clients of each kind in its one room. They play, stand still for
 * a while, and play again. Four times a second what thin clients show is compared with the state of
 * the tick that they show; what own clients show is compared where a body has kept still for two
 * seconds. What is wrong for two seconds is a disagreement. One thread.
 */
public final class MixedRoom implements AutoCloseable {
  private static final long SECOND = 1_000_000_000L;
  private static final long PLAY_NS = 20 * SECOND;
  private static final long REST_NS = 8 * SECOND;
  private static final long CHECK_NS = SECOND / 4;
  private static final long WRONG_NS = 2 * SECOND;
  private static final int MOST_LINKS = 1_024;
  private static final float NEAR = 0.02f; // metres, radians

  private final ServerStates states = new ServerStates();
  private final Server server;
  private final ClientTransport sockets = new KryoClientTransport();
  private final List<GameClient> own = new ArrayList<>();
  private final Map<String, ThinFarm> thin = new HashMap<>();
  private final Map<String, Long> wrongSince = new HashMap<>();
  private final Set<String> wrong = new HashSet<>();
  private boolean rests;
  private long compared;
  private int disagreements;
  private int lost;
  private long firstHeap;
  private long lastHeap;

  /**
   * Opens the server and lets the clients in.
   *
   * @param each clients of each kind: own, plain by UDP, plain by TCP, JSON, binary
   * @param seed of what they do
   */
  public MixedRoom(int each, long seed) throws IOException, LevelException {
    ServerConfig config =
        ServerConfig.defaults()
            .with(ServerConfig.STATUS_INTERVAL, 0)
            .with(ServerConfig.PLAIN_PORT, "0:0")
            .with(ServerConfig.PLAY_PORT, 0);
    List<InetAddress> here = List.of(InetAddress.getLoopbackAddress());
    carom.server.thin.plain.PlainDoor plain = PlainFlags.open(config, here);
    PlayPort play = PlayFlags.open(config, here, MOST_LINKS, MOST_LINKS);
    server =
        new Server(
            config,
            () -> states.watch(Games.create("arena")),
            Level.builtIn("arena"),
            ServerTransports.of(new KryoServerTransport(0, 0), List.of(plain, play)),
            System::nanoTime);
    server.start();
    for (int i = 0; i < each; i++) {
      Bot bot = new Bot(seed + i);
      ClientConfig player =
          ClientConfig.of("own" + i)
              .withServer("127.0.0.1", server.tcpPort(), server.udpPort())
              .with(
                  ClientConfig.PREDICTION,
                  i % 2 == 0 ? PredictionMode.ISLAND : PredictionMode.NONE);
      own.add(
          new GameClient(
              player,
              sockets,
              (view, tick, out) -> {
                if (!rests) {
                  bot.sample(view, tick, out);
                }
              }));
    }
    String address = "ws://127.0.0.1:" + play.tcpPort() + "/thin";
    thin.put("web", new ThinFarm(WebDoor.opener(address, false), "web", "", each, seed));
    thin.put("binary", new ThinFarm(WebDoor.opener(address, true), "binary", "", each, seed));
    if (System.getProperty("carom.plain.path") != null) {
      for (int udp : new int[] {plain.udpPort(), 0}) {
        String name = udp == 0 ? "stream" : "plain";
        thin.put(
            name,
            new ThinFarm(
                PlainDoor.opener("127.0.0.1", plain.tcpPort(), udp), name, "", each, seed + udp));
      }
    }
  }

  /**
   * Plays.
   *
   * @param seconds how long, once all have joined
   * @param line told once a round how it goes
   * @return whether nobody disagreed and nobody was lost
   */
  public boolean run(double seconds, Consumer<String> line) throws InterruptedException {
    long beginNs = System.nanoTime();
    long endNs = 0;
    long turnNs = 0;
    long checkNs = 0;
    while (endNs == 0 || System.nanoTime() - endNs < 0) {
      long nowNs = System.nanoTime();
      own.forEach(client -> client.update(nowNs));
      thin.values().forEach(farm -> farm.update(nowNs));
      Thread.sleep(4);
      if (endNs == 0) {
        if (nowNs - beginNs > 60 * SECOND) {
          line.accept("not all have joined: " + report());
          return false;
        }
        if (allPlay()) {
          endNs = nowNs + (long) (seconds * SECOND);
          turnNs = nowNs + PLAY_NS;
        }
        continue;
      }
      if (nowNs - checkNs >= 0) {
        checkNs = nowNs + CHECK_NS;
        check(nowNs);
      }
      if (nowNs - turnNs >= 0) {
        rests ^= true;
        turnNs = nowNs + (rests ? REST_NS : PLAY_NS);
        thin.values().forEach(farm -> farm.rest(rests));
        if (!rests) {
          noteHeap();
          line.accept(report());
        }
      }
    }
    noteHeap();
    lost = (int) own.stream().filter(c -> c.view().phase() != ConnectionPhase.PLAYING).count();
    for (ThinFarm farm : thin.values()) {
      for (ThinPicture picture : farm.pictures()) {
        lost += picture.errors() + (picture.ended() == null ? 0 : 1);
      }
    }
    line.accept(report());
    return disagreements == 0 && lost == 0 && compared > 0;
  }

  private boolean allPlay() {
    return own.stream().allMatch(c -> c.view().phase() == ConnectionPhase.PLAYING)
        && thin.values().stream().allMatch(farm -> farm.playing() == farm.pictures().size());
  }

  private void noteHeap() {
    System.gc();
    lastHeap = Runtime.getRuntime().totalMemory() - Runtime.getRuntime().freeMemory();
    firstHeap = firstHeap == 0 ? lastHeap : firstHeap;
  }

  private void check(long nowNs) {
    wrong.clear();
    thin.forEach(
        (name, farm) -> {
          for (int i = 0; i < farm.pictures().size(); i++) {
            compare(name + i, farm.pictures().get(i));
          }
        });
    ServerStates.State newest = states.newest();
    for (GameClient client : own) {
      compare(client.view(), newest);
    }
    wrongSince.keySet().retainAll(wrong);
    for (String one : wrong) {
      long since = wrongSince.computeIfAbsent(one, x -> nowNs);
      if (nowNs - since >= WRONG_NS && nowNs - since < WRONG_NS + CHECK_NS) {
        disagreements++;
      }
    }
  }

  private void compare(String name, ThinPicture picture) {
    ThinPicture.Shown shown = picture.shown();
    ServerStates.State state = shown == null ? null : states.at(shown.tick());
    if (state == null) {
      wrong.add(name + " shows no tick of the last seconds");
      return;
    }
    Set<Integer> ids = new HashSet<>(shown.bodies().keySet());
    ids.addAll(state.bodies().keySet());
    for (int id : ids) {
      ThinPicture.Body body = shown.bodies().get(id);
      Pose pose = state.bodies().get(id);
      compared++;
      if (body == null || pose == null || !isNear(pose, body.x(), body.y(), body.angle())) {
        wrong.add(name + " body " + id);
      }
    }
  }

  private void compare(ClientView view, ServerStates.State newest) {
    int still = newest.tick() - 2 * view.tickRate();
    newest
        .bodies()
        .forEach(
            (id, pose) -> {
              if (pose.sinceTick() > still) {
                return;
              }
              compared++;
              ClientView.Drawn drawn = view.find(id);
              if (drawn == null || !isNear(pose, drawn.x(), drawn.y(), drawn.angle())) {
                wrong.add("own " + view.playerId() + " body " + id);
              }
            });
  }

  private static boolean isNear(Pose pose, float x, float y, float angle) {
    return Math.abs(pose.x() - x) < NEAR
        && Math.abs(pose.y() - y) < NEAR
        && Math.abs(Math.IEEEremainder(pose.angle() - angle, 2 * Math.PI)) < NEAR;
  }

  /** Returns how it goes, as one line of JSON. */
  public String report() {
    return String.format(
        Locale.ROOT,
        "{\"kinds\":%d,\"compared\":%d,\"disagreements\":%d,\"wrongNow\":%d,\"lost\":%d,"
            + "\"heapFirstMB\":%.1f,\"heapMB\":%.1f}",
        1 + thin.size(),
        compared,
        disagreements,
        wrong.size(),
        lost,
        firstHeap / 1e6,
        lastHeap / 1e6);
  }

  /** Returns what is wrong at the last look, for people. */
  public Set<String> wrong() {
    return Set.copyOf(wrong);
  }

  @Override
  public void close() {
    thin.values().forEach(ThinFarm::close);
    own.forEach(GameClient::close);
    sockets.close();
    server.close();
  }
}

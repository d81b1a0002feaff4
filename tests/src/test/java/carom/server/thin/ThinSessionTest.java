package carom.server.thin;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.FieldGame;
import carom.fixtures.PlainGame;
import carom.net.codec.Quantizer;
import carom.net.protocol.ServerMessage;
import carom.net.transport.Link;
import carom.physics.Material;
import carom.physics.geometry.Circle;
import carom.physics.math.Trig;
import carom.server.Server;
import carom.server.config.RoomConfig;
import carom.server.config.ServerConfig;
import carom.server.match.HandedInMatch;
import carom.server.room.FleetDoor;
import carom.server.room.RoomOffer;
import carom.server.room.RoomSearch;
import carom.server.session.Ownership;
import carom.sim.Game;
import carom.sim.Match;
import carom.sim.SetUp;
import carom.sim.Simulation;
import carom.sim.SimulationHost;
import carom.sim.entity.Entity;
import carom.sim.entity.HostEntity;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import carom.sim.message.Message;
import carom.sim.message.MessageKind;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/**
 * Goal: a thin client is a player like any other, and what it shows is what there is. Method: a
 * server in virtual time, and clients that only draw what they are told, over lines that lose
 * snapshots or take none for a while.
 */
final class ThinSessionTest {
  private static final long TICK_NS = 16_666_667;

  private final ThinDoor door = new ThinDoor();
  private Server server;
  private long nowNs = 1_000_000_000L;

  /** A game of balls that come, go, jump and stop at random, and that notes where they were. */
  private static final class Balls extends PlainGame {
    static final MessageKind PING =
        MessageKind.named("ping").fromClient().count("n", 0, 9).text("word", 20);
    static final MessageKind PONG =
        MessageKind.named("pong").fromServer().count("n", 0, 9).text("word", 20);

    private static final Material MATERIAL = new Material(1, 0.3f, 0.5f);

    final Map<Integer, Map<Integer, ThinDoor.Client.Shown>> poses = new HashMap<>();
    final ArrayDeque<Integer> jumps = new ArrayDeque<>();
    Random random;
    Archetype ball;
    Archetype box;
    SimulationHost simulation;
    int busyUntil;
    Runnable stepping = () -> {};

    Balls(long seed, int busyTicks) {
      super("thinballs");
      random = new Random(seed);
      busyUntil = busyTicks;
    }

    static Level level() throws Exception {
      return Level.parse(
          "thinballs.json",
          ("{\"name\": \"thinballs\", \"game\": \"thinballs\", \"gravity\": [0, 0],"
                  + " \"bounds\": {\"min\": [-50, -50], \"max\": [50, 50]},"
                  + " \"statics\": [{\"at\": [0, -20],"
                  + " \"shape\": {\"type\": \"box\", \"width\": 60, \"height\": 2}}]}")
              .getBytes(StandardCharsets.UTF_8));
    }

    @Override
    public void setUp(SetUp s) {
      ball = s.archetype(new ArchetypeDef("ball").shape(new Circle(0.4f), MATERIAL));
      box = s.archetype(new ArchetypeDef("other").shape(new Circle(0.6f), MATERIAL));
      s.message(PING);
      s.message(PONG);
    }

    @Override
    public void begin(Match s) {
      simulation = (SimulationHost) s;
    }

    @Override
    public void join(Match s, Player p) {
      s.spawn(ball, p.id() * 3, 0, 0, p);
    }

    @Override
    public void input(Simulation s, Player p, Input in) {
      p.entity().setVelocity(in.moveX() * 5, in.moveY() * 5);
      if (in.held(Input.JUMP)) {
        jumps.add(s.tick());
      }
    }

    @Override
    public void message(Match s, Player p, Message m) {
      if (m.is(PING)) {
        s.send(PONG.of(m.count("n"), m.text("word"))).to(p);
      }
    }

    @Override
    public void beforeStep(Match s) {
      stepping.run();
      if (s.tick() >= busyUntil) {
        for (Entity e : s.entities()) {
          if (!e.isOwned()) {
            e.setVelocity(0, 0);
            e.setAngularVelocity(0);
          }
        }
        return;
      }
      if (random.nextInt(8) == 0) {
        Archetype kind = random.nextBoolean() ? ball : box;
        Entity e =
            s.spawn(kind, random.nextFloat() * 80 - 40, random.nextFloat() * 40 - 15, 0, null);
        e.setVelocity(random.nextFloat() * 8 - 4, random.nextFloat() * 8 - 4);
        e.setAngularVelocity(random.nextFloat() * 6 - 3);
      }
      int id = random.nextInt(Math.max(1, ((SimulationHost) s).entityCapacity()));
      Entity e = s.entity(id);
      if (e != null && !e.isOwned()) {
        switch (random.nextInt(12)) {
          case 0 -> e.despawn();
          case 1 -> e.setVelocity(0, 0);
          case 2 -> e.become(e.archetype() == ball ? box : ball);
          default -> {}
        }
      }
    }

    @Override
    public void afterStep(Match s) {
      Map<Integer, ThinDoor.Client.Shown> now = new HashMap<>();
      for (Entity e : s.entities()) {
        if (e != null) {
          now.put(
              e.id(),
              new ThinDoor.Client.Shown(
                  Quantizer.position(e.x()),
                  Quantizer.position(e.y()),
                  Quantizer.angle(Trig.atan2(e.sin(), e.cos())),
                  e.archetype().index(),
                  ((HostEntity) e).ownerId()));
        }
      }
      poses.put(s.tick(), now);
    }
  }

  private void serve(Game game, Level level) {
    serve(ServerConfig.defaults(), game, level);
  }

  private void serve(ServerConfig config, Game game, Level level) {
    server =
        new Server(
            config.with(ServerConfig.STATUS_INTERVAL, 0), () -> game, level, door, () -> nowNs);
  }

  private void steps(int count) {
    for (int i = 0; i < count; i++) {
      nowNs += TICK_NS;
      server.tick(nowNs);
    }
  }

  private ThinDoor.Client join(String name) {
    ThinDoor.Client client = door.join(name, true, 0, 1);
    steps(20);
    assertNotNull(client.match, () -> name + " heard " + client.heard);
    return client;
  }

  @AfterEach
  void stop() {
    if (server != null) {
      server.close();
    }
  }

  @Test
  void joinsPlaysAndLeaves() throws Exception {
    Balls game = new Balls(1, 0);
    serve(game, Balls.level());
    ThinDoor.Client ann = join("Ann");
    assertEquals(60, ann.welcome.tickRate());
    assertEquals("thinballs", ann.match.game());
    assertEquals(1, ann.match.ground().size());
    assertEquals(4, ann.match.ground().get(0).kind().parts().get(0).corners().size() / 2);
    assertEquals("Ann", ann.players.get(ann.match.player()).name());
    int body = game.simulation.player(ann.match.player()).entity().id();
    int before = ann.bodies.get(body).x();
    ann.press(new Input().move(1, 0).pack());
    steps(60);
    assertEquals(
        5 * ThinSnapshot.STEPS_PER_METRE, ann.bodies.get(body).x() - before, 300, "5 m/s for 1 s");
    assertEquals(1, ann.input);
    assertEquals(30, ann.snapshots, 8, "30 a second");
    ann.say(new ThinClientMessage.Leave());
    steps(90);
    assertNotNull(ann.ended);
    assertEquals(0, server.rooms().get(0).seats().takenCount());
  }

  @Test
  void anotherVersionIsRefusedByName() throws Exception {
    serve(new Balls(1, 0), Balls.level());
    ThinDoor.Client old = new ThinDoor.Client(true, 0, 1);
    old.say(new ThinClientMessage.Join(7, "Ann", "", "", "", "", "", 0, ""));
    door.enter(old);
    steps(5);
    ThinServerMessage.Refused refused = old.last(ThinServerMessage.Refused.class);
    assertEquals("PROTOCOL_VERSION", refused.reason());
    assertTrue(refused.text().contains("7") && refused.text().contains("1"), refused.text());
  }

  @Test
  void aPressBetweenTwoTicksIsntLost() throws Exception {
    Balls game = new Balls(1, 0);
    serve(game, Balls.level());
    ThinDoor.Client ann = join("Ann");
    ann.press(new Input().hold(Input.JUMP, true).pack());
    ann.press(new Input().pack());
    steps(10);
    assertEquals(1, game.jumps.size(), "pressed and released within one tick");
    ann.press(new Input().hold(Input.JUMP, true).pack());
    steps(10);
    assertEquals(11, game.jumps.size(), "held until something else comes");
  }

  @Test
  void aLostLinkTakesItsSeatAgain() throws Exception {
    Balls game = new Balls(1, 0);
    serve(game, Balls.level());
    ThinDoor.Client ann = join("Ann");
    int player = ann.match.player();
    ann.press(new Input().move(1, 0).pack());
    steps(10);
    ann.breakOff();
    steps(30);
    ThinDoor.Client again = new ThinDoor.Client(true, 0, 2);
    again.say(ThinDoor.joining("Ann", ann.welcome.secret()));
    door.enter(again);
    steps(20);
    assertEquals(player, again.match.player());
    assertEquals(1, server.rooms().get(0).seats().takenCount());
    assertFalse(again.bodies.isEmpty());
  }

  @Test
  void chatEmotesRolesAndMessagesOfTheGameGoBothWays() throws Exception {
    serve(new Balls(1, 0), Balls.level());
    ThinDoor.Client ann = join("Ann");
    ThinDoor.Client bob = join("Bob");
    ann.say(new ThinClientMessage.Chat("hello", false));
    ann.say(new ThinClientMessage.Emote("WOW"));
    steps(5);
    assertEquals(
        new ThinServerMessage.Chat(ann.match.player(), "hello", false),
        bob.last(ThinServerMessage.Chat.class));
    assertEquals(
        new ThinServerMessage.Emote(ann.match.player(), "WOW"),
        bob.last(ThinServerMessage.Emote.class));
    bob.say(new ThinClientMessage.Custom("ping", Map.of("n", 3, "word", "ok")));
    bob.say(new ThinClientMessage.Custom("ping", Map.of("n", 33, "word", "out of range")));
    bob.say(new ThinClientMessage.Custom("pong", Map.of("n", 1, "word", "not from clients")));
    bob.say(new ThinClientMessage.Custom("nothing"));
    bob.say(new ThinClientMessage.Emote("nothing"));
    steps(30);
    assertEquals(
        new ThinServerMessage.Custom("pong", Map.of("n", 3, "word", "ok")),
        bob.last(ThinServerMessage.Custom.class));
    bob.say(new ThinClientMessage.Choose(null, "SPECTATOR", null, "RED", null));
    steps(80);
    assertTrue(ann.players.get(bob.match.player()).spectator());
    assertEquals(0xff5d5d, ann.players.get(bob.match.player()).rgb());
  }

  /** A fleet that has a fuller room elsewhere, to which no thin client can go. */
  private static final class FullerElsewhere implements FleetDoor {
    @Override
    public Place find(String room, Link.Door door) {
      return door == Link.Door.OWN
          ? new Place(2, room, new RoomOffer("thinballs", 40, 64, null))
          : null;
    }

    @Override
    public Place best(RoomSearch search, Link.Door door) {
      return find("9", door);
    }

    @Override
    public void look(List<Looker> lookers) {}

    @Override
    public List<Looker> lookersElsewhere() {
      return List.of();
    }

    @Override
    public String roomOfParty(String party, Link.Door door) {
      return null;
    }

    @Override
    public Future<String> settle(String party, String room) {
      throw new AssertionError("a thin client can't follow " + party);
    }

    @Override
    public int roomsOf(String account) {
      return 0;
    }

    @Override
    public Future<Boolean> seats(String account) {
      return CompletableFuture.completedFuture(true);
    }

    @Override
    public Future<Boolean> spend(String token, long seconds, boolean wasRead) {
      return CompletableFuture.completedFuture(true);
    }

    @Override
    public boolean mayComeBack(String room) {
      return false;
    }

    @Override
    public boolean follows(String room, long secret) {
      return false;
    }

    @Override
    public void standsBy(String room, long secret) {
      throw new AssertionError("a thin client can't stand by for " + room);
    }

    @Override
    public Future<ServerMessage> move(Place to, Guest guest, Link.Door door) {
      throw new AssertionError("a thin client can't follow " + to);
    }

    @Override
    public Future<Guest> redeem(String ticket) {
      return CompletableFuture.completedFuture(null);
    }

    @Override
    public List<ServerMessage.RoomEntry> roomsElsewhere(Link.Door door) {
      return door == Link.Door.OWN
          ? List.of(new ServerMessage.RoomEntry("9", "thinballs", "l", "", 40, 64, 0, Map.of()))
          : List.of();
    }
  }

  @Test
  void inAFleetAThinClientPlaysWhileItsRoomIsOwned() throws Exception {
    AtomicBoolean lease = new AtomicBoolean(true);
    Ownership owned = Ownership.under(lease::get);
    owned.claim(7);
    Balls game = new Balls(5, 10_000);
    Level level = Balls.level();
    ServerConfig config = ServerConfig.defaults().with(ServerConfig.STATUS_INTERVAL, 0);
    server =
        new Server(
            config,
            RoomConfig.equalRooms(config, List.of(level.name())),
            new HandedInMatch(() -> game, level),
            door,
            () -> nowNs,
            room -> owned);
    server.fleet(new FullerElsewhere());
    ThinDoor.Client ann = join("Ann");
    steps(60);
    int played = ann.snapshots;
    assertTrue(played > 20, () -> "snapshots=" + ann.snapshots);
    ann.say(new ThinClientMessage.ListRooms());
    steps(40);
    List<String> rooms =
        ann.heard.stream()
            .filter(ThinServerMessage.Rooms.class::isInstance)
            .flatMap(message -> ((ThinServerMessage.Rooms) message).rooms().stream())
            .map(ThinServerMessage.Room::name)
            .toList();
    assertEquals(List.of("1"), rooms, "none to which it can't go");
    int jumps = game.jumps.size();
    ann.press(Input.JUMP);
    steps(3);
    assertTrue(game.jumps.size() > jumps, "it plays, and doesn't only watch");
    lease.set(false);
    int shown = ann.snapshots;
    int heard = ann.heard.size();
    steps(60);
    assertEquals(shown, ann.snapshots);
    assertEquals(heard, ann.heard.size(), "perhaps the room goes on elsewhere");
    lease.set(true);
    steps(60);
    assertTrue(ann.snapshots > shown + 20);
  }

  @Test
  void theBestAreToldOnRequestAndNotBeforeTheMatch() throws Exception {
    Balls game = new Balls(5, 10_000);
    serve(ServerConfig.defaults(), game, Balls.level());
    ThinDoor.Client early = new ThinDoor.Client(true, 0, 1);
    door.enter(early);
    early.say(new ThinClientMessage.ListBest());
    ThinDoor.Client ann = join("Ann");
    for (int i = 0; i < 10; i++) {
      ann.say(new ThinClientMessage.ListBest());
    }
    steps(90);
    List<ThinServerMessage> told =
        ann.heard.stream().filter(ThinServerMessage.Best.class::isInstance).toList();
    assertTrue(!told.isEmpty() && told.size() <= 4, "asked ten times, told=" + told.size());
    assertEquals(new ThinServerMessage.Best(List.of()), told.get(0), "without accounts");
    assertEquals(List.of(), early.heard);
  }

  @Test
  void theMemoryOfRulesIsForClientsThatPredict() throws Exception {
    Balls game = new Balls(5, 0);
    Level level =
        Level.parse(
            "thinballs.json",
            new String(Balls.level().source(), StandardCharsets.UTF_8)
                .replaceFirst(
                    "\\{",
                    "{\"triggers\": [{\"when\": {\"timer\": 0.1}, \"every\": 0.2,"
                        + " \"do\": {\"notice\": \"again\"}}],")
                .getBytes(StandardCharsets.UTF_8));
    serve(game, level);
    ThinDoor.Client ann = join("Ann");
    steps(60);
    assertTrue(game.simulation.hasRules());
    assertEquals(Map.of(), ann.fields);
  }

  @Test
  void fieldsReachThoseWhoMayKnowThem() {
    serve(new FieldGame(), FieldGame.level(true));
    ThinDoor.Client ann = join("Ann");
    ThinDoor.Client bob = join("Bob");
    steps(130);
    int a = ann.match.player();
    int b = bob.match.player();
    assertEquals("400", ann.fields.get("player" + a + ".ammo"), "the owner's");
    assertEquals(null, bob.fields.get("player" + a + ".ammo"));
    assertNotNull(ann.fields.get("player" + a + ".plan"), "the team's");
    assertEquals(null, ann.fields.get("player" + b + ".plan"), "another team's");
    assertEquals(
        ann.fields.get("player" + b + ".health"), bob.fields.get("player" + b + ".health"));
    assertFalse(ann.fields.keySet().stream().anyMatch(name -> name.endsWith(".luck")));
    assertTrue(List.of("WAIT", "PLAY").contains(ann.fields.get("match0.phase")));
    String phase = (String) ann.fields.get("match0.phase");
    steps(FieldGame.PHASE_TICKS);
    assertNotEquals(phase, ann.fields.get("match0.phase"));
  }

  @Test
  void whatIsShownIsWhatThereIs() throws Exception {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    for (int round = 0; round < 12; round++) {
      Random random = new Random(seed + round);
      boolean stream = round % 3 == 0;
      double loss = stream ? 0 : random.nextDouble() * 0.6;
      compare(seed + round, random, stream, loss);
    }
  }

  private void compare(long seed, Random random, boolean stream, double loss) throws Exception {
    Balls game = new Balls(seed, 400);
    // Ticks that take long let some snapshots wait that were prepared.
    game.stepping = () -> nowNs += game.random.nextInt(3) == 0 ? 14_000_000 : 0;
    serve(game, Balls.level());
    List<ThinDoor.Client> clients = new ArrayList<>();
    for (int i = 0; i < 3; i++) {
      clients.add(door.join("P" + i, stream, loss, seed + i));
    }
    for (int tick = 0; tick < 400; tick++) {
      steps(1);
      for (ThinDoor.Client c : clients) {
        c.busy = random.nextInt(10) == 0 || c.busy && random.nextInt(10) != 0;
        if (random.nextInt(3) == 0) {
          c.press(new Input().move(random.nextFloat() * 2 - 1, 0).pack());
        }
        if (random.nextInt(20) == 0) {
          c.pressLate(1_000 + random.nextInt(10_000));
        }
        if (random.nextInt(60) == 0) {
          c.say(new ThinClientMessage.Rate(random.nextInt(80)));
        }
        if (stream && c.tick > 0 && !c.bodies.isEmpty()) {
          assertEquals(game.poses.get(c.tick), c.bodies, "seed=" + seed + " tick=" + c.tick);
        }
      }
    }
    for (ThinDoor.Client c : clients) {
      c.busy = false;
      c.say(new ThinClientMessage.Rate(30));
    }
    for (int i = 0; i < 120; i++) {
      steps(1);
      clients.forEach(c -> c.press(0L));
    }
    for (ThinDoor.Client c : clients) {
      assertEquals(
          game.poses.get(c.tick),
          c.bodies,
          () -> "seed=" + seed + " loss=" + loss + " tick=" + c.tick);
    }
    server.close();
  }
}

package carom.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.PlainGame;
import carom.game.Games;
import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Material;
import carom.physics.Queries;
import carom.physics.QueryHit;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Polygon;
import carom.physics.geometry.Shape;
import carom.physics.math.Transform;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/**
 * Goal: a query of the past sees the bodies of that tick. Method: bodies that fly, spin, come and
 * go; the oracle is a world built anew with every body where it was at that tick.
 */
final class LookingBackTest {
  private static final long SEED = Long.getLong("carom.seed", 42);

  /** The last one's centre of mass is far from its origin. */
  private static final Shape[] SHAPES = {
    new Circle(0.5f), new Box(2, 0.4f), new Box(1, 1), Polygon.of(0.5f, 0.5f, 3, 0.5f, 0.5f, 2)
  };

  /** Poses that went through the centre of mass are rounded once more. */
  private static final float EPS = 1e-4f;

  /** Things without a purpose. */
  private static final class Things extends PlainGame {
    private final Archetype[] kinds = new Archetype[SHAPES.length];
    private boolean looksBack = true;

    Things() {
      super("things", "arena");
    }

    @Override
    public WorldDef world(Level level) {
      return new WorldDef().withGravity(0, 0);
    }

    @Override
    public boolean looksBack() {
      return looksBack;
    }

    @Override
    public void setUp(SetUp s) {
      for (int i = 0; i < SHAPES.length; i++) {
        kinds[i] = s.archetype(new ArchetypeDef("thing" + i).shape(SHAPES[i], SKIN));
      }
    }
  }

  private static final Material SKIN = new Material(1, 0.3f, 0.2f);

  private record Was(int id, int generation, int kind, float x, float y, float cos, float sin) {}

  private final Random random = new Random(SEED);
  private final Things game = new Things();
  private final SimulationHost s = start(game);
  private final HostPlayer player = s.join("ann");
  private final List<List<Was>> past = new ArrayList<>();

  private static SimulationHost start(Game game) {
    try {
      String json =
          "{\"name\":\"x\",\"game\":\"things\",\"gravity\":[0,0],"
              + "\"bounds\":{\"min\":[-50,-50],\"max\":[50,50]},\"statics\":[{\"at\":[0,-12],"
              + "\"shape\":{\"type\":\"box\",\"width\":30,\"height\":1}}]}";
      Level level = Level.parse("x.json", json.getBytes(StandardCharsets.UTF_8));
      return new SimulationHost(game, level, 1, 60, Role.AUTHORITY);
    } catch (LevelException e) {
      throw new IllegalStateException(e);
    }
  }

  private float between(float low, float high) {
    return low + random.nextFloat() * (high - low);
  }

  private void addThing() {
    HostEntity e =
        s.spawn(
            game.kinds[random.nextInt(SHAPES.length)], between(-12, 12), between(-10, 10), 0, null);
    e.body().setVelocity(between(-20, 20), between(-20, 20));
    e.body().setAngularVelocity(between(-20, 20));
  }

  /** A tick in which things may come, go, and jump elsewhere; remembers where they are then. */
  private void tick() {
    s.step();
    List<Was> now = new ArrayList<>();
    for (int id = 0; id < s.entityCapacity(); id++) {
      HostEntity e = s.entity(id);
      if (e != null) {
        Body<HostEntity> b = e.body();
        now.add(new Was(id, e.generation(), e.archetype().index(), b.x(), b.y(), b.cos(), b.sin()));
      }
    }
    past.add(now);
    for (int id = 0; id < s.entityCapacity(); id++) {
      HostEntity e = s.entity(id);
      if (e != null && random.nextInt(200) == 0) {
        s.despawn(e);
        addThing();
      } else if (e != null && random.nextInt(200) == 0) {
        e.body().setPose(between(-12, 12), between(-10, 10), 0);
      }
    }
  }

  /** What was there then and still exists, in a world of its own, at rest. */
  private World<Was> oracle(int tick) {
    World<Was> world = new World<>(new WorldDef());
    for (Was was : past.get(tick - 1)) {
      HostEntity e = s.entity(was.id());
      if (e != null && e.generation() == was.generation()) {
        Body<Was> body =
            world.createBody(
                new BodyDef(BodyType.STATIC).shape(s.archetypes().get(was.kind()).shapes().get(0)),
                was);
        body.setPose(was.x(), was.y(), was.cos(), was.sin());
      }
    }
    world.createBody(new BodyDef(BodyType.STATIC).position(0, -12).shape(new Box(15, 0.5f)), null);
    return world;
  }

  @Test
  void raysOverlapsAndDistancesAreThoseOfTheTickThatWasSeen() {
    for (int i = 0; i < 40; i++) {
      addThing();
    }
    int hits = 0;
    for (int round = 0; round < 150; round++) {
      tick();
      if (s.tick() < 20) {
        continue;
      }
      int ago = random.nextInt(16);
      player.viewDelay(ago * HostPlayer.VIEW_STEPS);
      Queries<HostEntity> then = s.pastQueries(player);
      World<Was> world = oracle(s.tick() - ago);
      String what = "seed=" + SEED + " tick=" + s.tick() + " ago=" + ago;
      for (int n = 0; n < 8; n++) {
        float x = between(-14, 14);
        float y = between(-11, 11);
        float dx = between(-15, 15);
        float dy = between(-15, 15);
        QueryHit<HostEntity> hit = new QueryHit<>();
        QueryHit<Was> truth = new QueryHit<>();
        boolean any = world.queries().rayClosest(x, y, dx, dy, null, truth);
        assertEquals(any, then.rayClosest(x, y, dx, dy, null, hit), what);
        assertEquals(any, then.rayAny(x, y, dx, dy, null), what);
        if (any) {
          hits++;
          assertEquals(truth.fraction(), hit.fraction(), EPS, what);
          assertEquals(idOf(truth), hit.body().user().id(), what);
        }
        List<Integer> ids = new ArrayList<>();
        List<Integer> trueIds = new ArrayList<>();
        Transform at = new Transform();
        at.set(x, y, 1, 0);
        then.overlaps(SHAPES[1], at, null, h -> ids.add(h.body().user().id()));
        world.queries().overlaps(SHAPES[1], at, null, h -> trueIds.add(idOf(h)));
        ids.sort(null);
        trueIds.sort(null);
        assertEquals(trueIds, ids, what);
        boolean near = world.queries().nearest(x, y, 3, null, truth);
        assertEquals(near, then.nearest(x, y, 3, null, hit), what);
        if (near) {
          assertEquals(truth.distance(), hit.distance(), EPS, what);
        }
      }
    }
    assertTrue(hits > 200, "hits=" + hits);
  }

  private static int idOf(QueryHit<Was> hit) {
    return hit.body().user() == null ? HostEntity.LEVEL : hit.body().user().id();
  }

  @Test
  void betweenTwoTicksBodiesAreBetweenTwoPlaces() {
    HostEntity e = s.spawn(game.kinds[0], 0, 0, 0, null);
    e.body().setVelocity(6, 0); // 0.1 m a tick
    for (int i = 0; i < 20; i++) {
      s.step();
    }
    for (int delay = 0; delay < 15 * HostPlayer.VIEW_STEPS; delay++) {
      player.viewDelay(delay);
      QueryHit<HostEntity> hit = new QueryHit<>();
      assertTrue(s.pastQueries(player).rayClosest(-5, 0, 10, 0, null, hit));
      float centre = 2 - 0.1f * delay / HostPlayer.VIEW_STEPS;
      assertEquals(centre - 0.5f, hit.x(), 1e-4, "delay=" + delay);
    }
    player.viewDelay(HostPlayer.MAX_VIEW_DELAY);
    QueryHit<HostEntity> hit = new QueryHit<>();
    assertTrue(s.pastQueries(player).rayClosest(-5, 0, 10, 0, null, hit));
    assertEquals(0.5f - 0.5f, hit.x(), 1e-4, "not farther back than a quarter of a second");
  }

  @Test
  void whoCameSinceIsNotThereAndWhoJumpedIsWhereItWas() {
    HostEntity e = s.spawn(game.kinds[0], 5, 0, 0, null);
    for (int i = 0; i < 20; i++) {
      s.step();
    }
    HostEntity young = s.spawn(game.kinds[0], -5, 0, 0, null);
    e.body().setPose(5, 8, 0);
    for (int i = 0; i < 3; i++) {
      s.step();
    }
    player.viewDelay(10 * HostPlayer.VIEW_STEPS);
    assertFalse(s.pastQueries(player).rayAny(-5, 3, 0, -3, null), "not yet there");
    assertTrue(s.pastQueries(player).rayAny(5, 3, 0, -3, null));
    assertFalse(s.pastQueries(player).rayAny(5, 10, 0, -3, null));
    player.viewDelay(0);
    assertTrue(s.pastQueries(player).rayAny(-5, 3, 0, -3, null));
    assertFalse(s.pastQueries(player).rayAny(5, 3, 0, -3, null));
    assertTrue(s.pastQueries(player).rayAny(5, 10, 0, -3, null));
    assertTrue(young.body().x() == -5);
  }

  @Test
  void thePastIsSavedAndRestored() {
    for (int i = 0; i < 30; i++) {
      addThing();
    }
    for (int i = 0; i < 40; i++) {
      tick();
    }
    player.viewDelay(12 * HostPlayer.VIEW_STEPS + 3);
    SimState state = s.save(null);
    List<Float> before = scan();
    for (int i = 0; i < 25; i++) {
      tick();
    }
    s.restore(state);
    assertEquals(before, scan());
  }

  private List<Float> scan() {
    List<Float> seen = new ArrayList<>();
    QueryHit<HostEntity> hit = new QueryHit<>();
    for (int i = 0; i < 200; i++) {
      boolean any = s.pastQueries(player).rayClosest(-14, -10 + 0.1f * i, 28, 0, null, hit);
      seen.add(any ? hit.fraction() : -1f);
    }
    return seen;
  }

  @Test
  void whoNeverLooksBackPaysNothingAndIsTold() {
    Things other = new Things();
    other.looksBack = false;
    SimulationHost forgetful = start(other);
    HostPlayer p = forgetful.join("ben");
    assertTrue(
        assertThrows(IllegalStateException.class, () -> forgetful.asSeenBy(p))
            .getMessage()
            .contains("looksBack"));
  }

  @Test
  void aPredictionAnswersWithWhatItPredicts() throws Exception {
    SimulationHost client =
        new SimulationHost(Games.create("arena"), Level.builtIn("arena"), 1, 60, Role.PREDICTION);
    HostPlayer p = client.mirror().join(3, "me");
    p.viewDelay(100);
    assertSame(client.world().queries(), client.pastQueries(p));
  }
}

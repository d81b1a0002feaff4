package carom.server.room;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.bots.Bot;
import carom.fixtures.PlainGame;
import carom.net.transport.Impairment;
import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Material;
import carom.physics.ShapeDef;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Shape;
import carom.physics.particles.Particles;
import carom.server.config.ServerConfig;
import carom.server.metrics.TurnStage;
import carom.sim.Role;
import carom.sim.SetUp;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.level.Appearance;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import carom.sim.pool.Pools;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** Goal: a picture shows the room as it is, and only when it is asked for. */
final class RoomPicturesTest {
  private static final Picture.Request ALL = new Picture.Request(true, true, true, Set.of(0, 77));
  private static final Picture.Request BODIES = new Picture.Request(false, false, false, Set.of());

  private static Picture take(Stepper stepper, Picture.Request request) {
    stepper.room().pictures().ask(request);
    stepper.run(0.1);
    return stepper.room().pictures().poll();
  }

  @Test
  void nobodyAsksAndThereIsNone() {
    try (Stepper stepper = Stepper.of("arena")) {
      stepper.run(1);
      assertNull(stepper.room().pictures().poll());
      assertEquals(0, stepper.room().stages().totalNs(TurnStage.PICTURE));
    }
  }

  @Test
  void bodiesJointsContactsCellsAndPlayersAreThoseOfTheWorld() {
    try (Stepper stepper = Stepper.of("arena")) {
      SimulatedClient ann = stepper.join("Ann", Impairment.NONE, new Bot(Stepper.SEED));
      stepper.run(3);
      stepper.room().pictures().ask(ALL);
      int tick = stepper.room().tick();
      while (stepper.room().tick() == tick) {
        stepper.step();
      }
      Picture picture = stepper.room().pictures().poll();
      assertNotNull(picture);
      assertNull(stepper.room().pictures().poll());
      var world = stepper.room().simulation().world();
      assertEquals(stepper.room().tick(), picture.tick());
      assertEquals(world.bodyCount(), picture.bodies().size());
      for (int i = 0; i < picture.bodies().size(); i++) {
        Body<HostEntity> body = world.body(picture.bodies().get(i).slot());
        assertEquals(body.user().id(), picture.bodies().get(i).entity());
        assertEquals(body.x(), picture.poses()[Picture.POSE * i]);
        assertEquals(body.y(), picture.poses()[Picture.POSE * i + 1]);
        assertEquals(body.awake(), picture.awake()[i]);
      }
      assertEquals(world.jointCount(), picture.joints().length / Picture.JOINT);
      assertTrue(picture.cells().length > 0);
      int[] points = {0};
      world.forEachContact((x, y, nx, ny, separation, impulse) -> points[0]++);
      assertEquals(points[0], picture.contacts().length / Picture.CONTACT);
      assertEquals(Set.of(0), picture.priorities().keySet());
      assertEquals(1, picture.players().size());
      Picture.Player player = picture.players().get(0);
      assertEquals("Ann", player.info().name());
      assertTrue(player.link().bytesSent() > 0);
      assertTrue(player.link().acked() > 0);
      assertTrue(player.link().acked() <= player.link().settled());
      assertEquals(0, picture.playerBodies()[0]);
      assertEquals(stepper.body(ann).body().index(), picture.playerBodies()[1]);
    }
  }

  @Test
  void aBodyThatChangesItsShapeHasAnotherLook() {
    World<HostEntity> world = new World<>(new WorldDef());
    Body<HostEntity> body =
        world.createBody(new BodyDef(BodyType.DYNAMIC).shape(new Circle(0.5f)), null);
    BodyLook before = BodyLook.of(body);
    assertTrue(before.isOf(body));
    body.replaceShape(0, new ShapeDef(new Box(0.3f, 0.3f)));
    assertFalse(before.isOf(body));
    BodyLook after = BodyLook.of(body);
    assertTrue(after.isOf(body));
    body.addShape(new ShapeDef(new Circle(1)));
    assertFalse(after.isOf(body));
  }

  @Test
  void anEntityThatBecomesAnotherOfTheSameShapeHasAnotherLook() throws Exception {
    // Goal: colour and kind follow the archetype, though shape and type are the same objects.
    Shape disc = new Circle(0.5f);
    Archetype[] kinds = new Archetype[2];
    PlainGame game =
        new PlainGame("looks", "arena") {
          @Override
          public void setUp(SetUp s) {
            kinds[0] = s.archetype(plain("snow", disc, 0xffffff));
            kinds[1] = s.archetype(plain("mud", disc, 0x554433));
          }
        };
    SimulationHost s = new SimulationHost(game, Level.builtIn("arena"), 1, 60, Role.AUTHORITY);
    HostEntity e = s.spawn(kinds[0], 0, 0, 0, null);
    BodyLook before = BodyLook.of(e.body());
    assertTrue(before.isOf(e.body()));
    e.become(kinds[1]);
    assertFalse(before.isOf(e.body()));
    BodyLook after = BodyLook.of(e.body());
    assertTrue(after.isOf(e.body()));
    assertEquals("mud", after.kind());
    assertEquals(0x554433, after.rgb());
  }

  private static ArchetypeDef plain(String name, Shape shape, int rgb) {
    return new ArchetypeDef(name)
        .shape(shape, Material.DEFAULT)
        .appearance(Appearance.of(rgb, Appearance.Look.PLAIN));
  }

  @Test
  void waterIsInThePictureWhereItIs() throws Exception {
    try (Stepper stepper = Stepper.of(Level.builtIn("sluice"), ServerConfig.defaults())) {
      stepper.join("Ann", Impairment.NONE, new Bot(Stepper.SEED));
      stepper.run(1);
      stepper.room().pictures().ask(BODIES);
      int tick = stepper.room().tick();
      while (stepper.room().tick() == tick) {
        stepper.step();
      }
      List<Picture.Pool> pictures = stepper.room().pictures().poll().particles();
      Pools pools = stepper.room().simulation().pools();
      assertEquals(2, pools.count());
      assertEquals(2, pictures.size());
      for (int pool = 0; pool < 2; pool++) {
        Particles particles = pools.get(pool).particles();
        Picture.Pool picture = pictures.get(pool);
        assertTrue(particles.count() > 50, "pool=" + pool + " particles=" + particles.count());
        assertEquals(2 * particles.count(), picture.xy().length);
        for (int i = 0; i < particles.count(); i++) {
          assertEquals(particles.x(i), picture.xy()[2 * i]);
          assertEquals(particles.y(i), picture.xy()[2 * i + 1]);
        }
        assertEquals(pools.get(pool).def().rgb(), picture.rgb());
        assertEquals(particles.spacing(), picture.spacing());
      }
    }
  }

  @Test
  void aBodyKeepsItsLookAndLossIsSeen() {
    try (Stepper stepper = Stepper.of("arena")) {
      stepper.join("Ann", Impairment.NONE.withLoss(20), new Bot(Stepper.SEED));
      Picture one = take(stepper, BODIES);
      Picture two = take(stepper, BODIES);
      assertTrue(two.tick() > one.tick());
      for (int i = 0; i < one.bodies().size(); i++) {
        assertSame(one.bodies().get(i), two.bodies().get(i));
      }
      assertNull(two.players());
      assertEquals(0, two.cells().length + two.contacts().length);
      Picture.Player before = take(stepper, ALL).players().get(0);
      stepper.run(20);
      Picture.Player after = take(stepper, ALL).players().get(0);
      double settled = after.link().settled() - before.link().settled();
      double loss = 1 - (after.link().acked() - before.link().acked()) / settled;
      assertEquals(0.2, loss, 0.05, "settled=" + settled);
    }
  }
}

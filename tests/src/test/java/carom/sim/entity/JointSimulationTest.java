package carom.sim.entity;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.MachineGame;
import carom.physics.Joint;
import carom.physics.JointDef;
import carom.physics.archive.ArchiveReader;
import carom.physics.archive.ArchiveWriter;
import carom.physics.math.SimRandom;
import carom.sim.Role;
import carom.sim.SimState;
import carom.sim.SimulationHost;
import carom.sim.near.JointDefinitions;
import carom.sim.near.Neighbourhood;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Joints and assemblies as things of a simulation. */
final class JointSimulationTest {
  private final MachineGame game = new MachineGame();
  private final SimulationHost s =
      new SimulationHost(game, MachineGame.level(""), 1, 60, Role.AUTHORITY);

  private static void run(SimulationHost s, int ticks) {
    for (int i = 0; i < ticks; i++) {
      s.step();
    }
  }

  @Test
  void anAssemblyHasOneOwnerNamedPartsAndNamedJoints() {
    HostPlayer ann = s.join("Ann");
    HostEntity chassis = ann.entity();
    HostEntity rear = chassis.part("rear");
    assertEquals("chassis", chassis.archetype().name());
    assertEquals(ann.id(), rear.ownerId());
    assertSame(chassis, rear.root());
    assertSame(chassis, rear.part("chassis"));
    EntityJoint drive = rear.joint("drive");
    assertSame(rear, drive.b());
    assertTrue(drive.isDriven());
    assertFalse(chassis.joint("roll").isDriven());
    String message =
        assertThrows(IllegalArgumentException.class, () -> chassis.joint("gears")).getMessage();
    assertTrue(message.contains("gears") && message.contains("[drive, roll]"), message);
  }

  @Test
  void anAssemblyDrivesIsTeleportedRigidlyAndDespawnedWhole() {
    HostPlayer ann = s.join("Ann");
    ann.input().move(1, 0);
    run(s, 240);
    assertTrue(ann.entity().body().x() > -20, "x=" + ann.entity().body().x());
    ann.input().move(0, 0);
    EntityJoint drive = ann.entity().joint("drive");
    float gap = gap(EntityJoint.engineOf(drive));
    ann.entity().teleport(5, 9, 2.5f);
    assertEquals(gap, gap(EntityJoint.engineOf(drive)), 1e-5f);
    assertTrue(ann.entity().part("rear").body().y() > 7);
    assertEquals(1, ann.entity().part("rear").teleports());
    run(s, 30);
    assertTrue(gap(EntityJoint.engineOf(drive)) < 0.45f, "gap=" + gap(EntityJoint.engineOf(drive)));
    int before = s.entityCount();
    s.despawn(ann.entity());
    assertEquals(before - 3, s.entityCount());
    assertEquals(0, s.world().jointCount());
  }

  private static float gap(Joint<HostEntity> j) {
    return (float) Math.hypot(j.anchorAX() - j.anchorBX(), j.anchorAY() - j.anchorBY());
  }

  @Test
  void gearsAndPulleysOfAnAssemblyGoWhereItIsSpawnedAndTeleported() {
    HostEntity frame = (HostEntity) game.gears(s, 4, 12, 1);
    EntityJoint rope = frame.joint("rope");
    float length = rope.coordinate();
    assertEquals(2.3f + 2.8f, length, 1e-4f);
    assertEquals(
        4 + Math.cos(1) * -2.5 - Math.sin(1) * 4, EntityJoint.engineOf(rope).groundAX(), 1e-4f);
    assertEquals(0, frame.joint("gear").coordinate(), 1e-5f);
    run(s, 60);
    HostEntity small = frame.part("small");
    HostEntity large = frame.part("large");
    assertTrue(Math.abs(small.body().angularVelocity()) > 1, "the motor drives it");
    assertEquals(
        -0.5f, large.body().angularVelocity() / small.body().angularVelocity(), 0.01f, "in gear");
    assertEquals(length, frame.joint("rope").coordinate(), 0.02f);
    float turning = large.body().angularVelocity();
    final float lower = frame.joint("rope").lengthA();
    frame.teleport(-6, 9, -2.2f);
    assertFalse(rope.isValid(), "it is made anew");
    assertEquals(0, frame.joint("gear").coordinate(), 1e-4f);
    assertEquals(lower, frame.joint("rope").lengthA(), 1e-4f);
    s.step();
    assertEquals(turning, large.body().angularVelocity(), 0.3f, "no jerk");
    run(s, 60);
    assertEquals(
        -0.5f, large.body().angularVelocity() / small.body().angularVelocity(), 0.01f, "in gear");
    int before = s.world().jointCount();
    s.despawn(frame);
    assertEquals(before - 4, s.world().jointCount());
  }

  @Test
  void aMemberThatGoesTakesItsJointsAlong() {
    HostPlayer ann = s.join("Ann");
    s.despawn(ann.entity().part("rear"));
    assertNull(ann.entity().part("rear"));
    assertNull(ann.entity().joint("drive"));
    assertNotNull(ann.entity().joint("roll"));
    run(s, 10);
  }

  @Test
  void jointsComeBackWithASavedStateAndWithItsBytes() {
    HostPlayer ann = s.join("Ann");
    game.ragdoll(s, 0, 0.2f);
    Entity[] bridge = game.bridge(s, 0, 6, 8, 1e9f);
    ann.input().move(1, 0);
    run(s, 60);
    SimState saved = s.save(null);
    ArchiveWriter bytes = new ArchiveWriter();
    saved.write(bytes);
    List<Long> hashes = hashes(s, 120);
    bridge[3].despawn();
    ann.entity().joint("roll").destroy();
    run(s, 5);
    s.restore(saved);
    assertEquals(hashes, hashes(s, 120), "restored");
    SimulationHost other =
        new SimulationHost(new MachineGame(), MachineGame.level(""), 1, 60, Role.AUTHORITY);
    other.restore(other.read(new ArchiveReader(bytes.toBytes())));
    assertEquals(hashes, hashes(other, 120), "from bytes");
    assertNotNull(other.player(ann.id()).entity().joint("roll"));
    assertEquals(s.joints().key(0), other.joints().key(0));
  }

  private static List<Long> hashes(SimulationHost s, int ticks) {
    List<Long> hashes = new ArrayList<>();
    for (int i = 0; i < ticks; i++) {
      s.step();
      hashes.add(s.stateHash());
    }
    return hashes;
  }

  @Test
  void aBrokenJointIsToldAndGone() {
    game.bridge(s, 0, 6, 8, 150);
    for (int i = 0; i < 4; i++) {
      game.crate(s, -1 + 0.6f * i, 9 + 1.2f * i);
    }
    int before = s.world().jointCount();
    List<String> told = new ArrayList<>();
    for (int i = 0; i < 240; i++) {
      s.step();
      s.outbox().drainEvents(e -> told.add(e.kind().name()));
    }
    assertTrue(s.world().jointCount() < before, "joints=" + s.world().jointCount());
    assertEquals(before - s.world().jointCount(), told.stream().filter("snap"::equals).count());
  }

  @Test
  void onlyTheServerMakesJoints() {
    SimulationHost client =
        new SimulationHost(new MachineGame(), MachineGame.level(""), 1, 60, Role.PREDICTION);
    SimulationHost server = s;
    HostPlayer ann = server.join("Ann");
    Neighbourhood near = new Neighbourhood();
    near.readAll(server);
    near.write(client, identity(server));
    HostEntity chassis = client.entity(ann.entity().id());
    JointDef<HostEntity> def = JointDef.revolute(null, chassis.body(), 0, 0);
    int before = client.world().jointCount();
    assertEquals(2, before);
    assertThrows(IllegalStateException.class, () -> client.connect(def));
    String message =
        assertThrows(IllegalStateException.class, () -> client.world().createJoint(def))
            .getMessage();
    assertTrue(message.contains("only the server makes joints"), message);
    assertEquals(before, client.world().jointCount());
  }

  static Neighbourhood.Identity identity(SimulationHost server) {
    return new Neighbourhood.Identity() {
      @Override
      public JointDefinitions joints() {
        return JointDefinitions.of(server.joints());
      }

      @Override
      public int owner(int key) {
        return server.entity(Neighbourhood.id(key)).ownerId();
      }
    };
  }

  /** A client takes all of a world of machines over again and again, with changed settings. */
  @Test
  void whoTakesMachinesOverGoesOnAlikeAndAlsoBreaksJointsAlike() {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    SimRandom random = new SimRandom(seed);
    SimulationHost client =
        new SimulationHost(new MachineGame(), MachineGame.level(""), 1, 60, Role.PREDICTION);
    HostPlayer ann = s.join("Ann");
    HostPlayer bob = s.join("Bob");
    game.ragdoll(s, 3, 1);
    game.ragdoll(s, -3, 1);
    game.bridge(s, 0, 5, 8, 220);
    HostEntity gears = (HostEntity) game.gears(s, 16, 0.4f, 0);
    Neighbourhood there = new Neighbourhood();
    Neighbourhood here = new Neighbourhood();
    int joints = s.world().jointCount();
    int compared = 0;
    boolean mirrored = false;
    for (int tick = 1; tick <= 1_500; tick++) {
      if (random.nextInt(20) == 0) {
        ann.input().move(random.between(-1, 1), 0);
        bob.input().move(random.between(-1, 1), 0);
      }
      if (tick % 300 == 100) {
        game.crate(s, random.between(-4, 4), 12);
        mirrored = false;
      }
      if (tick == 700) {
        gears.teleport(10, 3, 0.5f);
        mirrored = false;
      }
      if (mirrored) {
        for (HostPlayer p : List.of(ann, bob)) {
          client.player(p.id()).input().set(p.input());
          assertEquals(p.entity().id(), client.player(p.id()).entity().id());
        }
        client.step();
      }
      s.step();
      there.readAll(s);
      if (mirrored) {
        here.readAll(client);
        String where = "seed=" + seed + " tick=" + tick;
        assertEquals(s.world().jointCount(), client.world().jointCount(), where);
        assertEquals(there.hash(), here.hash(), where);
        compared++;
      }
      if (!mirrored || random.nextInt(100) == 0) {
        client.mirror().tick(s.tick());
        there.write(client, identity(s));
        mirrored = true;
      }
    }
    assertTrue(compared > 1_400, "compared=" + compared);
    assertTrue(s.world().jointCount() < joints, "some broke, seed=" + seed);
  }

  /** The first test: equal hashes for 600 ticks, whenever a machine is taken over. */
  @ParameterizedTest
  @ValueSource(strings = {"car", "ragdoll", "bridge", "gears", "all"})
  void aMachineThatIsTakenOverAtAnyMomentGoesOnAlikeForTenSeconds(String machine) {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    SimRandom random = new SimRandom(seed);
    for (int run = 0; run < 4; run++) {
      MachineGame machines = new MachineGame();
      SimulationHost server =
          new SimulationHost(machines, MachineGame.level(""), 1, 60, Role.AUTHORITY);
      SimulationHost client =
          new SimulationHost(new MachineGame(), MachineGame.level(""), 1, 60, Role.PREDICTION);
      boolean all = machine.equals("all");
      HostPlayer ann = all || machine.equals("car") ? server.join("Ann") : null;
      if (all || machine.equals("ragdoll")) {
        machines.ragdoll(server, random.between(-20, 20), 4);
      }
      if (all || machine.equals("bridge")) {
        machines.bridge(server, 0, 6, 9, 1e9f);
        machines.crate(server, random.between(-3, 3), 9);
      }
      if (all || machine.equals("gears")) {
        machines.gears(server, random.between(-20, 20), 2, random.between(-3, 3));
      }
      int at = random.nextInt(500);
      Neighbourhood there = new Neighbourhood();
      Neighbourhood here = new Neighbourhood();
      for (int tick = 0; tick < at + 600; tick++) {
        if (ann != null && random.nextInt(20) == 0) {
          ann.input().move(random.between(-1, 1), 0).hold(Input.JUMP, random.nextInt(3) == 0);
        }
        server.step();
        there.readAll(server);
        if (tick > at) {
          if (ann != null) {
            client.player(ann.id()).input().set(ann.input());
          }
          client.step();
          here.readAll(client);
          String where = machine + " seed=" + seed + " run=" + run + " at=" + at + " tick=" + tick;
          assertEquals(server.world().jointCount(), client.world().jointCount(), where);
          assertEquals(there.hash(), here.hash(), where);
        } else if (tick == at) {
          client.mirror().tick(server.tick());
          there.write(client, identity(server));
        }
      }
    }
  }

  @Test
  void anAssemblyIsRefusedWithWhatIsWrong() {
    AssemblyDef def = new AssemblyDef("cart");
    assertThrows(IllegalArgumentException.class, () -> def.joint("axle", "a", "b", (a, b) -> null));
    Assemblies fresh = new Assemblies(new carom.sim.level.Archetypes());
    String message =
        assertThrows(IllegalArgumentException.class, () -> fresh.add(def)).getMessage();
    assertTrue(message.contains("assembly=cart"), message);
  }
}

package carom.lab.pool;

import carom.client.ClientConfig;
import carom.client.PredictionMode;
import carom.client.bots.Bot;
import carom.client.view.ClientView;
import carom.game.Games;
import carom.net.transport.Impairment;
import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.ShapeDef;
import carom.physics.World;
import carom.physics.archive.ArchiveWriter;
import carom.physics.geometry.Box;
import carom.physics.math.Aabb;
import carom.physics.math.Transform;
import carom.physics.particles.Emitter;
import carom.physics.particles.ParticleDef;
import carom.physics.particles.Particles;
import carom.server.config.ServerConfig;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.level.Archetype;
import carom.sim.level.Level;
import carom.sim.pool.Pool;
import carom.sim.pool.PoolDef;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.zip.Deflater;

/**
 * Compares ways to bring water and sand to clients, on the level {@code sluice} with two bots at
 * 150 ms round trip and 2 % loss, for a minute of virtual time:
 *
 * <ul>
 *   <li>lockstep: what ships;
 *   <li>free: each client runs the particles from the same start and spouts, and pushes them out of
 *       the bodies that it shows;
 *   <li>surface: the server sends for each column of 0.5 m where the particles' highest surface is,
 *       in steps of 2 cm, 10 times a second, as differences, deflated with what was sent before.
 * </ul>
 *
 * <p>It prints bytes, CPU time, and how far apart two clients' pictures are.
 */
public final class PoolChoice {
  private static final float COLUMN = 0.5f;

  private PoolChoice() {}

  /** A client's particles that are pushed by what the client shows. */
  private static final class Free {
    final SimulatedClient client;
    final World<Void> world;
    final List<Particles> particles = new ArrayList<>();
    final List<Body<Void>> bodies = new ArrayList<>();
    long nanos;
    int tick;

    Free(SimulatedClient client, SimulationHost of) {
      this.client = client;
      world = new World<>(of.game().world(of.level()));
      for (Level.Placement p : of.level().statics()) {
        world.createBody(of.archetypes().get(p.archetype()).body(p.x(), p.y(), p.angle()), null);
      }
      for (PoolDef def : of.level().pools()) {
        Particles some =
            new Particles(
                new ParticleDef(def.kind(), def.spacing())
                    .density(def.density())
                    .twoWay(false)
                    .substeps(def.kind() == ParticleDef.Kind.WATER ? 2 : 3)
                    .maxCount(def.most()));
        for (PoolDef.Rectangle f : def.fills()) {
          some.fill(
              new Box(0.5f * (f.maxX() - f.minX()), 0.5f * (f.maxY() - f.minY())),
              new Transform(0.5f * (f.minX() + f.maxX()), 0.5f * (f.minY() + f.maxY()), 0),
              0,
              0);
        }
        particles.add(some);
      }
    }

    void step(SimulationHost of) {
      for (Body<Void> b : bodies) {
        world.destroyBody(b);
      }
      bodies.clear();
      for (int i = 0; i < client.view().entityCount(); i++) {
        ClientView.Drawn e = client.view().entity(i);
        Archetype kind = e.archetype();
        if (kind.sensor()) {
          continue;
        }
        BodyDef def =
            new BodyDef().type(BodyType.KINEMATIC).position(e.x(), e.y()).angle(e.angle());
        for (int k = 0; k < kind.shapes().size(); k++) {
          def.shape(new ShapeDef(kind.shapes().get(k), kind.materials().get(k)));
        }
        Body<Void> body = world.createBody(def, null);
        body.setVelocity(e.velocityX(), e.velocityY());
        body.setAngularVelocity(e.angularVelocity());
        bodies.add(body);
      }
      long begin = System.nanoTime();
      tick++;
      for (int i = 0; i < particles.size(); i++) {
        PoolDef def = of.level().pools().get(i);
        for (PoolDef.Spout s : def.spouts()) {
          new Emitter(s.x(), s.y(), s.dirX(), s.dirY())
              .width(s.width())
              .speed(s.speed())
              .emit(particles.get(i), tick, of.tickSeconds());
        }
        particles.get(i).step(world, of.tickSeconds());
        Aabb box = new Aabb();
        for (PoolDef.Rectangle d : def.drains()) {
          box.set(d.minX(), d.minY(), d.maxX(), d.maxY());
          particles.get(i).removeInside(box);
        }
        box.set(def.box().minX(), def.box().minY(), def.box().maxX(), def.box().maxY());
        particles.get(i).removeOutside(box);
      }
      nanos += System.nanoTime() - begin;
    }
  }

  private static float[] surface(PoolDef def, Particles p) {
    float left = def.box().minX();
    float[] top = new float[1 + (int) ((def.box().maxX() - left) / COLUMN)];
    Arrays.fill(top, def.box().minY());
    for (int i = 0; i < p.count(); i++) {
      int c = (int) ((p.x(i) - left) / COLUMN);
      if (p.velocityX(i) * p.velocityX(i) + p.velocityY(i) * p.velocityY(i) < 9) {
        top[c] = Math.max(top[c], p.y(i)); // what falls or flies is no surface
      }
    }
    return top;
  }

  private static double apart(float[] a, float[] b) {
    double sum = 0;
    for (int i = 0; i < a.length; i++) {
      sum += (a[i] - b[i]) * (a[i] - b[i]);
    }
    return Math.sqrt(sum / a.length);
  }

  /** Measures; the first argument is the time in seconds, 60 without it. */
  public static void main(String[] args) throws Exception {
    Impairment far = Impairment.NONE.withLatency(75, 0).withLoss(2).withSeed(42);
    int seconds = args.length > 0 ? Integer.parseInt(args[0]) : 60;
    try (Stepper stepper = Stepper.of(Level.builtIn("sluice"), ServerConfig.defaults())) {
      ClientConfig all = ClientConfig.of("p").with(ClientConfig.PREDICTION, PredictionMode.ALL);
      SimulatedClient p = stepper.add(all, far, Scripts.wander(42));
      SimulatedClient q = stepper.add("q", far, new Bot(2));
      stepper.run(4);
      SimulationHost s = stepper.room().simulation();
      Free[] free = {new Free(p, s), new Free(q, s)};
      final long bytes = p.stats().bytesIn();
      final long awake = p.stats().awakeBodies();
      final long exact = p.stats().exactBodies();
      long rowBits = 0;
      long surfaceBytes = 0;
      double freeApart = 0;
      double freeMost = 0;
      double freeCount = 0;
      double pools = 0;
      Deflater deflater = new Deflater(Deflater.BEST_COMPRESSION, true);
      byte[] out = new byte[4096];
      short[][] sent = new short[s.pools().count()][];
      for (int i = 0; i < 60 * seconds; i++) {
        stepper.step();
        for (Free f : free) {
          f.step(s);
        }
        for (int k = 0; k < s.pools().count(); k++) {
          PoolDef def = s.pools().get(k).def();
          double d =
              apart(surface(def, free[0].particles.get(k)), surface(def, free[1].particles.get(k)));
          freeApart += d * d;
          freeMost = Math.max(freeMost, d);
          freeCount =
              Math.max(
                  freeCount,
                  Math.abs(free[0].particles.get(k).count() - free[1].particles.get(k).count()));
          pools++;
        }
        if (i % 6 == 0) {
          for (int k = 0; k < s.pools().count(); k++) {
            Pool pool = s.pools().get(k);
            float[] top = surface(pool.def(), pool.particles());
            byte[] diff = new byte[top.length];
            sent[k] = sent[k] == null ? new short[top.length] : sent[k];
            for (int c = 0; c < top.length; c++) {
              short now = (short) Math.round(top[c] / 0.02f);
              diff[c] = (byte) Math.max(-128, Math.min(127, now - sent[k][c]));
              sent[k][c] += diff[c];
            }
            deflater.setInput(diff);
            surfaceBytes += deflater.deflate(out, 0, out.length, Deflater.SYNC_FLUSH) - 4;
          }
          int[] row = s.pools().closedRow();
          int orders = row == null ? 0 : row[3];
          rowBits += row == null ? 0 : 16 + 64 + 32L + 64L * orders;
        }
      }
      long awakeBodies = p.stats().awakeBodies() - awake;
      System.out.printf(
          Locale.ROOT,
          "all snapshots kbit/s=%.1f rows kbit/s<=%.2f surface kbit/s=%.2f (+28 B headers a"
              + " datagram not counted)%n",
          (p.stats().bytesIn() - bytes) * 8 / 1e3 / seconds,
          rowBits / 1e3 / seconds,
          surfaceBytes * 8 / 1e3 / seconds);
      System.out.printf(
          Locale.ROOT,
          "right=%.2f %% of %d; free: apart rms=%.3f m most=%.3f m counts differ by %.0f;"
              + " ms/tick=%.3f of %d particles%n",
          100.0 * (p.stats().exactBodies() - exact) / awakeBodies,
          awakeBodies,
          Math.sqrt(freeApart / pools),
          freeMost,
          freeCount,
          free[0].nanos / 1e6 / (60.0 * seconds),
          free[0].particles.get(0).count() + free[0].particles.get(1).count());
    }
    cost();
  }

  /** Prints what a tick of the level costs a server, with pools and without bodies that predict. */
  private static void cost() throws Exception {
    SimulationHost s =
        new SimulationHost(
            Games.create("platformer"), Level.builtIn("sluice"), 1, 60, Role.AUTHORITY);
    for (int i = 0; i < 600; i++) {
      s.step();
    }
    List<Double> ms = new ArrayList<>();
    for (int i = 0; i < 900; i++) {
      long begin = System.nanoTime();
      s.pools().step(s.pools().tick() + 1);
      ms.add((System.nanoTime() - begin) / 1e6);
    }
    ms.sort(null);
    int n = 0;
    for (int k = 0; k < s.pools().count(); k++) {
      n += s.pools().get(k).particles().count();
    }
    ArchiveWriter out = new ArchiveWriter();
    s.pools().save(null).write(out);
    System.out.printf(
        Locale.ROOT,
        "pools.step ms: median=%.3f p99=%.3f of %d particles (%.3f ms per 1,000); state bytes=%d%n",
        ms.get(450),
        ms.get(890),
        n,
        ms.get(450) * 1000 / n,
        out.length());
  }
}

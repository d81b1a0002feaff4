package carom.physics.laws;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.ChainDef;
import carom.physics.Collision;
import carom.physics.CollisionListener;
import carom.physics.EventLists;
import carom.physics.Filter;
import carom.physics.Joint;
import carom.physics.JointDef;
import carom.physics.Material;
import carom.physics.MotionLocks;
import carom.physics.QueryHit;
import carom.physics.ShapeDef;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.archive.ArchiveWriter;
import carom.physics.collision.Cast;
import carom.physics.collision.CastHit;
import carom.physics.collision.ClosestPoints;
import carom.physics.collision.Collider;
import carom.physics.collision.Core;
import carom.physics.collision.Distance;
import carom.physics.collision.Gjk;
import carom.physics.collision.Manifold;
import carom.physics.collision.Mtv;
import carom.physics.collision.PointOfCollision;
import carom.physics.collision.Sat;
import carom.physics.collision.SignedDistance;
import carom.physics.collision.Sweep;
import carom.physics.collision.TimeOfImpact;
import carom.physics.effects.AreaEffect;
import carom.physics.effects.Attractor;
import carom.physics.effects.Buoyancy;
import carom.physics.effects.Explosion;
import carom.physics.effects.Hover;
import carom.physics.effects.OneWay;
import carom.physics.effects.Spring;
import carom.physics.effects.Wind;
import carom.physics.geometry.Box;
import carom.physics.geometry.Capsule;
import carom.physics.geometry.Chain;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Compound;
import carom.physics.geometry.MassData;
import carom.physics.geometry.Polygon;
import carom.physics.geometry.Segment;
import carom.physics.math.Aabb;
import carom.physics.math.Interval;
import carom.physics.math.SimRandom;
import carom.physics.math.Transform;
import carom.physics.math.Vec2;
import carom.physics.mover.Mover;
import carom.physics.mover.MoverDef;
import carom.physics.particles.Emitter;
import carom.physics.particles.ParticleDef;
import carom.physics.particles.Particles;
import carom.physics.rows.ExactRows;
import java.io.IOException;
import java.lang.reflect.Constructor;
import java.lang.reflect.Executable;
import java.lang.reflect.Field;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.lang.reflect.Proxy;
import java.net.URI;
import java.net.URISyntaxException;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.Stream;

/**
 * A small world with one of each thing that calls may concern, and another world with foreign ones.
 * It makes wild calls, and tells its whole state as text.
 */
final class WildWorld {
  /**
   * The packages of a program's calls. {@code broadphase} and {@code rows} stay out: theirs are
   * kernels on arrays that their callers own, which say what they take and don't look.
   */
  private static final List<String> PACKAGES =
      List.of("", "mover/", "particles/", "effects/", "geometry/", "collision/", "math/");

  private static final float[] FLOATS = {
    Float.NaN,
    Float.POSITIVE_INFINITY,
    Float.NEGATIVE_INFINITY,
    3e38f,
    -3e38f,
    1e7f,
    -4e4f,
    -1,
    0,
    0.25f,
    1,
    3
  };
  private static final int[] INTS = {Integer.MIN_VALUE, Integer.MAX_VALUE, -1, 0, 1, 2, 77};

  final World<String> world = new World<>(new WorldDef());

  /** The collision of the callback that runs, null for none. */
  Collision<String> collision;

  private final Random random;
  private final World<String> foreign = new World<>(new WorldDef());
  private final List<Object> things = new ArrayList<>();
  private final Particles particles;
  private final Mover<String> mover;
  private final ArchiveWriter bytes = new ArchiveWriter();

  /** What is done in a callback. */
  interface Action {
    void run(String place, Collision<String> collision);
  }

  WildWorld(Random random) {
    this.random = random;
    particles = new Particles(new ParticleDef(ParticleDef.Kind.SAND, 0.2f).maxCount(50));
    particles.add(0, 9, 0, 0);
    particles.add(0.1f, 9, 1, 0);
    fill(world);
    fill(foreign);
    MoverDef<String> def = new MoverDef<>(1.8f, 0.4f);
    mover = new Mover<>(world, def);
    mover.setPosition(3, 4);
    things.addAll(List.of(world, foreign, particles, mover, def, new WorldDef(), world.queries()));
    things.addAll(List.of(world.save(null), foreign.save(null), particles.save(null)));
    things.add(new Particles(new ParticleDef(ParticleDef.Kind.WATER, 0.2f)).save(null));
    Aabb area = new Aabb().set(-5, -5, 5, 5);
    Transform pose = new Transform(1, 2, 0.5f);
    Box box = new Box(1, 0.5f);
    things.addAll(List.of(area, new Aabb(), pose, new Transform(Float.NaN, 0, 0), box));
    things.addAll(List.of(new Circle(0.5f), Capsule.upright(2, 0.5f), Polygon.regular(5, 1)));
    things.addAll(List.of(new Segment(0, 0, 1, 1), Chain.open(0, 0, 1, 0, 2, 1)));
    things.addAll(List.of(Compound.of(box, new Circle(1)), new Box(1e5f, 1e5f)));
    things.addAll(
        List.of(AreaEffect.force(area, 1, 2), new Attractor(0, 0, 9), new Wind(area, 1, 2)));
    things.addAll(List.of(new Buoyancy(area, 2), new Explosion(0, 0, 5), new Vec2(1, 2)));
    things.add(new OneWay<String>((b, s) -> false));
    things.addAll(List.of(new Spring(0, 0, 9), new Hover<String>(2)));
    things.addAll(List.of(new Emitter(0, 0, 1, 0), new ParticleDef(ParticleDef.Kind.SAND, 0.1f)));
    things.addAll(List.of(Material.DEFAULT, Filter.DEFAULT, MotionLocks.NONE, new ShapeDef(box)));
    things.addAll(List.of(new BodyDef(BodyType.DYNAMIC).shape(box), ChainDef.open(0, 0, 1, 0)));
    things.addAll(List.of(new MassData(1, 30_000, 0, 1), new MassData(1, 0, 0, 1)));
    things.add(JointDef.revolute(null, world.body(1), 0, 0));
    things.add(JointDef.weld(world.body(1), world.body(2), 0, 0));
    things.addAll(List.of(new QueryHit<String>(), new EventLists<String>(), new ExactRows()));
    ExactRows astray = new ExactRows();
    astray.addBody(77);
    things.add(astray);
    things.addAll(List.of(new Interval(), new SimRandom(1), new Cast(), new CastHit(), new Mtv()));
    things.addAll(List.of(new ClosestPoints(), new Collider(), new Core(), new Distance()));
    things.addAll(List.of(new Gjk(), new Manifold(), new PointOfCollision(), new Sat()));
    things.addAll(List.of(new SignedDistance(), new Sweep(), new TimeOfImpact()));
    EventLists<String> lists = new EventLists<>();
    things.addAll(List.of(lists.begins(), lists.breaks()));
  }

  private void fill(World<String> in) {
    for (int i = 0; i < 5; i++) {
      BodyType type = i == 0 ? BodyType.STATIC : i == 3 ? BodyType.KINEMATIC : BodyType.DYNAMIC;
      BodyDef def = new BodyDef(type).position(i == 0 ? 0 : 3 * i - 6, i == 0 ? -1 : 0.5f);
      ShapeDef shape = new ShapeDef(i == 0 ? new Box(20, 1) : new Box(0.5f, 0.5f, 0.1f, 0));
      things.add(in.createBody(def.velocity(i == 2 ? 1 : 0, -2 * i).shape(shape), "body" + i));
    }
    Body<String> inside =
        in.createBody(
            new BodyDef(BodyType.DYNAMIC)
                .position(-3, 1)
                .shape(new ShapeDef(new Circle(2)).withSensor(true)),
            "sensor");
    things.add(inside);
    Body<String> gone = in.createBody(new BodyDef(), "gone");
    in.destroyBody(gone);
    things.add(gone);
    things.add(in.createJoint(JointDef.revolute(null, in.body(1), -3, 0.5f).limits(-1, 1)));
    things.add(in.createJoint(JointDef.distance(in.body(2), in.body(4), 0, 0, 3, 0)));
    things.add(in.createJoint(JointDef.motor(in.body(1), in.body(2), 10, 10).breaksAt(0, 0)));
    things.add(in.createJoint(JointDef.mouse(in.body(4), 0, 0, 100)));
    Joint<String> cut = in.createJoint(JointDef.weld(in.body(1), in.body(4), 0, 0));
    in.destroyJoint(cut);
    things.add(cut);
  }

  /** Makes two steps, in whose callbacks something is done. */
  void step(Action action) {
    world.listener(
        new CollisionListener<>() {
          @Override
          public void begin(Collision<String> c) {
            action.run("begin", c);
          }

          @Override
          public void end(Collision<String> c) {
            action.run("end", c);
          }

          @Override
          public boolean preSolve(Collision<String> c) {
            action.run("preSolve", c);
            return true;
          }

          @Override
          public void postSolve(Collision<String> c) {
            action.run("postSolve", c);
          }

          @Override
          public void hit(Collision<String> c) {
            action.run("hit", c);
          }
        });
    world.jointListener(joint -> action.run("broke", null));
    world.collisionFilter(
        (a, i, b, k) -> {
          action.run("shouldCollide", null);
          return true;
        });
    world.step(1 / 60f);
    world.step(1 / 60f);
    world.listener(null);
    world.jointListener(null);
    world.collisionFilter(null);
  }

  /** Returns all public classes of the packages whose calls obey the law. */
  static List<Class<?>> types() {
    try {
      URI source = World.class.getProtectionDomain().getCodeSource().getLocation().toURI();
      Path path = Path.of(source);
      if (Files.isDirectory(path)) {
        return types(path);
      }
      try (FileSystem jar = FileSystems.newFileSystem(path)) {
        return types(jar.getPath("/"));
      }
    } catch (IOException | URISyntaxException | ClassNotFoundException e) {
      throw new IllegalStateException("classes=" + World.class, e);
    }
  }

  private static List<Class<?>> types(Path root) throws IOException, ClassNotFoundException {
    List<Class<?>> types = new ArrayList<>();
    for (String name : PACKAGES) {
      try (Stream<Path> files = Files.list(root.resolve("carom/physics/" + name))) {
        for (Path file : files.sorted().toList()) {
          String simple = file.getFileName().toString();
          if (simple.endsWith(".class") && !simple.contains("-")) {
            String dotted =
                "carom.physics." + name.replace('/', '.') + simple.replace(".class", "");
            Class<?> type = Class.forName(dotted);
            if (Modifier.isPublic(type.getModifiers()) && !type.isInterface()) {
              types.add(type);
            }
          }
        }
      }
    }
    return types;
  }

  /**
   * Returns the state of all there is: that of the worlds bit for bit, and the fields of others.
   */
  String state() {
    StringBuilder text = new StringBuilder();
    for (World<String> each : List.of(world, foreign)) {
      bytes.clear();
      each.save(null).write(bytes);
      text.append(each.stateHash()).append(' ');
      text.append(Arrays.hashCode(bytes.toBytes())).append('\n');
    }
    int[] row = new int[Mover.INTS];
    mover.readRow(row, 0);
    text.append(Arrays.toString(row)).append(particles.stateHash());
    for (Object thing : things) {
      String name = thing.getClass().getSimpleName();
      if (name.endsWith("Def") || name.endsWith("Effect") || thing instanceof Record) {
        fields(thing, text);
      } else if (List.of("Attractor", "Buoyancy", "Explosion", "Emitter", "Spring")
          .contains(name)) {
        fields(thing, text);
      }
    }
    return text.toString();
  }

  private static void fields(Object of, StringBuilder text) {
    text.append('\n').append(of.getClass().getSimpleName());
    for (Field field : of.getClass().getDeclaredFields()) {
      Class<?> type = field.getType();
      if (!Modifier.isStatic(field.getModifiers())
          && (type.isPrimitive() || type.isEnum() || type.isRecord() || List.class == type)) {
        try {
          field.setAccessible(true);
          text.append(' ').append(field.getName()).append('=').append(field.get(of));
        } catch (IllegalAccessException e) {
          throw new IllegalStateException("field=" + field, e);
        }
      }
    }
  }

  /** Makes a call with wild arguments; returns what it threw, or null. */
  Throwable call(Executable call) {
    Object[] arguments = new Object[call.getParameterCount()];
    for (int i = 0; i < arguments.length; i++) {
      arguments[i] = wild(call.getParameterTypes()[i]);
    }
    try {
      call.setAccessible(true);
      if (call instanceof Constructor<?> constructor) {
        constructor.newInstance(arguments);
      } else if (Modifier.isStatic(call.getModifiers())) {
        ((Method) call).invoke(null, arguments);
      } else {
        Class<?> owner = call.getDeclaringClass();
        Object on = owner == Collision.class ? collision : pick(owner);
        if (on == null && owner != Collision.class && !owner.getSimpleName().contains("Replay")) {
          throw new IllegalStateException("no thing of type=" + owner + " in this world; add one");
        }
        if (on == null) {
          return null;
        }
        ((Method) call).invoke(on, arguments);
      }
      return null;
    } catch (InvocationTargetException e) {
      return e.getCause();
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException("call=" + call, e);
    }
  }

  private Object pick(Class<?> type) {
    List<Object> fit = things.stream().filter(type::isInstance).toList();
    return fit.isEmpty() ? null : fit.get(random.nextInt(fit.size()));
  }

  private Object wild(Class<?> type) {
    if (type == float.class) {
      return FLOATS[random.nextInt(FLOATS.length)];
    } else if (type == double.class) {
      return (double) FLOATS[random.nextInt(FLOATS.length)];
    } else if (type == int.class) {
      return INTS[random.nextInt(INTS.length)];
    } else if (type == long.class) {
      return random.nextBoolean() ? random.nextLong() : (long) INTS[random.nextInt(INTS.length)];
    } else if (type == boolean.class) {
      return random.nextBoolean();
    } else if (random.nextInt(4) == 0) {
      return null;
    } else if (type == float[].class) {
      float[] values = new float[random.nextInt(9)];
      for (int i = 0; i < values.length; i++) {
        values[i] = (float) wild(float.class);
      }
      return values;
    } else if (type == int[].class) {
      int[] values = new int[random.nextInt(4) == 0 ? random.nextInt(9) : 80];
      for (int i = 0; i < values.length; i++) {
        values[i] = random.nextInt(3) == 0 ? random.nextInt() : 0;
      }
      return values;
    } else if (type == byte[].class) {
      return new byte[random.nextInt(40)];
    } else if (type.isArray()) {
      Object array = java.lang.reflect.Array.newInstance(type.componentType(), random.nextInt(9));
      for (int i = 0; i < java.lang.reflect.Array.getLength(array); i++) {
        java.lang.reflect.Array.set(array, i, wild(type.componentType()));
      }
      return array;
    } else if (type.isEnum()) {
      return type.getEnumConstants()[random.nextInt(type.getEnumConstants().length)];
    } else if (type == List.class) {
      return random.nextBoolean() ? List.of() : Arrays.asList(new Box(1, 1), null);
    } else if (type == Object.class) {
      return "user";
    } else if (type.isInterface() && !Collection.class.isAssignableFrom(type) && !type.isSealed()) {
      return Proxy.newProxyInstance(
          type.getClassLoader(), new Class<?>[] {type}, (p, m, a) -> answer(p, m));
    }
    return pick(type);
  }

  private static Object answer(Object proxy, Method method) {
    if (method.getName().equals("hashCode")) {
      return System.identityHashCode(proxy);
    }
    Map<Class<?>, Object> answers =
        Map.of(boolean.class, true, int.class, 0, float.class, 0f, long.class, 0L);
    return answers.get(method.getReturnType());
  }
}

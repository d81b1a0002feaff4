package carom.sim.level;

import carom.physics.BodyType;
import carom.physics.math.Limits;
import carom.sim.pool.PoolDef;
import carom.text.FileErrors;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * A level: static geometry, bodies, spawn points, zones and colours, read from a JSON file.
 * Immutable. {@code docs/games/LEVELS.md} describes the format.
 */
public final class Level {
  /** Owner id of everything that the level places: no player. */
  public static final int NO_OWNER = -1;

  /**
   * Version of the format of level files. All files up to now have this one: fields were only
   * added.
   */
  public static final int VERSION = 1;

  /** Largest level file, in bytes. */
  public static final int MAX_BYTES = 1 << 22;

  /**
   * The place of a body.
   *
   * @param archetype index into {@link #archetypes}
   * @param x position of the body's origin, metres
   * @param y position of the body's origin, metres
   * @param angle radians, counterclockwise
   */
  public record Placement(int archetype, float x, float y, float angle) {}

  /** Receives the bodies of a level as entities; see {@link Level#forEachBody}. */
  public interface EntityVisitor {
    /**
     * Visits a body. The bodies come in order of their ids.
     *
     * @param id of the entity
     * @param generation of the entity
     * @param archetype index
     * @param owner {@link Level#NO_OWNER}
     * @param x metres
     * @param y metres
     * @param angle radians
     * @param vx m/s
     * @param vy m/s
     * @param omega rad/s
     */
    void body(
        int id,
        int generation,
        int archetype,
        int owner,
        float x,
        float y,
        float angle,
        float vx,
        float vy,
        float omega);
  }

  /**
   * A point where something may appear.
   *
   * @param name what may appear here, such as {@code player}
   * @param x metres
   * @param y metres
   * @param team the team it belongs to, 0 for any
   */
  public record Spawn(String name, float x, float y, int team) {}

  /**
   * A named rectangle.
   *
   * @param name its purpose, such as {@code goal}
   * @param minX left edge, metres
   * @param minY lower edge, metres
   * @param maxX right edge, metres
   * @param maxY upper edge, metres
   * @param team the team it belongs to, 0 for any
   * @param rgb colour for a light tint, 0xRRGGBB, or -1 for none
   */
  public record Zone(
      String name, float minX, float minY, float maxX, float maxY, int team, int rgb) {
    /** Returns whether a point lies inside or on the edge. */
    public boolean contains(float x, float y) {
      return x >= minX && x <= maxX && y >= minY && y <= maxY;
    }
  }

  /**
   * The bounds of the playing field, in metres. Whatever leaves them is out of the game.
   *
   * @param minX left edge
   * @param minY lower edge
   * @param maxX right edge
   * @param maxY upper edge
   */
  public record Bounds(float minX, float minY, float maxX, float maxY) {
    /** Returns whether a point lies inside or on the edge. */
    public boolean contains(float x, float y) {
      return x >= minX && x <= maxX && y >= minY && y <= maxY;
    }
  }

  /**
   * The colours of everything that is not a body, 0xRRGGBB.
   *
   * @param background behind everything, lower edge of the view
   * @param sky behind everything, upper edge of the view
   * @param grid thin lines, one per metre or so
   * @param accent marks that should catch the eye
   */
  public record Theme(int background, int sky, int grid, int accent) {}

  private static volatile ClassLoader builtIns = Level.class.getClassLoader();

  private final String name;
  private final String gameName;
  private final byte[] source;
  private final float gravityX;
  private final float gravityY;
  private final Bounds bounds;
  private final Theme theme;
  private final List<ArchetypeDef> archetypes;
  private final List<Placement> statics;
  private final List<Placement> bodies;
  private final List<Spawn> spawns;
  private final List<Zone> zones;
  private final List<Area> areas;
  private final List<LevelJoint> joints;
  private final List<PoolDef> pools;
  private final List<LevelTrigger> triggers;

  Level(LevelReader r, byte[] source) {
    this.source = source;
    name = r.name;
    gameName = r.game;
    gravityX = r.gravityX;
    gravityY = r.gravityY;
    bounds = r.bounds;
    theme = r.theme;
    archetypes = List.copyOf(r.archetypes);
    statics = List.copyOf(r.statics);
    bodies = List.copyOf(r.bodies);
    spawns = List.copyOf(r.spawns);
    zones = List.copyOf(r.zones);
    areas = List.copyOf(r.areas);
    joints = List.copyOf(r.joints);
    pools = List.copyOf(r.pools);
    triggers = List.copyOf(r.triggers);
  }

  /**
   * Reads a level from the bytes of its file.
   *
   * @param fileName for error messages
   * @param json UTF-8, at most {@link #MAX_BYTES}; copied
   * @throws LevelException naming file, line, column, field, value and limit; nothing is kept then
   */
  public static Level parse(String fileName, byte[] json) throws LevelException {
    requireSize(fileName, Limits.notNull("json", json).length);
    byte[] source = json.clone();
    return new Level(new LevelReader(fileName, source), source);
  }

  /**
   * Reads a level file.
   *
   * @throws LevelException when it cannot be read or used
   */
  public static Level load(Path file) throws LevelException {
    String fileName = String.valueOf(Limits.notNull("file", file).getFileName());
    try (InputStream in = Files.newInputStream(file)) {
      return parse(fileName, in.readNBytes(MAX_BYTES + 1));
    } catch (IOException e) {
      throw new LevelException(
          fileName, 0, 0, "", "can't read " + file + ": " + FileErrors.reason(e));
    }
  }

  /**
   * Reads a level that is packed with the program as {@code levels/NAME.json}.
   *
   * @throws LevelException when there is none of that name, or when it cannot be used
   */
  public static Level builtIn(String name) throws LevelException {
    String fileName = name + ".json";
    try (InputStream in = builtIns.getResourceAsStream(resource(name))) {
      if (in == null) {
        throw new LevelException(
            fileName, 0, 0, "", "no level of this name comes with the program");
      }
      return parse(fileName, in.readNBytes(MAX_BYTES + 1));
    } catch (IOException e) {
      throw new LevelException(fileName, 0, 0, "", "can't read it: " + FileErrors.reason(e));
    }
  }

  /** Returns whether a level of a name is packed with the program or one of its games. */
  public static boolean isBuiltIn(String name) {
    return builtIns.getResource(resource(name)) != null;
  }

  /** Sets what finds packed levels: those of the program, and of jars that it loads later. */
  public static void builtInsOf(ClassLoader loader) {
    builtIns = loader;
  }

  private static String resource(String name) {
    return "levels/" + name + ".json";
  }

  /** Returns the level's name, for people. */
  public String name() {
    return name;
  }

  /** Returns the name of the game for which it is made. */
  public String gameName() {
    return gameName;
  }

  /** Returns a copy of the bytes of the file, as {@link #parse} got them. */
  public byte[] source() {
    return source.clone();
  }

  /** Returns a 64-bit hash of the file's bytes (FNV-1a). Equal files have equal hashes. */
  public long contentHash() {
    long hash = 0xcbf29ce484222325L;
    for (byte b : source) {
      hash = (hash ^ (b & 0xff)) * 0x100000001b3L;
    }
    return hash;
  }

  /** Returns the gravity to the right, m/s^2. */
  public float gravityX() {
    return gravityX;
  }

  /** Returns the gravity upwards, m/s^2; a negative value pulls down. */
  public float gravityY() {
    return gravityY;
  }

  /** Returns the bounds of the playing field. */
  public Bounds bounds() {
    return bounds;
  }

  /** Returns the colours of everything that is not a body. */
  public Theme theme() {
    return theme;
  }

  /** Returns one archetype definition for each item in the file, statics first. */
  public List<ArchetypeDef> archetypes() {
    return archetypes;
  }

  /** Returns whether a body of {@link #bodies} is kinematic and has no motion of its own. */
  public boolean isMovable(int body) {
    ArchetypeDef def = archetypes.get(bodies.get(body).archetype());
    return def.type == BodyType.KINEMATIC && def.motion == null;
  }

  /** Returns the names of the static sensors, each once, in file order. */
  public List<String> sensorNames() {
    List<String> names = new ArrayList<>();
    for (Placement p : statics) {
      ArchetypeDef def = archetypes.get(p.archetype());
      if (def.sensor && !names.contains(def.name)) {
        names.add(def.name);
      }
    }
    return names;
  }

  /** Returns the static bodies in file order, repeats expanded; unmodifiable. */
  public List<Placement> statics() {
    return statics;
  }

  /**
   * Returns the dynamic and kinematic bodies in file order, repeats expanded; unmodifiable. On the
   * server, the entity with id n is the n-th of them for as long as the game does not despawn it.
   */
  public List<Placement> bodies() {
    return bodies;
  }

  /**
   * Visits the dynamic ones of {@link #bodies} as the entities they become at tick 0, at rest.
   * Server and client thus agree on the beginning without a byte on the wire. Kinematic bodies are
   * left out, because they are never at rest.
   */
  public void forEachBody(EntityVisitor visitor) {
    Limits.notNull("visitor", visitor);
    for (int id = 0; id < bodies.size(); id++) {
      Placement p = bodies.get(id);
      if (archetypes.get(p.archetype()).type != BodyType.DYNAMIC) {
        continue;
      }
      visitor.body(id, 0, p.archetype(), NO_OWNER, p.x(), p.y(), p.angle(), 0, 0, 0);
    }
  }

  /** Returns all spawn points in file order, unmodifiable. */
  public List<Spawn> spawns() {
    return spawns;
  }

  /** Returns the spawn points of one name in file order. Allocates: for set-up. */
  public List<Spawn> spawns(String spawnName) {
    Limits.notNull("spawnName", spawnName);
    List<Spawn> found = new ArrayList<>();
    for (Spawn spawn : spawns) {
      if (spawn.name().equals(spawnName)) {
        found.add(spawn);
      }
    }
    return found;
  }

  /** Returns all zones in file order, unmodifiable. */
  public List<Zone> zones() {
    return zones;
  }

  /** Returns the zones of one name in file order. Allocates: for set-up. */
  public List<Zone> zones(String zoneName) {
    Limits.notNull("zoneName", zoneName);
    List<Zone> found = new ArrayList<>();
    for (Zone zone : zones) {
      if (zone.name().equals(zoneName)) {
        found.add(zone);
      }
    }
    return found;
  }

  /** Returns the areas in file order, unmodifiable. Those that bodies carry aren't among them. */
  public List<Area> areas() {
    return areas;
  }

  /** Returns water and sand in file order, unmodifiable. */
  public List<PoolDef> pools() {
    return pools;
  }

  /**
   * Returns the joints in file order, unmodifiable. On the server, the joint with index n is the
   * n-th of them for as long as it holds.
   */
  public List<LevelJoint> joints() {
    return joints;
  }

  /** Returns the triggers in file order, unmodifiable. */
  public List<LevelTrigger> triggers() {
    return triggers;
  }

  static void requireSize(String fileName, int size) throws LevelException {
    if (size > MAX_BYTES) {
      throw new LevelException(
          fileName, 0, 0, "", "size exceeds the limit of " + MAX_BYTES + " bytes; split the level");
    }
  }
}

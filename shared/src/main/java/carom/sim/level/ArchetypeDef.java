package carom.sim.level;

import carom.physics.BodyType;
import carom.physics.Filter;
import carom.physics.Material;
import carom.physics.MotionLocks;
import carom.physics.geometry.Shape;
import carom.physics.math.Limits;
import carom.sim.event.Audience;
import carom.sim.field.Field;
import carom.sim.field.Ratio;
import carom.sim.field.Scope;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * Describes an {@link Archetype} before it is registered. It is filled in fluently and handed to
 * {@link Archetypes#add}, which copies it.
 *
 * <pre>{@code
 * Archetype ball = simulation.archetypes().add(new ArchetypeDef("ball")
 *     .shape(new Circle(0.5f), new Material(0.4f, 0.3f, 0.6f))
 *     .linearDamping(0.7f)
 *     .appearance(Appearance.of(0xffe08a, Appearance.Look.BALL)));
 * }</pre>
 */
public final class ArchetypeDef {
  final String name;
  BodyType type = BodyType.DYNAMIC;
  final List<Shape> shapes = new ArrayList<>();
  final List<Material> materials = new ArrayList<>();
  float linearDamping;
  float angularDamping;
  float gravityScale = 1;
  MotionLocks locks = MotionLocks.NONE;
  Float sleepSpeed;
  boolean bullet;
  Filter filter = Filter.DEFAULT;
  boolean oneWay;
  boolean sensor;
  int tag;
  float spin;
  ScriptedMotion motion;
  Appearance appearance = Appearance.DEFAULT;
  Area area;
  Ratio areaPower;
  final List<Field<?>> starts = new ArrayList<>();
  final List<LevelField> levelFields = new ArrayList<>();

  /**
   * Creates a dynamic archetype without shapes. The name is for people and for {@link
   * Archetypes#find}.
   */
  public ArchetypeDef(String name) {
    this.name = Limits.notNull("name", name);
  }

  ArchetypeDef(ArchetypeDef d) {
    name = d.name;
    type = d.type;
    shapes.addAll(d.shapes);
    materials.addAll(d.materials);
    linearDamping = d.linearDamping;
    angularDamping = d.angularDamping;
    gravityScale = d.gravityScale;
    locks = d.locks;
    sleepSpeed = d.sleepSpeed;
    bullet = d.bullet;
    filter = d.filter;
    oneWay = d.oneWay;
    sensor = d.sensor;
    tag = d.tag;
    spin = d.spin;
    motion = d.motion;
    appearance = d.appearance;
    area = d.area;
    areaPower = d.areaPower;
    starts.addAll(d.starts);
    levelFields.addAll(d.levelFields);
  }

  /** Returns the name. */
  public String name() {
    return name;
  }

  /** Returns the shapes, unmodifiable. */
  public List<Shape> shapes() {
    return Collections.unmodifiableList(shapes);
  }

  /** Returns how it looks. */
  public Appearance appearance() {
    return appearance;
  }

  /** Sets whether the bodies are static, kinematic or dynamic; dynamic by default. */
  public ArchetypeDef type(BodyType value) {
    type = Limits.notNull("type", value);
    return this;
  }

  /** Adds a shape in the body's frame, with its own material. */
  public ArchetypeDef shape(Shape shape, Material material) {
    Limits.notNull("material", material);
    shapes.add(Limits.notNull("shape", shape));
    materials.add(material);
    return this;
  }

  /** Sets how fast the velocity decays, in 1/s; 0 by default. */
  public ArchetypeDef linearDamping(float perSecond) {
    linearDamping = perSecond;
    return this;
  }

  /** Sets how fast the angular velocity decays, in 1/s; 0 by default. */
  public ArchetypeDef angularDamping(float perSecond) {
    angularDamping = perSecond;
    return this;
  }

  /** Sets the factor on the world's gravity; 1 by default. */
  public ArchetypeDef gravityScale(float factor) {
    gravityScale = factor;
    return this;
  }

  /** Sets whether the bodies never turn; false by default. */
  public ArchetypeDef fixedRotation(boolean fixed) {
    locks = locks.withAngularZ(fixed);
    return this;
  }

  /** Sets the axes along which nothing but its velocity moves a body; none by default. */
  public ArchetypeDef motionLocks(MotionLocks motionLocks) {
    locks = Limits.notNull("motionLocks", motionLocks);
    return this;
  }

  /** Sets the speed below which a body is at rest, m/s, 0..1000; the world's by default. */
  public ArchetypeDef sleepSpeed(float speed) {
    sleepSpeed = Limits.range("sleepSpeed", speed, 0, Limits.MAX_SLEEP_SPEED);
    return this;
  }

  /** Sets whether fast bodies hit other moving ones exactly, as bullets; false by default. */
  public ArchetypeDef bullet(boolean value) {
    bullet = value;
    return this;
  }

  /** Sets with what all shapes of the bodies collide; with everything by default. */
  public ArchetypeDef filter(Filter value) {
    filter = Limits.notNull("filter", value);
    return this;
  }

  /** Sets whether the bodies carry only what comes from above; false by default. */
  public ArchetypeDef oneWay(boolean value) {
    oneWay = value;
    return this;
  }

  /** Sets whether the bodies are sensors, which detect overlaps and collide with nothing. */
  public ArchetypeDef sensor(boolean value) {
    sensor = value;
    return this;
  }

  /** Sets a number with a meaning of the game's own, such as a team; 0 by default. */
  public ArchetypeDef tag(int value) {
    tag = value;
    return this;
  }

  /** Sets the angular velocity of a kinematic body, rad/s, counterclockwise; 0 by default. */
  public ArchetypeDef spin(float radPerSecond) {
    spin = radPerSecond;
    return this;
  }

  /** Sets the path of a kinematic body. The simulation keeps each such body on it. */
  public ArchetypeDef motion(ScriptedMotion value) {
    motion = Limits.notNull("motion", value);
    return this;
  }

  /**
   * Sets an area that the entities carry along, in the body's frame: a fan's wind, a magnet. It
   * acts on all bodies but the carrier; none by default. Clients predict it like an area of the
   * level.
   */
  public ArchetypeDef area(Area value) {
    area = Limits.notNull("area", value);
    areaPower = null;
    return this;
  }

  /**
   * Sets an area that the entities carry along, as strong as a field of the entity says: 0 is off,
   * 1 is as set. What is in such an area stays awake while it is on.
   *
   * @param value the area
   * @param power a field of entities that all players near are told, so that they predict it
   * @throws IllegalArgumentException if the field belongs to something else or is told to fewer
   */
  public ArchetypeDef area(Area value, Ratio power) {
    Limits.notNull("power", power);
    boolean told = power.audience() == Audience.NEAR || power.audience() == Audience.ALL;
    if (power.scope() != Scope.ENTITY || !told) {
      throw new IllegalArgumentException(
          "archetype="
              + name
              + ": field "
              + power
              + " can't be the power of an area; declare it .of(ENTITY).to(NEAR)");
    }
    area = Limits.notNull("area", value);
    areaPower = power;
    return this;
  }

  /**
   * Sets with what fields of the entities begin, where that isn't as declared: {@code
   * starts(HEALTH.startsAt(500))}. All values of a field with several begin so.
   *
   * @param fields of entities; declared but for their start
   */
  public ArchetypeDef starts(Field<?>... fields) {
    for (Field<?> field : Limits.notNull("fields", fields)) {
      Limits.notNull("field", field);
    }
    starts.addAll(List.of(fields));
    return this;
  }

  /** Sets how the entities are drawn. */
  public ArchetypeDef appearance(Appearance value) {
    appearance = Limits.notNull("appearance", value);
    return this;
  }
}

package carom.sim.entity;

import carom.physics.Body;
import carom.physics.JointDef;
import carom.physics.math.Limits;
import carom.sim.level.ArchetypeDef;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BiFunction;

/**
 * Describes an {@link Assembly} before it is registered: bodies and joints that belong together, as
 * a car's. It is filled in fluently and handed to {@link Assemblies#add}.
 *
 * <pre>{@code
 * Assembly car = simulation.assemblies().add(new AssemblyDef("car")
 *     .body("chassis", new ArchetypeDef("chassis").shape(new Box(1.4f, 0.3f), METAL), 0, 0)
 *     .body("rear", new ArchetypeDef("wheel").shape(new Circle(0.4f), RUBBER), -1, -0.6f)
 *     .joint("drive", "chassis", "rear",
 *         (a, b) -> JointDef.wheel(a, b, -1, -0.6f, 0, 1).spring(4, 0.7f).motor(0, 40)));
 * }</pre>
 */
public final class AssemblyDef {
  /** Most bodies of an assembly. */
  public static final int MAX_BODIES = 64;

  /** Most joints of an assembly. */
  public static final int MAX_JOINTS = 128;

  /** A body of the assembly, in the assembly's frame: metres and radians. */
  record Part(String name, ArchetypeDef archetype, float x, float y, float angle) {}

  /** A joint between two bodies of the assembly. */
  record PartJoint(
      String name, int a, int b, BiFunction<Body<Object>, Body<Object>, JointDef<Object>> how) {}

  final String name;
  final List<Part> parts = new ArrayList<>();
  final List<PartJoint> joints = new ArrayList<>();

  /** Creates an assembly without bodies. The name is for people and for error messages. */
  public AssemblyDef(String name) {
    this.name = Limits.notNull("name", name);
  }

  /** Returns its name. */
  public String name() {
    return name;
  }

  /**
   * Adds a body. The first one is the root: the player's body, if a player owns the assembly.
   *
   * @param bodyName its name within the assembly
   * @param archetype what it is like; registered with the simulation
   * @param x where it is in the assembly's frame, metres
   * @param y where it is in the assembly's frame, metres
   * @throws IllegalArgumentException if the name is taken, or beyond {@value #MAX_BODIES}
   */
  public AssemblyDef body(String bodyName, ArchetypeDef archetype, float x, float y) {
    return body(bodyName, archetype, x, y, 0);
  }

  /**
   * Adds a body that is turned by an angle, radians; see {@link #body(String, ArchetypeDef, float,
   * float)}.
   */
  public AssemblyDef body(String bodyName, ArchetypeDef archetype, float x, float y, float angle) {
    Limits.notNull("archetype", archetype);
    if (place(Limits.notNull("bodyName", bodyName)) >= 0) {
      throw wrong("body=" + bodyName + " is there already; give each body a name of its own");
    }
    if (parts.size() == MAX_BODIES) {
      throw wrong("body=" + bodyName + " exceeds the limit of " + MAX_BODIES);
    }
    parts.add(new Part(bodyName, archetype, x, y, angle));
    return this;
  }

  /**
   * Adds a joint.
   *
   * @param jointName its name within the assembly, for {@code Simulation.joint}
   * @param a name of body A, added before
   * @param b name of body B, added before
   * @param how makes the definition from both bodies, with points of the assembly's frame; called
   *     once, when the assembly is registered
   * @throws IllegalArgumentException if a body is unknown, the name is taken, or beyond {@value
   *     #MAX_JOINTS}
   */
  public AssemblyDef joint(
      String jointName,
      String a,
      String b,
      BiFunction<Body<Object>, Body<Object>, JointDef<Object>> how) {
    Limits.notNull("how", how);
    Limits.notNull("jointName", jointName);
    for (PartJoint part : joints) {
      if (part.name.equals(jointName)) {
        throw wrong("joint=" + jointName + " is there already; give each joint a name of its own");
      }
    }
    if (joints.size() == MAX_JOINTS) {
      throw wrong("joint=" + jointName + " exceeds the limit of " + MAX_JOINTS);
    }
    joints.add(new PartJoint(jointName, required(jointName, a), required(jointName, b), how));
    return this;
  }

  private int required(String jointName, String body) {
    int place = place(body);
    if (place < 0) {
      throw wrong("joint=" + jointName + " holds body=" + body + "; add that body before");
    }
    return place;
  }

  private int place(String body) {
    for (int i = 0; i < parts.size(); i++) {
      if (parts.get(i).name.equals(body)) {
        return i;
      }
    }
    return -1;
  }

  IllegalArgumentException wrong(String problem) {
    return new IllegalArgumentException("assembly=" + name + ": " + problem);
  }
}

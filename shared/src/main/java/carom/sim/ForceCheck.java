package carom.sim;

import carom.physics.Body;
import carom.physics.World;
import carom.sim.entity.HostEntity;
import carom.sim.phase.Findings;
import java.util.function.Consumer;

/**
 * Checks now and then, one body at a time, that {@code Game.forces} changes no other body than the
 * one it is called for. A client that doesn't have the other one would compute something else. One
 * thread; allocates for a finding only.
 */
final class ForceCheck {
  /** A body is checked in every tick of so many. */
  private static final int TICKS = 16;

  private final World<HostEntity> world;
  private final Findings findings;
  private final Consumer<Body<HostEntity>> add = this::add;
  private int visited;
  private int checked;
  private Body<HostEntity> subject;
  private long sum;
  private long before;

  /** Creates a check of one world. */
  public ForceCheck(World<HostEntity> world, Findings findings) {
    this.world = world;
    this.findings = findings;
  }

  /** Begins a tick and chooses which of the bodies that are visited in it to check. */
  public void beginTick(int tick) {
    checked = tick % TICKS == 0 && visited > 0 ? tick / TICKS % visited : -1;
    visited = 0;
  }

  /** Notes that forces are about to be called for a body. */
  public void begin(Body<HostEntity> body) {
    if (visited++ == checked) {
      subject = body;
      before = others();
    }
  }

  /** Notes that forces have been called for the body that began last. */
  public void end(Body<HostEntity> body, int tick) {
    if (subject != body) {
      return;
    }
    if (others() != before) {
      HostEntity e = body.user();
      findings.add(
          "forces " + e.archetype().index(),
          "forces of entity "
              + e.id()
              + " ("
              + e.archetype().name()
              + ") changes another body, which clients may not have; push only the entity that it"
              + " is called for. First seen at tick "
              + tick
              + ".");
    }
    subject = null;
  }

  private long others() {
    sum = 0;
    world.forEachAwake(add);
    return sum;
  }

  private void add(Body<HostEntity> body) {
    sum += body == subject ? 0 : body.stamp();
  }
}

package carom.sim.entity;

import carom.physics.Body;
import carom.physics.Seal;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.function.BiConsumer;

/**
 * Keeps games from changing the shared world in ways that clients never learn of. Clients know a
 * body by its archetype, its motion and what acts on it, constants by {@code Game.world}, and
 * statics by the level. So all else is refused on both sides, with what to do instead.
 *
 * <p>The simulation itself makes some of these calls. It {@linkplain #permit announces} each of
 * them just before. Until {@code Game.setUp} has ended, which runs on both sides, statics of the
 * level may be changed, too, and a collision filter set.
 *
 * <p>One simulation's; one thread. Allocates for a refusal only.
 */
public final class WorldSeal implements Seal<HostEntity> {
  private static final String CLIENTS = "clients compute it, too, and know ";
  private static final String BODY = CLIENTS + "bodies by archetypes alone; ";
  private static final String ANOTHER = BODY + "let the entity become another archetype";
  private static final String STATIC =
      CLIENTS + "static geometry by the level alone; move an entity of a static archetype";
  private static final String LISTENER = "the simulation listens; override ";

  private static final String CONSTANTS =
      CLIENTS
          + "constants by Game.world alone; let the entity become another archetype, or use an area"
          + " of another gravity";

  /** Reasons why calls are refused, and what to do instead. */
  private static final Map<String, String> REASONS =
      Map.ofEntries(
          Map.entry("setType", ANOTHER),
          Map.entry("setMass", ANOTHER + ", of another density"),
          Map.entry("computeMass", ANOTHER + ", of another density"),
          Map.entry("addShape", ANOTHER),
          Map.entry("removeShape", ANOTHER),
          Map.entry("replaceShape", ANOTHER),
          Map.entry("become", BODY + "call Entity.become"),
          Map.entry("setMotionLocks", ANOTHER + ", see ArchetypeDef.motionLocks"),
          Map.entry("setFixedRotation", ANOTHER + ", see ArchetypeDef.fixedRotation"),
          Map.entry("setBullet", ANOTHER + ", see ArchetypeDef.bullet"),
          Map.entry("setSleepSpeed", ANOTHER + ", see ArchetypeDef.sleepSpeed"),
          Map.entry("setSleepAllowed", ANOTHER + "; one of sleepSpeed(0) stays awake"),
          Map.entry("setGravityScale", ANOTHER + ", or use an area of another gravity"),
          Map.entry("setLinearDamping", ANOTHER + ", or use Game.forces or an area of drag"),
          Map.entry("setAngularDamping", ANOTHER + ", or use Game.forces or an area of drag"),
          Map.entry("setMaterial", ANOTHER + ", or set friction or bounce in Game.collision"),
          Map.entry("setFilter", ANOTHER + ", or let Game.collision return false"),
          Map.entry("setSensor", ANOTHER + ", or let Game.collision return false"),
          Map.entry("setEnabled", ANOTHER + ", or despawn it, or let Game.collision return false"),
          Map.entry("refilter", BODY + "their filters stay; let Game.collision return false"),
          Map.entry("setPose", STATIC),
          Map.entry("setCenterPose", STATIC),
          Map.entry("writeRow", STATIC),
          Map.entry("createBody", CLIENTS + "entities alone; call Simulation.spawn"),
          Map.entry("createChain", CLIENTS + "entities and the level; place a chain in the level"),
          Map.entry("destroyBody", CLIENTS + "entities alone; call Simulation.despawn"),
          Map.entry("destroyJoints", CLIENTS + "joints one by one; call Simulation.disconnect"),
          Map.entry("sortFreeBodies", "the simulation gives slots to bodies; leave it to it"),
          Map.entry("redefine", CONSTANTS),
          Map.entry(
              "collisionFilter",
              "both sides set it in Game.setUp or never; let Game.collision return false, or give"
                  + " archetypes a filter by ArchetypeDef.filter"),
          Map.entry("listener", LISTENER + "Game.collision or Game.hit, or read World.eventLists"),
          Map.entry("jointListener", LISTENER + "Game.broke"),
          Map.entry("queryScope", "the simulation sets it; give the query a QueryFilter"),
          Map.entry("step", "call Simulation.step, which steps it once in a tick"),
          Map.entry("restore", "entities belong to its state; call Simulation.restore"),
          Map.entry("writeRows", "entities belong to its state; call Simulation.restore"));

  /**
   * Calls that are allowed for static geometry in {@code Game.setUp}: both sides make them alike.
   */
  private static final Set<String> OF_STATICS =
      Set.of("setMaterial", "setFilter", "setSensor", "setEnabled", "setPose", "setCenterPose");

  private boolean isSetUp;
  private String permitted;
  private BiConsumer<HostEntity, HostEntity> overlapReader = (asked, other) -> {};

  /** Creates a seal of a world that is being set up. */
  public WorldSeal() {}

  /** Notes that the game's set-up has ended. */
  public void endSetUp() {
    isSetUp = true;
  }

  /** Sets what receives each overlap that is read. */
  public void overlapReader(BiConsumer<HostEntity, HostEntity> reader) {
    overlapReader = reader;
  }

  @Override
  public void overlapRead(Body<HostEntity> asked, Body<HostEntity> other) {
    overlapReader.accept(asked.user(), other.user());
  }

  /**
   * Lets the next call of a name pass, once. The simulation calls this right before it.
   *
   * @param call the method's name
   */
  public void permit(String call) {
    permitted = call;
  }

  @Override
  public String refusal(String call, Body<HostEntity> body) {
    if (call.equals(permitted)) {
      permitted = null;
      return null;
    }
    boolean ofStatic = body != null && body.user() != null && body.user().isLevel();
    if (isMove(call) && !ofStatic) {
      return null; // an entity, of whose moves clients hear
    }
    boolean alike = (ofStatic && OF_STATICS.contains(call)) || call.equals("collisionFilter");
    if (!isSetUp && alike) {
      return null;
    }
    return Objects.requireNonNull(REASONS.get(call), call);
  }

  private static boolean isMove(String call) {
    return call.equals("setPose") || call.equals("setCenterPose") || call.equals("writeRow");
  }
}

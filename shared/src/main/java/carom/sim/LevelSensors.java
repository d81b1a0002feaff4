package carom.sim;

import carom.physics.Body;
import carom.physics.QueryFilter;
import carom.physics.QueryHit;
import carom.physics.QueryVisitor;
import carom.physics.World;
import carom.physics.math.Limits;
import carom.physics.math.Transform;
import carom.sim.entity.HostEntity;
import carom.sim.level.Archetypes;
import carom.sim.level.Level;
import java.util.Set;
import java.util.TreeSet;

/**
 * Answers whether an entity is in a sensor of the level. The answer follows from the present pose
 * of the entity and from the level alone, so both roles compute the same one, also after
 * predictions and restores. One thread; a question allocates nothing.
 */
final class LevelSensors {
  private final World<HostEntity> world;

  /** Names of the level's statics that are sensors. */
  private final Set<String> names = new TreeSet<>();

  private final Transform pose = new Transform();
  private String wanted;
  private boolean found;
  private final QueryFilter<HostEntity> filter = (body, shape) -> isWanted(body.user());
  private final QueryVisitor<HostEntity> visitor = this::find;

  /** Creates the answers about a level that was built into a world. */
  public LevelSensors(World<HostEntity> world, Level level, Archetypes archetypes) {
    this.world = world;
    for (Level.Placement placement : level.statics()) {
      if (archetypes.get(placement.archetype()).sensor()) {
        names.add(archetypes.get(placement.archetype()).name());
      }
    }
  }

  /**
   * Returns whether a shape of an entity overlaps or touches a sensor of the level.
   *
   * @param name of the sensor, or of several
   * @throws IllegalArgumentException if the level has no static sensor of that name
   */
  public boolean contain(HostEntity entity, String name) {
    if (!names.contains(Limits.notNull("sensor", name))) {
      throw new IllegalArgumentException(
          "sensor=\""
              + name
              + "\" isn't a static of the level with \"sensor\": true, but these are: "
              + names
              + "; of sensors that move or are spawned, Game.entered and left tell");
    }
    Body<HostEntity> body = entity.body();
    pose.set(body.x(), body.y(), body.cos(), body.sin());
    wanted = name;
    found = false;
    for (int i = 0; i < body.shapeCount() && !found; i++) {
      world.queries().overlaps(body.shape(i), pose, filter, visitor);
    }
    return found;
  }

  private boolean isWanted(HostEntity entity) {
    return entity.isLevel()
        && entity.archetype().sensor()
        && entity.archetype().name().equals(wanted);
  }

  private boolean find(QueryHit<HostEntity> hit) {
    found = true;
    return false;
  }
}

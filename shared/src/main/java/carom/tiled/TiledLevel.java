package carom.tiled;

import carom.sim.level.Level;
import java.util.List;

/**
 * A level that was made of a map.
 *
 * @param level the level; {@link Level#source} is its file
 * @param skipped what of the map isn't in the level, each with its layer or object and why
 */
public record TiledLevel(Level level, List<String> skipped) {}

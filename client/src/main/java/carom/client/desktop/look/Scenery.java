package carom.client.desktop.look;

import carom.sim.level.Archetype;

/**
 * A piece of the level, which never moves.
 *
 * @param x metres
 * @param y metres
 * @param cos of its angle
 * @param sin of its angle
 */
public record Scenery(Archetype archetype, float x, float y, float cos, float sin) {}

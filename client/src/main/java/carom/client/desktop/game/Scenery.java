package carom.client.desktop.game;

import carom.sim.level.Archetype;

/**
 * A piece of the level, which never moves.
 *
 * @param x metres
 * @param y metres
 * @param cos of its angle
 * @param sin of its angle
 */
record Scenery(Archetype archetype, float x, float y, float cos, float sin) {}

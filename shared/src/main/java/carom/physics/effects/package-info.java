/**
 * Effects that act on bodies from a distance: buoyancy, areas of force, wind and drag, wind with
 * lift, attraction, explosions; and the rule of one-way platforms.
 *
 * <p>They are helpers on top of a {@link carom.physics.World}. The game calls them before {@code
 * World.step}; the engine doesn't know them. They hold settings and scratch memory but no state of
 * the simulation, so saving and restoring the world is enough. Imports only {@code java..} and
 * {@code carom.physics..}.
 *
 * <p>Read first: {@link carom.physics.effects.Buoyancy}, {@link carom.physics.effects.AreaEffect},
 * {@link carom.physics.effects.Explosion}.
 */
package carom.physics.effects;

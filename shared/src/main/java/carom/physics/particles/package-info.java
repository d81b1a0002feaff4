/**
 * Position-based particles: water and sand that collide with the bodies of a world and push them.
 *
 * <p>They are built on top of {@link carom.physics.World}, which doesn't know them; a game steps
 * them before the world. They use flat arrays without an object per particle, and they are
 * bit-exact. Imports only {@code java..} and {@code carom.physics..}.
 *
 * <p>Read first: {@link carom.physics.particles.Particles}, {@link
 * carom.physics.particles.ParticleDef}, {@link carom.physics.particles.Emitter}.
 */
package carom.physics.particles;

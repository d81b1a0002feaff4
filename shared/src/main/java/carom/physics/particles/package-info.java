/**
 * Position-based particles: water and sand that meet the bodies of a world and push them back.
 *
 * <p>On top of {@link carom.physics.World}, which doesn't know them; a game steps them before the
 * world. Flat arrays, no object per particle, bit-exact. Imports only {@code java..} and {@code
 * carom.physics..}.
 *
 * <p>Read first: {@link carom.physics.particles.Particles}, {@link
 * carom.physics.particles.ParticleDef}, {@link carom.physics.particles.Emitter}.
 */
package carom.physics.particles;

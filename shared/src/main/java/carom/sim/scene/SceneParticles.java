package carom.sim.scene;

import carom.physics.particles.Particles;

/**
 * A scene's particles and how they look.
 *
 * @param particles all of one kind
 * @param rgb their colour, 0xRRGGBB
 */
public record SceneParticles(Particles particles, int rgb) {}

package carom.sim.scene;

import carom.physics.particles.Particles;

/**
 * A system of particles of a scene, with its colour.
 *
 * @param particles the system; all its particles are of one kind
 * @param rgb their colour, 0xRRGGBB
 */
public record SceneParticles(Particles particles, int rgb) {}

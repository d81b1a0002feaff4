package carom.sim.pool;

import carom.physics.particles.Particles;

/**
 * A system of particles as a picture shows it.
 *
 * @param particles the system; all its particles are of one kind
 * @param rgb their colour, 0xRRGGBB
 */
public record ShownParticles(Particles particles, int rgb) {}

package carom.physics.geometry;

/**
 * What a shape weighs and how hard it is to turn.
 *
 * @param mass kilograms
 * @param centerX centre of mass in the frame of the shape, metres
 * @param centerY centre of mass in the frame of the shape, metres
 * @param inertia moment of inertia about the centre of mass, kg m&sup2;
 */
public record MassData(float mass, float centerX, float centerY, float inertia) {}

package carom.physics.geometry;

/**
 * Mass properties of a shape: mass, centre of mass and moment of inertia.
 *
 * @param mass mass, kilograms
 * @param centerX centre of mass in the frame of the shape, metres
 * @param centerY centre of mass in the frame of the shape, metres
 * @param inertia moment of inertia about the centre of mass, kg m&sup2;
 */
public record MassData(float mass, float centerX, float centerY, float inertia) {}

package carom.physics.dynamics.body;

/**
 * The constants of a world as the solver sees them; see {@code carom.physics.WorldDef} for what
 * each one does.
 *
 * @param gravityX m/s^2
 * @param gravityY m/s^2
 * @param substeps slices per step
 * @param contactHertz 1/s
 * @param contactDampingRatio 1 = critical
 * @param restitutionThreshold m/s
 * @param maxPushSpeed m/s
 * @param slop m
 * @param speculativeDistance m
 * @param aabbMargin m
 * @param maxSpeed m/s
 * @param maxAngularSpeed rad/s
 * @param jointHertz 1/s
 * @param jointDampingRatio 1 = critical
 * @param sleeping whether anything falls asleep
 * @param sleepSpeed m/s
 * @param sleepDelay s
 * @param continuous whether fast bodies are swept
 * @param hitSpeed m/s
 * @param explicitEuler whether positions advance by the velocities before those do
 */
public record Settings(
    float gravityX,
    float gravityY,
    int substeps,
    float contactHertz,
    float contactDampingRatio,
    float restitutionThreshold,
    float maxPushSpeed,
    float slop,
    float speculativeDistance,
    float aabbMargin,
    float maxSpeed,
    float maxAngularSpeed,
    float jointHertz,
    float jointDampingRatio,
    boolean sleeping,
    float sleepSpeed,
    float sleepDelay,
    boolean continuous,
    float hitSpeed,
    boolean explicitEuler) {}

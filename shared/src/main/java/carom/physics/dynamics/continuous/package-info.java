/**
 * Continuous collision: stops fast bodies at what they would pass through within a step.
 *
 * <pre>
 *   solver bodies --FastBodies--&gt; flights --ImpactSearch--&gt; earliest impact --&gt; corrected pose
 *                                              |  trees of dynamics.pairs
 *                                              |  TargetMotion: where the target is meanwhile
 * </pre>
 *
 * <p>May import {@code dynamics.body}, {@code contact}, {@code pairs}, {@code solver} and {@code
 * store}, and the packages of shapes and collision. Read first: {@code ContinuousCollision}.
 */
package carom.physics.dynamics.continuous;

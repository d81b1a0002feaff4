/**
 * Joints as things of a simulation: their keys and definitions, by which clients mirror them, and
 * assemblies, which are several bodies and joints that belong together.
 *
 * <p>May import {@code carom.physics} and {@code carom.sim.level}. Read first: {@link
 * carom.sim.joint.JointTable}, {@link carom.sim.joint.AssemblyDef}, {@link
 * carom.sim.joint.Assembly}.
 */
package carom.sim.joint;

/**
 * The colours of a step's contacts: contacts of one colour share no body that can be moved.
 *
 * <p>May import {@code dynamics.body}, {@code contact}, {@code domain} and {@code jointtree}. Read
 * first: {@code ContactColours}.
 */
package carom.physics.dynamics.colour;

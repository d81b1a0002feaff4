/**
 * Contacts as constraints: coloured, packed, solved in lanes and by domains.
 *
 * <p>May import {@code carom.physics.simd} and {@code dynamics.body}, {@code contact}, {@code
 * pairs}, {@code domain}, {@code colour}, {@code jointtree} and {@code parallel}. Read first:
 * {@code ContactSolver} (what is solved), {@code ContactBlocks} (in which order, and where it
 * lies), {@code ScalarContacts} (the visits), {@code TreeContacts} (those of joint trees).
 */
package carom.physics.dynamics.solver;

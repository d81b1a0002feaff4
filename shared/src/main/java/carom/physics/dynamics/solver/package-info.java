/**
 * Contacts as constraints: coloured, packed, solved in lanes and by domains. Contacts of one colour
 * share no body that can be moved.
 *
 * <p>May import {@code carom.physics.settings} and {@code simd} and {@code dynamics.body}, {@code
 * contact}, {@code pairs}, {@code domain}, {@code jointtree} and {@code store}. Read first: {@code
 * ContactSolver} (what is solved), {@code ContactBlocks} (in which order, and where it lies),
 * {@code ScalarContacts} (the visits), {@code TreeContacts} (those of joint trees).
 */
package carom.physics.dynamics.solver;

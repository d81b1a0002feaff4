/**
 * Building blocks of the stores: slots that are reused, stamps that tell whether something changed,
 * arrays that copies share and rows that move in them, state hashes of columns, sorting by key.
 *
 * <p>May import {@code carom.physics.archive}, {@code math}, {@code simd} and {@code
 * dynamics.parallel}. Read first: {@code Slots}, {@code Stamp}, {@code ColumnHash}.
 */
package carom.physics.dynamics.store;

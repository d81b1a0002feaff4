/**
 * Building blocks of the stores: slots that are reused, stamps that tell whether something changed,
 * state hashes of columns, sorting by key.
 *
 * <p>May import {@code carom.physics.archive}, {@code math} and {@code simd}. Read first: {@code
 * Slots}, {@code Stamp}, {@code ColumnHash}.
 */
package carom.physics.dynamics.store;

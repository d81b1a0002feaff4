/**
 * Building blocks of the stages: slots that are reused, stamps that tell whether something changed,
 * arrays that copies share and rows that move in them, state hashes of columns, sorting by key, and
 * loops cut into pieces that the threads of a world share.
 *
 * <p>May import {@code carom.physics.archive}, {@code math}, {@code simd} and {@code threads}. Read
 * first: {@code Slots}, {@code Stamp}, {@code ColumnHash}, {@code ParallelFor}.
 */
package carom.physics.dynamics.store;

/**
 * The broadphase of a world: fat boxes, the tree of moving shapes and that of resting ones, and the
 * search for pairs.
 *
 * <p>May import {@code dynamics.body}, {@code contact} and {@code store}. Read first: {@code
 * PairFinder}, whose drawing shows the parts, {@code FatBoxes}, {@code PartTrees}.
 */
package carom.physics.dynamics.pairs;

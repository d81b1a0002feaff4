/**
 * The engine's vector kernels: each does for a block of contacts, joints, boxes or numbers what a
 * scalar class does one by one, with the same bits.
 *
 * <p>May import the packages of those classes and {@code jdk.incubator.vector}. Nothing refers to
 * these classes; they are found by name. Read first: {@code VectorContacts}.
 */
package carom.physics.dynamics.simd;

/**
 * Vector kernels: which ones this JVM can run, and how they are warmed up.
 *
 * <p>The kernels themselves need the incubating Vector API. They live in a source folder of their
 * own ({@code shared/src/vector}) and are found by name, so that this package and the whole engine
 * also work on a JVM without that module, with the same bits.
 *
 * <p>Imports nothing. Read first: {@code VectorModule}, {@code VectorKernels}, {@code
 * KernelWarmup}.
 */
package carom.physics.simd;

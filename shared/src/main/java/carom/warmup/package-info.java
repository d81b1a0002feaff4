/**
 * Warms the engine's vector kernels up in the background, for programs: a thread steps a world of
 * its own, which needs them all, while the program's worlds go on without vectors.
 *
 * <p>Allowed imports: {@code carom.physics}, {@code carom.physics.geometry}, {@code
 * carom.physics.simd}, {@code carom.net.codec}, the JDK.
 *
 * <p>Read first: {@link carom.warmup.KernelWarmupThread}.
 */
package carom.warmup;

/**
 * What several tests need: scenes, measurements, fakes. Not part of the product.
 *
 * <p>Allowed imports: everything. Read first: {@link carom.testkit.BroadphaseScene}, {@link
 * carom.testkit.BroadphaseBench}.
 */
package carom.testkit;

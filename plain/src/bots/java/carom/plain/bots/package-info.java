/**
 * Bots by stock KryoNet and Kryo, for {@code carom-bots --door plain}. They run in a class loader
 * of their own, beside Carom's Kryo 5.
 *
 * <p>Imports {@code carom.plain}.
 */
package carom.plain.bots;

package carom.net.transport;

import java.util.function.LongSupplier;

/**
 * A number that a transport counts, for the operator. It only grows.
 *
 * @param name lower case, words separated by dots
 * @param help what it counts, in a sentence
 * @param value returns the present value; any thread
 */
public record NetworkCounter(String name, String help, LongSupplier value) {}

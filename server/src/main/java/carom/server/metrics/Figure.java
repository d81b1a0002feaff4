package carom.server.metrics;

import java.util.function.DoubleSupplier;

/**
 * A number for the metrics.
 *
 * @param name lower case, words separated by dots
 * @param help what it tells, in a sentence
 * @param isGauge whether it may fall
 * @param value returns the present value; any thread
 */
public record Figure(String name, String help, boolean isGauge, DoubleSupplier value) {}

/**
 * Common parts of all rows of the benchmark: a job, its entrant, its time, and the row that comes
 * of it; and the line of a figure.
 *
 * <p>Imports Jackson and the JDK only. Read first: {@link carom.lab.measure.BenchJob}, {@link
 * carom.lab.measure.Measurement}, {@link carom.lab.measure.BenchRow}.
 */
package carom.lab.measure;

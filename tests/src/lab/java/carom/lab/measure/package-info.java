/**
 * What all rows of the benchmark have in common: a job, who does it, how long, and the row that
 * comes of it; and what a line of figures is.
 *
 * <p>Imports Jackson and the JDK only. Read first: {@link carom.lab.measure.BenchJob}, {@link
 * carom.lab.measure.Measurement}, {@link carom.lab.measure.BenchRow}.
 */
package carom.lab.measure;

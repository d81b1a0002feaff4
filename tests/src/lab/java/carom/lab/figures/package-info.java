/**
 * The figures that snapshots and prediction are measured by: {@code carom-bots figures}. Those of
 * the laboratory's own codec are in a table apart.
 *
 * <p>Here and not in the programs, since most of them need the server and its clients in one
 * process and one virtual time, which only the test kit has. Read first: {@link
 * carom.lab.figures.FiguresMain}, {@link carom.lab.measure.Figure}.
 */
package carom.lab.figures;

/** Looks into datagrams from inside the package that makes them, for the laboratory alone. */
package carom.net.snapshot;

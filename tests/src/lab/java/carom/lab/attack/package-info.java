/**
 * Attacks on a real server process over loopback, and the honest players that come meanwhile. See
 * docs/server/RELIABILITY.md.
 */
package carom.lab.attack;

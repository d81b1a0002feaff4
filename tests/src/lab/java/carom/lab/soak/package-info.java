/**
 * The soak: a whole server and its clients in virtual time, to which a seed does whatever can
 * happen in weeks. See docs/server/RELIABILITY.md.
 */
package carom.lab.soak;

/** Placeholder. */
package carom.server;

/** Placeholder. */
package carom.client;

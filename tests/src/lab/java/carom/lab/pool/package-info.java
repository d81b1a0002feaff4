/** Compares ways to bring water and sand to clients; see docs/lab/pools.md. */
package carom.lab.pool;

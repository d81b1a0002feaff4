/** Placeholder. */
package carom.physics.math;

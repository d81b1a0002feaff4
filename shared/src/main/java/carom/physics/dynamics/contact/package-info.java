/**
 * Contacts: a table with one row per pair of shapes that are close, in the order of their keys,
 * kept from step to step.
 *
 * <p>May import {@code dynamics.body} and {@code store}, and the packages of shapes and collision.
 * Read first: {@code ContactKey}, {@code ContactColumns} (the layout of a row), {@code
 * ContactTable}, {@code RowOrder}, {@code KeptManifolds}.
 */
package carom.physics.dynamics.contact;

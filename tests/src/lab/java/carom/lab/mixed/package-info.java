/**
 * Own clients, stock KryoNet and browsers' WebSocket in one room: what they show is compared with
 * the server's states.
 */
package carom.lab.mixed;

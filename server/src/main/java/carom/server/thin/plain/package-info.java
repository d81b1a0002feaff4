/**
 * The door for programs with stock KryoNet and its Kryo 2.24: a server transport whose links are
 * thin ones. It speaks their bytes by hand, see docs/protocol/THIN.md; nothing that a client sends
 * creates an object of a class that the client names.
 *
 * <pre>
 *   PlainDoor ──► PlainConnection ──► PlainDecoder ──► PlainLink: lobby and rooms
 *   (TCP, one thread)   ▲    ▲                            │
 *   DatagramPort (UDP) ─┘    └────── PlainEncoder ◄───────┘
 * </pre>
 *
 * <p>Imports {@code carom.server.thin}, {@code carom.net.admission}, {@code carom.net.frame},
 * {@code carom.net.protocol}, {@code carom.net.transport}, {@code carom.sim.entity}, the JDK.
 *
 * <p>Read first: {@link carom.server.thin.plain.PlainDoor}, {@link
 * carom.server.thin.plain.PlainDecoder}, {@link carom.server.thin.plain.PlainEncoder}.
 */
package carom.server.thin.plain;

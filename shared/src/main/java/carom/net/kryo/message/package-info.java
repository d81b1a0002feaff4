/**
 * Writes messages with Kryo: the fields that several have in common ({@link
 * carom.net.kryo.message.MessageSerializer}), and messages that came later.
 */
package carom.net.kryo.message;

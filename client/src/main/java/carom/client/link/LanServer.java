package carom.client.link;

/**
 * A server of the local network, as it described itself a moment ago. Immutable.
 *
 * @param address where to join it
 * @param status what it told
 * @param pingMs time from a question to its answer, ms
 */
public record LanServer(ServerAddress address, StatusAnswer status, int pingMs) {}

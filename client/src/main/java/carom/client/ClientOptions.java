package carom.client;

import carom.net.transport.Impairment;

/**
 * What the command line of {@code carom-client} asked for.
 *
 * @param config the client
 * @param impairment a bad network on purpose; {@code Impairment.NONE} for none
 * @param connectAtOnce whether the server was named: false shows the connect screen first
 * @param seconds leave after this time; 0 = when the player does
 */
public record ClientOptions(
    ClientConfig config, Impairment impairment, boolean connectAtOnce, double seconds) {}

package carom.testkit;

import java.util.List;

/**
 * Measures of how a game felt to its players on one network.
 *
 * @param network name of the network
 * @param players how many played
 * @param correctionsPerMinute how often the own body was put right, per player and minute
 * @param rightPercent share of the predictions of awake bodies that were right in every bit
 * @param kbitPerSecond payload that a client received, kbit/s
 * @param costs why clients shifted own bodies, the most frequent cause first
 * @param unexplained differences between client and server for which there is no reason: a fault of
 *     Carom, or a callback that does otherwise on client and server
 * @param firstUnexplained the first of them with player, tick and both values; may be empty
 * @param hash hash of all frames of the server
 */
record NetworkRun(
    String network,
    int players,
    double correctionsPerMinute,
    double rightPercent,
    double kbitPerSecond,
    List<Costs.Cost> costs,
    long unexplained,
    String firstUnexplained,
    long hash) {}

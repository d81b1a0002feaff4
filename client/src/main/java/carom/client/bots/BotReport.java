package carom.client.bots;

import java.util.Locale;

/**
 * Figures of a crowd of bots, over all their stays. Times and rates are means over the bots that
 * played; the times of a bot are means over its stays, weighted by their length.
 *
 * @param joined bots that got into the game
 * @param disconnects how often a bot that played lost its place without wanting to; one that comes
 *     back to it over another link hasn't
 * @param errors exceptions in bots, and datagrams that could not be decoded
 * @param snapshotsPerSecond server ticks seen per bot and second of play
 * @param gapP99Ms time between two snapshots that 99 % stay below, milliseconds
 * @param rttP50Ms median round trip, milliseconds; what the server held inputs back is not counted
 * @param kbitPerSecond payload received per bot and second of play, snapshots and messages, 1 kbit
 *     = 1,000 bits
 * @param playing bots that play at this moment
 * @param rejected bots that gave up getting in, or coming back after they had left
 * @param retries how often a bot had to try again to get in
 * @param kbitPerSecondUp payload sent per bot and second of play, inputs and messages
 * @param exactPercent of the awake bodies near the bots, those whose prediction was right in every
 *     bit; 0 when nothing was predicted
 * @param correctionsPerMinute how often a bot's own body had to be corrected
 * @param lateInputPercent share of the inputs of playing bots that were sampled later than their
 *     tick, because the bots' own process was too slow to look after each of them in each tick
 * @param longestGapMs longest time without a snapshot of any bot that had joined and wanted to
 *     play, milliseconds
 * @param redirects how often servers have sent bots to other servers
 * @param ticksLost ticks that bots have seen and that never happened, because a server was lost
 * @param keyP50Ms of thin clients, median time from an input to the first snapshot that has used
 *     it, milliseconds; 0 of own clients, which predict
 * @param reconnects how often a bot has gone on over another link, because one was lost or another
 *     server had the room
 */
record BotReport(
    int joined,
    int disconnects,
    int errors,
    double snapshotsPerSecond,
    double gapP99Ms,
    double rttP50Ms,
    double kbitPerSecond,
    int playing,
    int rejected,
    int retries,
    double kbitPerSecondUp,
    double exactPercent,
    double correctionsPerMinute,
    double lateInputPercent,
    double longestGapMs,
    int redirects,
    int ticksLost,
    double keyP50Ms,
    int reconnects) {
  /** Returns one line of JSON with the keys in the order above. */
  public String toJson() {
    return String.format(
        Locale.ROOT,
        "{\"joined\":%d,\"disconnects\":%d,\"errors\":%d,\"snapshotsPerSecond\":%.2f,"
            + "\"gapP99Ms\":%.2f,\"rttP50Ms\":%.2f,\"kbitPerSecond\":%.2f,\"playing\":%d,"
            + "\"rejected\":%d,\"retries\":%d,\"kbitPerSecondUp\":%.2f,"
            + "\"exactPercent\":%.2f,\"correctionsPerMinute\":%.2f,"
            + "\"lateInputPercent\":%.2f,\"longestGapMs\":%.2f,\"redirects\":%d,"
            + "\"ticksLost\":%d,\"keyP50Ms\":%.2f,\"reconnects\":%d}",
        joined,
        disconnects,
        errors,
        snapshotsPerSecond,
        gapP99Ms,
        rttP50Ms,
        kbitPerSecond,
        playing,
        rejected,
        retries,
        kbitPerSecondUp,
        exactPercent,
        correctionsPerMinute,
        lateInputPercent,
        longestGapMs,
        redirects,
        ticksLost,
        keyP50Ms,
        reconnects);
  }
}

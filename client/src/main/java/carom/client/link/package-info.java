/**
 * The way into a game and back: opens the link, says hello, downloads the level, notices a dead
 * line, and reconnects. {@link carom.client.link.LanSearch} asks for servers of the local network
 * by A2S status queries that are broadcast, and reads the answers, which anybody may have written.
 *
 * <p>Imports {@code carom.net.protocol}, {@code carom.net.transport}, {@code carom.sim}, {@code
 * carom.text} and {@code carom.client.stats}. One thread, besides that of {@code LanSearch}. Read
 * first: {@link carom.client.link.Connection}, {@link carom.client.link.LevelDownload}, {@link
 * carom.client.link.ConnectionPhase}.
 */
package carom.client.link;

/**
 * The way into a game and back: opens the link, says hello, downloads the level, notices a dead
 * line, and reconnects.
 *
 * <p>Imports {@code carom.net.protocol}, {@code carom.net.transport}, {@code carom.sim} and {@code
 * carom.client.stats}. One thread. Read first: {@link carom.client.link.Connection}, {@link
 * carom.client.link.LevelDownload}, {@link carom.client.link.ConnectionPhase}.
 */
package carom.client.link;

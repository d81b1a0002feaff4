/**
 * Recordings: a client that plays a recorded game into a view, and a spectator that fetches the
 * recording of a game that is being played.
 *
 * <p>Imports {@code carom.client}, {@code carom.client.view}, {@code carom.replay}, {@code
 * carom.net..} and {@code carom.sim}. Read first: {@link carom.client.replay.ReplayClient}, {@link
 * carom.client.replay.RecordingDownload}, {@link carom.client.replay.SpectatorThread}.
 */
package carom.client.replay;

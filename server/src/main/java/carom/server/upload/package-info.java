/**
 * Levels of players: what accounts send, checked in a process of its own, kept by hash in the data
 * folder, and played by name.
 *
 * <p>Read first: {@link carom.server.upload.Uploads}, {@link carom.server.upload.LevelTrial},
 * {@link carom.server.upload.UploadStore}. May import levels, the check of {@code
 * carom.server.level}, {@code carom.server.match}, and names and limits of {@code
 * carom.net.protocol}.
 */
package carom.server.upload;

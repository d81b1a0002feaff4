/**
 * Sounds of events: which ones play, how loud and from which side, and the device that plays them.
 *
 * <p>Imports {@code carom.client.events} and {@code carom.sim}. Render thread only. Read first:
 * {@link carom.client.desktop.sound.EventSounds}, {@link carom.client.desktop.sound.Speaker},
 * {@link carom.client.desktop.sound.Waves}.
 */
package carom.client.desktop.sound;

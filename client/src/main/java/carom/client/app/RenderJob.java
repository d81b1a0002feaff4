package carom.client.app;

import java.nio.file.Path;

/**
 * A clip of a recording, to be drawn picture by picture.
 *
 * @param recording what {@code carom-server --record} has written
 * @param folder where the pictures go: {@code frame-00000.png} and so on
 * @param fromSeconds time in the game at which the clip begins, at least 0
 * @param seconds length of the clip, seconds of film; 0 = to the end of the recording
 * @param framesPerSecond pictures of a second of film, 1..240
 * @param width of the pictures, 160..7,680 px
 * @param height of the pictures, 120..4,320 px
 * @param speedSteps doublings of the speed, -4..4; negative for slow motion
 * @param follow name of the player in the middle of the picture; empty for nobody
 */
public record RenderJob(
    Path recording,
    Path folder,
    double fromSeconds,
    double seconds,
    int framesPerSecond,
    int width,
    int height,
    int speedSteps,
    String follow) {}

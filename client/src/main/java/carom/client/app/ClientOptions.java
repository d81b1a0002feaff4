package carom.client.app;

import carom.client.ClientConfig;
import carom.client.replay.SpectatorThread;
import carom.client.settings.SettingsFile;
import carom.net.frame.Trust;
import carom.net.transport.Impairment;
import carom.sim.scene.Scene;
import java.nio.file.Path;

/**
 * Options from the command line of {@code carom-client}, for a window.
 *
 * @param config server, player and settings
 * @param impairment a simulated bad network; {@code Impairment.NONE} for none
 * @param trust what a server must be like
 * @param connectAtOnce whether the server was named; false shows the start screen first
 * @param seconds leave after this time; 0 = when the player does
 * @param netGraph whether the window starts with the net graph shown ({@code --net-graph})
 * @param debug whether the window starts with debug drawing ({@code --debug})
 * @param screenshot PNG file for the window's last picture, written when {@code seconds} are over
 *     ({@code --screenshot FILE}); empty = none
 * @param volume of the loudest sound, 0..100 ({@code --volume}); 0 = silent, -1 = as in the
 *     settings
 * @param settings the player's settings, loaded
 * @param named whether the player's name was given ({@code --name}), and that of the settings
 *     doesn't count
 * @param replay a recording to show instead of playing ({@code --replay FILE}); null to play
 * @param spectator the download by which that recording grows ({@code --watch}), which is shown
 *     from its end on; null for a whole recording
 * @param scene a scene to show instead of playing ({@code --scene NAME}); null to play
 * @param here a game to start on this machine ({@code --here LEVEL}); null for none
 * @param edit a level file to edit instead of playing ({@code --edit FILE}); null to play
 * @param bots players of the machine that play along on what is edited ({@code --bots N})
 */
public record ClientOptions(
    ClientConfig config,
    Impairment impairment,
    Trust trust,
    boolean connectAtOnce,
    double seconds,
    boolean netGraph,
    boolean debug,
    String screenshot,
    int volume,
    SettingsFile settings,
    boolean named,
    Path replay,
    SpectatorThread spectator,
    Scene scene,
    LocalGames.GameChoice here,
    Path edit,
    int bots) {}

package carom.client.desktop.hud;

import carom.client.view.ClientView;
import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.ServerMessage.RosterEntry;
import carom.sim.message.PlayerColour;
import java.util.Arrays;

/**
 * The colours by which a picture tells players apart: those they have chosen. In a game without
 * teams the others get one each that nobody else has, as far as there are enough, and the same on
 * all machines. Render thread only; no allocation per picture.
 */
public final class PlayerColours {
  private static final int COLOURS = PlayerColour.values().length;

  private final ShownGame game;
  private final int[] numbers = new int[ProtocolLimits.MAX_PLAYERS];
  private final boolean[] taken = new boolean[COLOURS];

  /** Creates colours without players. The game stays the property of the caller. */
  public PlayerColours(ShownGame game) {
    this.game = game;
  }

  /** Looks at the players of a picture. */
  public void look(ClientView view) {
    Arrays.fill(numbers, PlayerColour.OF_THE_GAME.number());
    Arrays.fill(taken, false);
    for (int i = 0; i < view.players().size(); i++) {
      RosterEntry entry = view.players().get(i);
      int number = PlayerColour.of(entry.colour()).number();
      numbers[entry.playerId()] = number;
      taken[number] |= !entry.spectator();
    }
    if (game.teamCount() > 0 || !game.hasPlayersColours()) {
      return;
    }
    for (int i = 0; i < view.players().size(); i++) {
      RosterEntry entry = view.players().get(i);
      boolean chose = numbers[entry.playerId()] != PlayerColour.OF_THE_GAME.number();
      if (!chose && !entry.spectator()) {
        int free = free(entry.playerId());
        numbers[entry.playerId()] = free;
        taken[free] = true;
      }
    }
  }

  /** Returns the first colour from that of an id on that nobody has; that of the id if all do. */
  private int free(int id) {
    for (int i = 0; i < COLOURS - 1; i++) {
      int number = 1 + (id + i) % (COLOURS - 1);
      if (!taken[number]) {
        return number;
      }
    }
    return 1 + id % (COLOURS - 1);
  }

  /** Returns a player's colour, 0xRRGGBB; -1 if its body looks as the game made it. */
  public int rgb(int playerId) {
    boolean known = playerId >= 0 && playerId < numbers.length;
    return known ? PlayerColour.of(numbers[playerId]).rgb() : PlayerColour.OF_THE_GAME.rgb();
  }
}

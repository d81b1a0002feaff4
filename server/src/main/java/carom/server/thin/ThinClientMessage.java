package carom.server.thin;

import java.util.List;
import java.util.Map;

/**
 * A message from a thin client to the server, see docs/protocol/THIN.md. Each door decodes it in
 * its own form and checks sizes; what the values mean is checked where they are used.
 */
public sealed interface ThinClientMessage {
  /** The largest number of inputs in an {@link Input}. */
  int MAX_INPUTS = 3;

  /**
   * Asks for a seat: the first message of a client.
   *
   * @param version {@link ThinLink#VERSION} of the client
   * @param name the player's name
   * @param room name of the room; empty for any
   * @param game name of the game that the player wants if the room is any; empty for any
   * @param party name of the party whose members the player wants to be with if the room is any;
   *     empty for none
   * @param token join token of the operator's own backend; empty for none
   * @param password the server's password; empty for none
   * @param secret that of an earlier {@link ThinServerMessage.Welcome}, to take the seat again; 0
   *     for none
   * @param digest digest of the classes of the game's messages that the client has; empty for none
   */
  record Join(
      int version,
      String name,
      String room,
      String game,
      String party,
      String token,
      String password,
      long secret,
      String digest)
      implements ThinClientMessage {
    /** Leaves out what lets its bearer in. */
    @Override
    public String toString() {
      return "Join[name=" + name + ", room=" + room + ", game=" + game + "]";
    }
  }

  /**
   * Carries the player's newest inputs. The server uses the newest at its next tick and repeats it
   * until another comes. A press that only an older input holds isn't lost: the server uses each
   * input that it hasn't seen for one tick, as long as they aren't too many.
   *
   * @param count the client's own count of its inputs, one more for each; that of the first below
   * @param seenTick tick of the newest snapshot of which the client has all parts; -1 for none
   * @param inputs 1..{@value #MAX_INPUTS} inputs as {@code carom.sim.entity.Input} packs them, the
   *     newest first; owned by the message
   */
  @SuppressWarnings("ArrayRecordComponent") // The receiver reads it at once.
  record Input(int count, int seenTick, long[] inputs) implements ThinClientMessage {}

  /** Says a text, to the own team alone or to all. */
  record Chat(String text, boolean team) implements ThinClientMessage {}

  /** Shows an emote, by the name of its constant in {@code carom.sim.message.Emote}. */
  record Emote(String emote) implements ThinClientMessage {}

  /**
   * Chooses; null where nothing changes.
   *
   * @param team number of the wanted team
   * @param role {@code PLAYER} or {@code SPECTATOR}
   * @param ready whether the player is ready
   * @param colour name of a constant of {@code carom.sim.message.PlayerColour}
   * @param room name of the room to go to
   */
  record Choose(Integer team, String role, Boolean ready, String colour, String room)
      implements ThinClientMessage {}

  /** Asks for a rate of snapshots, 5..60 a second; what is outside is cut. */
  record Rate(int perSecond) implements ThinClientMessage {}

  /**
   * Says what the client shows, as far as the server doesn't tell it everything.
   *
   * @param x centre while the player has no body, metres
   * @param y centre while the player has no body, metres
   * @param halfWidth half the width of the picture, metres
   * @param halfHeight half the height of the picture, metres
   */
  record View(float x, float y, float halfWidth, float halfHeight) implements ThinClientMessage {}

  /** Asks which rooms there are; before {@link Join} or while playing. */
  record ListRooms() implements ThinClientMessage {}

  /** Asks for the best of what accounts keep in the game. */
  record ListBest() implements ThinClientMessage {}

  /**
   * Carries a message of the game.
   *
   * @param kind name of its kind
   * @param values by the names of its arguments: Number, Boolean or String; a choice is the name of
   *     its constant
   */
  record Custom(String kind, Map<String, Object> values) implements ThinClientMessage {
    /** Copies the map. */
    public Custom {
      values = Map.copyOf(values);
    }

    /** Creates a message without values. */
    public Custom(String kind) {
      this(kind, Map.of());
    }
  }

  /** Carries nothing, but tells that the client is there. */
  record Alive() implements ThinClientMessage {}

  /** Leaves; the server keeps no place. */
  record Leave() implements ThinClientMessage {}

  /** The names of all messages, as they are in every form. */
  List<String> NAMES =
      List.of(
          "join", "input", "chat", "emote", "choose", "rate", "view", "rooms", "best", "custom",
          "alive", "leave");
}

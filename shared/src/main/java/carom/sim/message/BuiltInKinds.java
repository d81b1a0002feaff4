package carom.sim.message;

import java.util.List;

/**
 * The kinds of messages that every game has: chat, emotes, and what a player asks of the roster.
 * They come before the game's own kinds.
 */
public final class BuiltInKinds {
  /** Longest line of chat, in characters. */
  public static final int MAX_CHAT = 120;

  /** The {@code player} of {@link #SAID} that means the server. */
  public static final int SERVER = -1;

  private static final int LAST_PLAYER = 1_023;

  /** A player says a {@code text}, to its {@code team} alone or to all. */
  public static final MessageKind SAY =
      MessageKind.named("carom.say").fromClient().atMost(2).flag("team").text("text", MAX_CHAT);

  /** A {@code player} has said a {@code text}, to its {@code team} alone or to all. */
  public static final MessageKind SAID =
      MessageKind.named("carom.said")
          .fromServer()
          .count("player", SERVER, LAST_PLAYER)
          .flag("team")
          .text("text", MAX_CHAT);

  /** A player shows an {@code emote}. */
  public static final MessageKind EMOTE =
      MessageKind.named("carom.emote").fromClient().atMost(2).choice("emote", Emote.class);

  /** A {@code player} shows an {@code emote}. */
  public static final MessageKind EMOTED =
      MessageKind.named("carom.emoted")
          .fromServer()
          .count("player", 0, LAST_PLAYER)
          .choice("emote", Emote.class);

  /** A player says whether it is ready. */
  public static final MessageKind READY =
      MessageKind.named("carom.ready").fromClient().atMost(4).flag("ready");

  /** A player asks for a {@code role}. */
  public static final MessageKind ROLE =
      MessageKind.named("carom.role").fromClient().atMost(1).choice("role", PlayerRole.class);

  /** A player asks for a {@code team}. */
  public static final MessageKind TEAM =
      MessageKind.named("carom.team").fromClient().atMost(1).count("team", 0, 255);

  /** A player chooses the {@code colour} of its body. */
  public static final MessageKind COLOUR =
      MessageKind.named("carom.colour").fromClient().atMost(4).choice("colour", PlayerColour.class);

  static final List<MessageKind> ALL = List.of(SAY, SAID, EMOTE, EMOTED, READY, ROLE, TEAM, COLOUR);

  private BuiltInKinds() {}
}

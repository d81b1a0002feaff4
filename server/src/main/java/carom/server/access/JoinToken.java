package carom.server.access;

/**
 * The facts about a player that the operator's own backend has signed in a token.
 *
 * @param account the backend's name of the player's account, never empty
 * @param name the name to play under, or empty for the one that the player asks for
 * @param room the room to play in, or empty for the one that the player asks for
 */
public record JoinToken(String account, String name, String room) {}

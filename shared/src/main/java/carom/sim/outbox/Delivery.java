package carom.sim.outbox;

import carom.physics.math.Limits;
import carom.sim.entity.Entity;
import carom.sim.entity.Player;
import carom.sim.message.Message;

/**
 * A message of the game on its way to clients, begun by {@code Simulation.send}. Without a call of
 * {@code to} no player gets it. It never matters to the simulation.
 */
public final class Delivery {
  /** The recipients of a message. */
  public enum Recipients {
    /** The message goes to nobody. */
    NOBODY,
    /** The message goes to the participant {@link Delivery#id}. */
    ONE,
    /** The message goes to the participants of the team {@link Delivery#id}. */
    TEAM,
    /** The message goes to all participants. */
    ALL,
    /**
     * The message goes to the participants who look at the entity {@link Delivery#id} and may know
     * it.
     */
    NEAR
  }

  private final Message message;
  private Recipients recipients = Recipients.NOBODY;
  private int id;

  Delivery(Message message) {
    this.message = Limits.notNull("message", message);
  }

  /** Sends the message to one player. */
  public void to(Player player) {
    address(Recipients.ONE, Limits.notNull("player", player).id());
  }

  /** Sends the message to all players of a team. */
  public void toTeam(int team) {
    address(Recipients.TEAM, team);
  }

  /** Sends the message to all players. */
  public void toAll() {
    address(Recipients.ALL, 0);
  }

  /** Sends the message to all players who look at the place of an entity and may know it. */
  public void toNear(Entity entity) {
    address(Recipients.NEAR, Limits.notNull("entity", entity).id());
  }

  private void address(Recipients recipients, int id) {
    this.recipients = recipients;
    this.id = id;
  }

  /** Returns the message. */
  public Message message() {
    return message;
  }

  /** Returns who gets it. */
  public Recipients recipients() {
    return recipients;
  }

  /** Returns the id of a player or an entity, or a team, see {@link #recipients}. */
  public int id() {
    return id;
  }
}

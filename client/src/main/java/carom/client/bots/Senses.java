package carom.client.bots;

import carom.client.field.FieldView;
import carom.client.view.ClientView;
import carom.physics.math.SimRandom;

/**
 * The picture that a {@link BotBrain}'s player would see, at the present tick. It is read on the
 * bot's thread, while the brain decides.
 */
public final class Senses {
  private final SimRandom random;
  private ClientView view;
  private ClientView.Drawn own;
  private int tick;

  Senses(SimRandom random) {
    this.random = random;
  }

  /** Looks at the picture; returns whether the bot has a body in it. */
  boolean look(ClientView seen, int now) {
    view = seen;
    tick = now;
    own = seen.own();
    return own != null;
  }

  /** Returns the whole picture: entities, level, players, fields, scores. Don't change it. */
  public ClientView view() {
    return view;
  }

  /** Returns the tick that the input is for. Ticks ascend; each comes once in a match. */
  public int tick() {
    return tick;
  }

  /** Returns the bot's own body. Don't keep it. */
  public ClientView.Drawn own() {
    return own;
  }

  /** Returns the fields of the bot's player that a player may know. */
  public FieldView player() {
    return view.player(view.playerId());
  }

  /** Returns random numbers of the bot's own; equal seeds repeat them. */
  public SimRandom random() {
    return random;
  }

  /**
   * Returns the nearest visible entity of an archetype, or null. The own body is left out.
   *
   * @param archetype its name, as the game or the level registered it
   */
  public ClientView.Drawn nearest(String archetype) {
    ClientView.Drawn best = null;
    float bestDistance = Float.MAX_VALUE;
    for (int i = 0; i < view.entityCount(); i++) {
      ClientView.Drawn drawn = view.entity(i);
      if (drawn.id() != own.id() && drawn.archetype().name().equals(archetype)) {
        float distance = distance(drawn);
        if (distance < bestDistance) {
          best = drawn;
          bestDistance = distance;
        }
      }
    }
    return best;
  }

  /** Returns the distance between the own body and another, metres. */
  public float distance(ClientView.Drawn other) {
    return (float) Math.hypot(other.x() - own.x(), other.y() - own.y());
  }

  /** Returns the direction from the own body to another, radians, as {@code Input.aim} takes it. */
  public float direction(ClientView.Drawn other) {
    return (float) Math.atan2(other.y() - own.y(), other.x() - own.x());
  }

  /**
   * Returns whether static geometry of the level is in the way.
   *
   * @param dx x of the way from the own body, metres
   * @param dy y of the way from the own body, metres
   */
  public boolean isWall(float dx, float dy) {
    return view.isWall(own.x(), own.y(), dx, dy);
  }
}

package carom.client.look;

import carom.physics.math.Limits;
import carom.sim.field.Field;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * The part of the level that the window shows. Without a view's word it is the whole level if that
 * fits at a readable size, or else 16 m of it around the player. Each method changes it and returns
 * it.
 *
 * <pre>{@code
 * v.camera().height(18).lead(0.35f);        // a chase
 * v.camera().height(14).framesAll();        // a duel
 * v.camera().zone("cave").whileSet(SCOPE, 40);
 * }</pre>
 */
public final class CameraSetup {
  private float height;
  private float leadSeconds;
  private boolean framesAll;
  private final List<String> zones = new ArrayList<>();
  private ShownValue condition;
  private float otherHeight;

  CameraSetup() {}

  /** Sets the height that it shows while it follows a player, 4..200 metres. */
  public CameraSetup height(float metres) {
    height = Range.check("a camera's height", metres, 4, 200);
    return this;
  }

  /** Looks ahead to where the player will be in 0..2 seconds at the present velocity. */
  public CameraSetup lead(float seconds) {
    leadSeconds = Range.check("a camera's lead", seconds, 0, 2);
    return this;
  }

  /** Keeps the bodies of all players in the picture; {@link #height} is then the least. */
  public CameraSetup framesAll() {
    framesAll = true;
    return this;
  }

  /**
   * Shows the level's zones of this name whole: each while the player is in it, in place of what is
   * around the player.
   */
  public CameraSetup zone(String name) {
    Range.check("a camera's zones", zones.size() + 1, 1, ViewSetup.MAX);
    zones.add(Limits.notNull("name", name));
    return this;
  }

  /**
   * Shows another height, 4..200 metres, while a field is other than 0: that of a scope, or of a
   * fast ride. A later call takes the place of an earlier one.
   */
  public CameraSetup whileSet(Field<?> field, float metres) {
    Range.check("a camera's height", metres, 4, 200);
    condition = ShownValue.of(field);
    otherHeight = metres;
    return this;
  }

  /** Returns the height that it shows, metres; 0 for the usual. */
  public float height() {
    return height;
  }

  /** Returns how far ahead it looks, seconds of the player's way. */
  public float leadSeconds() {
    return leadSeconds;
  }

  /** Returns whether it keeps all players in the picture. */
  public boolean isFramingAll() {
    return framesAll;
  }

  /** Returns the names of zones that it shows whole, unmodifiable. */
  public List<String> zones() {
    return Collections.unmodifiableList(zones);
  }

  /** Returns the value that makes it show {@link #otherHeight}; null if none does. */
  public ShownValue condition() {
    return condition;
  }

  /** Returns the height that it shows while the condition holds, metres. */
  public float otherHeight() {
    return otherHeight;
  }

  /** Returns whether the height that it shows changes, smoothly, while one plays. */
  public boolean isZooming() {
    return framesAll || condition != null || !zones.isEmpty();
  }
}

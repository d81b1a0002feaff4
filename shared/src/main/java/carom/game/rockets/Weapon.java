package carom.game.rockets;

/** A weapon, and what its shots do. Players begin with the first. */
public enum Weapon {
  /** Never empty: flies straight on, and goes off when it hits or its player says so. */
  ROCKET(0.5f, 1, 20, 0, 2, 45, 3, 9, 0, 0),
  /** A fan of small bolts that don't fly far. */
  SCATTER(0.7f, 5, 26, 0.3f, 0.5f, 24, 1.4f, 5, 5, 8),
  /** Starts slowly, becomes faster and faster, and goes off over a wide place. */
  TORPEDO(1.2f, 1, 6, 0, 3, 85, 4.5f, 13, 3, 3),
  /** Lies behind its player and waits for a ship, a rock or a crate. */
  MINES(0.6f, 1, 5, 0, 18, 75, 4, 13, 0, 4);

  /** Time from shot to shot, seconds. */
  public final float seconds;

  /** Number of shots that fly at once. */
  public final int shots;

  /** Speed at which a shot begins, m/s. */
  public final float speed;

  /** Largest angle between a shot and the aim, radians. */
  public final float spread;

  /** Time until a shot goes off by itself, seconds. */
  public final float flight;

  /** Damage in the middle of its blast; it falls to 0 at the edge. */
  public final int damage;

  /** Radius of its blast, metres. */
  public final float radius;

  /** Speed at which the middle of its blast throws what is there, m/s. */
  public final float kick;

  /** Speed at which a shot throws its own player back, m/s. */
  public final float recoil;

  /** Number of shots in a pick-up; 0 = endless. */
  public final int ammo;

  Weapon(
      float seconds,
      int shots,
      float speed,
      float spread,
      float flight,
      int damage,
      float radius,
      float kick,
      float recoil,
      int ammo) {
    this.seconds = seconds;
    this.shots = shots;
    this.speed = speed;
    this.spread = spread;
    this.flight = flight;
    this.damage = damage;
    this.radius = radius;
    this.kick = kick;
    this.recoil = recoil;
    this.ammo = ammo;
  }
}

package carom.game.shooter;

/** A weapon, and what its shots do. Players begin with the first. */
public enum Weapon {
  /** Never empty. */
  PISTOL(0.26f, 1, 34, 0.02f, 0.8f, 8, 5, 1, 0),
  /** A fan of pellets that don't fly far. */
  SHOTGUN(0.75f, 6, 30, 0.28f, 0.3f, 5, 3.2f, 6, 10),
  /** Fast and inexact. */
  RIFLE(0.1f, 1, 40, 0.1f, 0.7f, 4, 3, 0.8f, 40),
  /** A rocket that goes off where it hits. */
  LAUNCHER(0.9f, 1, 21, 0, 2, 42, 15, 5, 5);

  /** Radius of a launcher's blast, metres. */
  public static final float BLAST_RADIUS = 3.2f;

  /** Time from shot to shot, seconds. */
  public final float seconds;

  /** Number of shots that fly at once. */
  public final int shots;

  /** Speed of a shot, m/s. */
  public final float speed;

  /** Largest angle by which a shot misses the aim, radians. */
  public final float spread;

  /** Time that a shot flies at most, seconds. */
  public final float flight;

  /** Damage of one shot, of {@link ShooterFields#DAMAGE}. */
  public final int damage;

  /** Speed at which a shot throws a player who is halfway out, m/s. */
  public final float kick;

  /** Speed at which it throws its own player back, m/s. */
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
      float kick,
      float recoil,
      int ammo) {
    this.seconds = seconds;
    this.shots = shots;
    this.speed = speed;
    this.spread = spread;
    this.flight = flight;
    this.damage = damage;
    this.kick = kick;
    this.recoil = recoil;
    this.ammo = ammo;
  }

  /** Returns whether its shots go off as a blast. */
  public boolean blasts() {
    return this == LAUNCHER;
  }
}

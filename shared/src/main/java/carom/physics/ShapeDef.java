package carom.physics;

import carom.physics.geometry.Shape;

/**
 * A shape of a body with its material and its filter. It is immutable.
 *
 * <p>A <b>sensor</b> pushes nothing. The {@link CollisionListener} is called when a shape enters it
 * ({@code begin}) and leaves it ({@code end}), and {@link Body#forEachOverlap} visits the bodies
 * inside. A sensor notices solid shapes of dynamic bodies; on a dynamic body it notices all solid
 * shapes. Sensors don't notice each other. They add mass according to their density.
 *
 * @param shape the shape, in the body frame
 * @param material the shape's material
 * @param filter says what the shape collides with
 * @param sensor true if the shape is a sensor
 * @param user object that the shape stands for in the using program, such as a part of a vehicle;
 *     may be null; no part of a world's state
 */
public record ShapeDef(Shape shape, Material material, Filter filter, boolean sensor, Object user) {

  /**
   * Makes a definition and checks that nothing but the user is null.
   *
   * @throws IllegalArgumentException if another argument is null
   */
  public ShapeDef {
    if (shape == null || material == null || filter == null) {
      throw new IllegalArgumentException(
          "shape=" + shape + " material=" + material + " filter=" + filter + " must not be null");
    }
  }

  /**
   * Makes the definition of a shape that stands for nothing.
   *
   * @param shape the shape, in the body frame
   * @param material the shape's material
   * @param filter says what the shape collides with
   * @param sensor true if the shape is a sensor
   */
  public ShapeDef(Shape shape, Material material, Filter filter, boolean sensor) {
    this(shape, material, filter, sensor, null);
  }

  /**
   * Makes the definition of a solid shape with {@link Filter#DEFAULT}.
   *
   * @param shape the shape, in the body frame
   * @param material the shape's material
   */
  public ShapeDef(Shape shape, Material material) {
    this(shape, material, Filter.DEFAULT, false);
  }

  /**
   * Makes the definition of a solid shape with {@link Material#DEFAULT} and {@link Filter#DEFAULT}.
   *
   * @param shape the shape, in the body frame
   */
  public ShapeDef(Shape shape) {
    this(shape, Material.DEFAULT);
  }

  /**
   * Returns a copy with another material.
   *
   * @param newMaterial the new material
   * @return a changed copy
   */
  public ShapeDef withMaterial(Material newMaterial) {
    return new ShapeDef(shape, newMaterial, filter, sensor, user);
  }

  /**
   * Returns a copy with another filter.
   *
   * @param newFilter the new filter
   * @return a changed copy
   */
  public ShapeDef withFilter(Filter newFilter) {
    return new ShapeDef(shape, material, newFilter, sensor, user);
  }

  /**
   * Returns a copy that is a sensor or solid.
   *
   * @param isSensor true for a sensor, false for a solid shape
   * @return a changed copy
   */
  public ShapeDef withSensor(boolean isSensor) {
    return new ShapeDef(shape, material, filter, isSensor, user);
  }

  /**
   * Returns a copy that stands for another object of the using program.
   *
   * @param newUser the object, may be null
   * @return a changed copy
   */
  public ShapeDef withUser(Object newUser) {
    return new ShapeDef(shape, material, filter, sensor, newUser);
  }
}

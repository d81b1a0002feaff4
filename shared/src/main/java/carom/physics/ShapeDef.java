package carom.physics;

import carom.physics.geometry.Shape;

/**
 * A shape of a body with what it is made of and whom it meets; immutable.
 *
 * <p>A <b>sensor</b> pushes nothing: the listener hears when something enters it ({@code begin})
 * and leaves it ({@code end}), and {@link Body#forEachOverlap} names what is inside. Sensors notice
 * dynamic bodies' solid shapes, or, on dynamic bodies, all solid shapes; they don't notice each
 * other. They weigh what their density says.
 *
 * @param shape in the body frame
 * @param material what it is made of
 * @param filter whom it meets
 * @param sensor whether it only notices
 */
public record ShapeDef(Shape shape, Material material, Filter filter, boolean sensor) {

  /**
   * Checks that nothing is missing.
   *
   * @throws IllegalArgumentException naming what is null
   */
  public ShapeDef {
    if (shape == null || material == null || filter == null) {
      throw new IllegalArgumentException(
          "shape=" + shape + " material=" + material + " filter=" + filter + " must not be null");
    }
  }

  /**
   * A solid shape that meets everything.
   *
   * @param shape in the body frame
   * @param material what it is made of
   */
  public ShapeDef(Shape shape, Material material) {
    this(shape, material, Filter.DEFAULT, false);
  }

  /**
   * A solid shape of {@link Material#DEFAULT} that meets everything.
   *
   * @param shape in the body frame
   */
  public ShapeDef(Shape shape) {
    this(shape, Material.DEFAULT);
  }

  /**
   * The same of another material.
   *
   * @param newMaterial what it is made of
   * @return a changed copy
   */
  public ShapeDef withMaterial(Material newMaterial) {
    return new ShapeDef(shape, newMaterial, filter, sensor);
  }

  /**
   * The same with another filter.
   *
   * @param newFilter whom it meets
   * @return a changed copy
   */
  public ShapeDef withFilter(Filter newFilter) {
    return new ShapeDef(shape, material, newFilter, sensor);
  }

  /**
   * The same, as a sensor or solid.
   *
   * @param isSensor whether it only notices
   * @return a changed copy
   */
  public ShapeDef withSensor(boolean isSensor) {
    return new ShapeDef(shape, material, filter, isSensor);
  }
}

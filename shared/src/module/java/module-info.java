/**
 * A deterministic 2D rigid-body engine, bit-exact on every platform. It needs nothing but a JDK.
 *
 * <p>Start with {@link carom.physics.World}. Packages that aren't exported, {@code dynamics} and
 * {@code simd}, are how the engine works inside, and change without notice.
 *
 * <p>If the JVM is started with {@code --add-modules jdk.incubator.vector}, the engine solves
 * contacts and joints side by side by vectors, with the same bits.
 */
module carom.physics {
  requires static jdk.incubator.vector;

  exports carom.physics;
  exports carom.physics.archive;
  exports carom.physics.broadphase;
  exports carom.physics.collision;
  exports carom.physics.effects;
  exports carom.physics.geometry;
  exports carom.physics.math;
  exports carom.physics.mover;
  exports carom.physics.particles;
  exports carom.physics.profile;
  exports carom.physics.rows;
  exports carom.physics.settings;
  exports carom.physics.threads;
}

package carom.server;

import carom.net.codec.Quantizer;
import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.JointDef;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.WorldState;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import java.util.ArrayList;
import java.util.List;

/**
 * A world that needs every set of vector kernels: boxes and discs fall into a pit, and a net of
 * hinges swings above them. When it has come to rest, it begins again, as the same object: each new
 * world would be kept long enough by the collector to take memory for good. One thread at a time.
 */
final class Rehearsal {
  private static final float TICK_S = 1 / 60f;

  /** Steps until the pile sleeps, about. */
  private static final int STEPS = 240;

  /**
   * Number of columns of the pile; with the net, more than 512 bodies, because kernels hash no
   * shorter columns.
   */
  private static final int COLUMNS = 16;

  private static final int ROWS = 24;
  private static final int NET = 12;

  /** Length of the quantised columns. */
  private static final int NUMBERS = 1024;

  private final float[] cos = new float[NUMBERS];
  private final float[] sin = new float[NUMBERS];
  private final int[] quantised = new int[NUMBERS];

  private final World<Object> world = new World<>(new WorldDef());
  private final WorldState begin;
  private int steps;

  /** Makes the world and its first step, by which the JVM loads all sets of kernels. */
  Rehearsal() {
    for (int i = 0; i < NUMBERS; i++) {
      cos[i] = i % 5 - 2;
      sin[i] = i % 7 - 3;
    }
    build();
    begin = world.save(null);
    step();
  }

  private void build() {
    Body<Object> ground =
        world.createBody(new BodyDef(BodyType.STATIC).shape(new Box(60, 1)), null);
    world.createBody(new BodyDef(BodyType.STATIC).position(-11, 15).shape(new Box(1, 30)), null);
    world.createBody(new BodyDef(BodyType.STATIC).position(11, 15).shape(new Box(1, 30)), null);
    for (int row = 0; row < ROWS; row++) {
      for (int column = 0; column < COLUMNS; column++) {
        BodyDef def =
            new BodyDef(BodyType.DYNAMIC)
                .position(-9.6f + 1.25f * column + row % 3 * 0.2f, 1.2f + 1.3f * row)
                .angle(0.1f * (column % 7));
        world.createBody(
            column % 4 == 3 ? def.shape(new Circle(0.5f)) : def.shape(new Box(1, 0.8f)), null);
      }
    }
    hangNet(ground);
  }

  /** Hangs a net of small boxes by the ends of its first row. */
  private void hangNet(Body<Object> ground) {
    List<Body<Object>> knots = new ArrayList<>();
    for (int row = 0; row < NET; row++) {
      for (int column = 0; column < NET; column++) {
        float x = column - NET / 2f;
        float y = 50 - row;
        Body<Object> knot =
            world.createBody(
                new BodyDef(BodyType.DYNAMIC).position(x, y).shape(new Box(0.4f, 0.4f)), null);
        if (row == 0 && column % (NET - 1) == 0) {
          world.createJoint(JointDef.revolute(ground, knot, x, y + 0.2f));
        }
        if (column > 0) {
          world.createJoint(JointDef.revolute(knots.get(knots.size() - 1), knot, x - 0.5f, y));
        }
        if (row > 0) {
          world.createJoint(JointDef.revolute(knots.get(knots.size() - NET), knot, x, y + 0.5f));
        }
        knots.add(knot);
      }
    }
  }

  /** Returns whether the next step is one of a world that begins again, which may allocate. */
  boolean isAtEnd() {
    return steps == STEPS;
  }

  /** Makes a step, hashes the state and quantises columns. */
  void step() {
    if (isAtEnd()) {
      world.restore(begin);
      steps = 0;
    }
    world.step(TICK_S);
    world.stateHash();
    Quantizer.positions(cos, NUMBERS, quantised);
    Quantizer.anglesOfTurns(cos, sin, NUMBERS, 0, quantised);
    steps++;
  }
}

package carom.physics.laws;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Filter;
import carom.physics.ShapeDef;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Whatever way a still body appears in a sleeper, the sleeper wakes and is pushed out. */
class EntranceLawTest {
  private static final float DT = 1 / 60f;

  private enum Way {
    CREATED,
    ASLEEP,
    ENABLED,
    FILTERED,
    ADDED,
    REPLACED,
    SOLID,
    TYPE,
    BECOME,
    POSED,
    REFILTERED
  }

  @ParameterizedTest
  @EnumSource
  void aStillBodyThatAppearsWakesASleeper(Way way) {
    long seed = new Random().nextLong();
    Random random = new Random(seed);
    for (BodyType type : new BodyType[] {BodyType.STATIC, BodyType.KINEMATIC}) {
      for (int i = 0; i < 10; i++) {
        World<String> w = new World<>(new WorldDef());
        boolean[] meets = {way != Way.REFILTERED};
        w.collisionFilter((a, ofA, b, ofB) -> meets[0] || !(isComing(a) || isComing(b)));
        w.createBody(new BodyDef().position(0, -1).shape(new Box(20, 1)), "floor");
        BodyDef box = new BodyDef(BodyType.DYNAMIC).position(0, 0.5f);
        Body<String> sleeper = w.createBody(box.shape(new Box(0.5f, 0.5f)), "sleeper");
        float x = 0.5f + 0.3f * random.nextFloat();
        boolean isNew = way == Way.CREATED || way == Way.ASLEEP;
        Body<String> comes = isNew ? null : prepare(w, way, type, x);
        for (int step = 0; step < 120; step++) {
          w.step(DT);
        }
        String told = "seed=" + seed + " type=" + type + " x=" + x;
        assertFalse(sleeper.awake(), told);
        meets[0] = true;
        appear(w, way, type, x, comes);
        w.step(DT);
        assertTrue(sleeper.awake(), told);
        for (int step = 0; step < 120; step++) {
          w.step(DT);
        }
        assertTrue(sleeper.x() + 0.5f <= x - 0.4f + 0.02f || sleeper.y() > 1, told);
      }
    }
  }

  private static boolean isComing(Body<String> body) {
    return body.user().equals("comes");
  }

  private static BodyDef at(BodyType type, float x) {
    return new BodyDef(type).position(x, 0.5f).sleepAllowed(true);
  }

  private static Body<String> prepare(World<String> w, Way way, BodyType type, float x) {
    ShapeDef disc = new ShapeDef(new Circle(0.4f));
    Body<String> body =
        switch (way) {
          case FILTERED ->
              w.createBody(at(type, x).shape(disc.withFilter(Filter.NOTHING)), "comes");
          case ADDED -> w.createBody(at(type, x), "comes");
          case REPLACED, BECOME -> w.createBody(at(type, x).shape(new Circle(0.1f, 5, 5)), "comes");
          case SOLID -> w.createBody(at(type, x).shape(disc.withSensor(true)), "comes");
          case TYPE -> {
            BodyType other = type == BodyType.STATIC ? BodyType.KINEMATIC : BodyType.STATIC;
            yield w.createBody(at(other, x).shape(disc.withFilter(Filter.NOTHING)), "comes");
          }
          case POSED -> w.createBody(at(type, x).position(x, 9).shape(disc), "comes");
          default -> w.createBody(at(type, x).shape(disc), "comes");
        };
    body.setEnabled(way != Way.ENABLED);
    return body;
  }

  private static void appear(World<String> w, Way way, BodyType type, float x, Body<String> comes) {
    ShapeDef disc = new ShapeDef(new Circle(0.4f));
    switch (way) {
      case CREATED -> w.createBody(at(type, x).shape(disc), "comes");
      case ASLEEP -> w.createBody(at(type, x).awake(false).shape(disc), "comes");
      case ENABLED -> comes.setEnabled(true);
      case FILTERED -> comes.setFilter(0, Filter.DEFAULT);
      case ADDED -> comes.addShape(disc);
      case REPLACED -> comes.replaceShape(0, disc);
      case SOLID -> comes.setSensor(0, false);
      case TYPE -> {
        comes.setFilter(0, Filter.DEFAULT);
        comes.setType(type);
      }
      case BECOME -> comes.become(new BodyDef(type).shape(disc));
      case POSED -> comes.setPose(x, 0.5f, 0);
      case REFILTERED -> comes.refilter();
    }
  }
}

package carom.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import carom.physics.settings.MixingRule;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;

class WorldDefTest {
  /** All constants by name, as the getters tell them. */
  private static Map<String, Object> constants(WorldDef def) throws Exception {
    Map<String, Object> constants = new TreeMap<>();
    for (Method m : WorldDef.class.getMethods()) {
      boolean getter = m.getParameterCount() == 0 && !Modifier.isStatic(m.getModifiers());
      if (getter && m.getDeclaringClass() != Object.class) {
        constants.put(m.getName(), m.invoke(def));
      }
    }
    return constants;
  }

  private static Object other(Object value) {
    return value instanceof Boolean b
        ? (Object) !b
        : value instanceof Integer i
            ? (Object) (i + 1)
            : value instanceof Float f
                ? (Object) (f + 0.5f)
                : value instanceof MixingRule ? MixingRule.MULTIPLY : Integrator.EXPLICIT_EULER;
  }

  @Test
  void eachConstantIsChangedAloneAndInACopy() throws Exception {
    WorldDef def = new WorldDef();
    Map<String, Object> defaults = constants(def);
    int changed = 0;
    for (Method with : WorldDef.class.getMethods()) {
      if (with.getName().startsWith("with") && with.getParameterCount() == 1) {
        String name = with.getName().substring(4);
        name = Character.toLowerCase(name.charAt(0)) + name.substring(1);
        Map<String, Object> expected = new TreeMap<>(defaults);
        expected.put(name, other(defaults.get(name)));
        if (name.equals("integrator")) {
          expected.put("explicitEuler", true);
        }
        assertEquals(expected, constants((WorldDef) with.invoke(def, expected.get(name))), name);
        changed++;
      }
    }
    assertEquals(20, changed);
    WorldDef heavy = def.withGravity(1, -20);
    assertEquals(1, heavy.gravityX());
    assertEquals(-20, heavy.gravityY());
    assertEquals(defaults, constants(heavy.withGravity(0, -10)));
    assertEquals(defaults, constants(def), "the original never changes");
  }

  @Test
  void constantsOutOfRangeAreRefusedByName() {
    WorldDef def = new WorldDef();
    refused("gravityY=NaN is outside -10000.0..10000.0", () -> def.withGravity(0, Float.NaN));
    refused("substeps=0.0 is outside 1.0..32.0", () -> def.withSubsteps(0));
    refused("substeps=33.0 is outside 1.0..32.0", () -> def.withSubsteps(33));
    refused("contactHertz=0.5 is outside 1.0..1000.0", () -> def.withContactHertz(0.5f));
    refused("contactDampingRatio=0.0", () -> def.withContactDampingRatio(0));
    refused("restitutionThreshold=-1.0", () -> def.withRestitutionThreshold(-1));
    refused("maxPushSpeed=1001.0", () -> def.withMaxPushSpeed(1001));
    refused("slop=2.0", () -> def.withSlop(2));
    refused("speculativeDistance=2.0", () -> def.withSpeculativeDistance(2));
    refused("aabbMargin=11.0", () -> def.withAabbMargin(11));
    refused("maxSpeed=0.0", () -> def.withMaxSpeed(0));
    refused("maxAngularSpeed=0.0", () -> def.withMaxAngularSpeed(0));
    refused("jointHertz=Infinity", () -> def.withJointHertz(Float.POSITIVE_INFINITY));
    refused("jointDampingRatio=101.0", () -> def.withJointDampingRatio(101));
    refused("sleepSpeed=-1.0", () -> def.withSleepSpeed(-1));
    refused("sleepDelay=0.0", () -> def.withSleepDelay(0));
    refused("hitSpeed=-1.0", () -> def.withHitSpeed(-1));
    refused("integrator=null; choose one", () -> def.withIntegrator(null));
    refused("frictionMixing=null; choose one", () -> def.withFrictionMixing(null));
    refused("restitutionMixing=null; choose one", () -> def.withRestitutionMixing(null));
  }

  private static void refused(String start, Runnable change) {
    String message = assertThrows(IllegalArgumentException.class, change::run).getMessage();
    assertEquals(start, message.substring(0, Math.min(start.length(), message.length())));
  }
}

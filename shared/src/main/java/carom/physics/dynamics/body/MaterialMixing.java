package carom.physics.dynamics.body;

import carom.physics.settings.MixingRule;
import carom.physics.settings.Settings;
import java.util.Arrays;

/**
 * The rules by which the friction and the restitution of parts are mixed: the world's, and those
 * that some parts have of their own. {@link MixingRule} says which rule counts. A world whose parts
 * have none pays for one test per new contact.
 */
public final class MaterialMixing {
  private static final MixingRule[] RULES = MixingRule.values();

  /** Bits of a rule in a code; 0 stands for none. */
  private static final int BITS = 3;

  private static final int MASK = (1 << BITS) - 1;

  private final MixingRule friction;
  private final MixingRule restitution;

  /** The {@link #code} of each part's own rules. */
  private byte[] own;

  /** True once a part had a mixing rule of its own. Until then, the rules of parts are not read. */
  private boolean any;

  MaterialMixing(Settings settings, int capacity) {
    friction = settings.frictionMixing();
    restitution = settings.restitutionMixing();
    own = new byte[capacity];
  }

  /** Returns a number that stands for two rules, of which each may be null; 0 for none. */
  static int code(MixingRule friction, MixingRule restitution) {
    return code(friction) | code(restitution) << BITS;
  }

  private static int code(MixingRule rule) {
    return rule == null ? 0 : rule.ordinal() + 1;
  }

  void set(int part, MixingRule ownFriction, MixingRule ownRestitution) {
    own[part] = (byte) code(ownFriction, ownRestitution);
    any |= own[part] != 0;
  }

  void grow(int capacity) {
    own = Arrays.copyOf(own, capacity);
  }

  void copyTo(MaterialMixing to, int used) {
    System.arraycopy(own, 0, to.own, 0, used);
    to.any |= any;
  }

  /** Returns the rule for the friction of two parts. */
  public MixingRule friction(int p, int q) {
    return any ? rule(own[p] & MASK, own[q] & MASK, friction) : friction;
  }

  /** Returns the rule for the restitution of two parts. */
  public MixingRule restitution(int p, int q) {
    return any ? rule(own[p] >> BITS, own[q] >> BITS, restitution) : restitution;
  }

  private static MixingRule rule(int codeP, int codeQ, MixingRule ofWorld) {
    int later = Math.max(codeP, codeQ);
    return later == 0 ? ofWorld : RULES[later - 1];
  }
}

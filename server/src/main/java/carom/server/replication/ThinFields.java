package carom.server.replication;

import carom.server.thin.ThinServerMessage;
import carom.server.thin.ThinServerMessage.FieldValue;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.event.Audience;
import carom.sim.field.FieldValues;
import carom.sim.field.Schema;
import carom.sim.field.Scope;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.IntPredicate;

/**
 * Knows which fields of the match, of players and of entities a thin client was told, and tells
 * what changed, by name, as far as its player may know it.
 *
 * <p>The room's thread. Allocates when a target is new or a field changed.
 */
final class ThinFields {
  /**
   * The values under one id, as the client knows them, whatever has the id now. The client keeps
   * them until it is told otherwise.
   */
  private static final class Known {
    final int[] words;
    final boolean[] told;
    Object of;
    long stamp;
    int audience;

    Known(int count) {
      words = new int[count];
      told = new boolean[count];
    }
  }

  private static final int NEAR = 1;
  private static final int TEAM = 2;
  private static final int OWNER = 4;

  private final SimulationHost simulation;
  private final Schema schema;
  private final HostPlayer player;
  private final IntPredicate sees;
  private final List<Known> players = new ArrayList<>();
  private final List<Known> entities = new ArrayList<>();
  private final Known match;

  /** By word of the match: whether it is for clients that predict alone. */
  private final boolean[] isOfRules;

  /** True if any field of a player depends on who sees its body. */
  private final boolean sightMatters;

  private final List<FieldValue> changes = new ArrayList<>();

  ThinFields(SimulationHost simulation, HostPlayer player, IntPredicate sees) {
    this.simulation = simulation;
    this.schema = simulation.schema();
    this.player = player;
    this.sees = sees;
    match = new Known(schema.toldWords(Scope.MATCH));
    isOfRules = new boolean[schema.toldWords(Scope.MATCH)];
    boolean near = false;
    for (int word = 0; word < schema.toldWords(Scope.PLAYER); word++) {
      near |= schema.field(Scope.PLAYER, word).audience() == Audience.NEAR;
    }
    sightMatters = near;
    for (int word = 0; word < isOfRules.length; word++) {
      isOfRules[word] = simulation.isOfRules(schema.field(Scope.MATCH, word));
    }
  }

  /** Returns what changed since the last call, or null for nothing. */
  ThinServerMessage.Fields changes() {
    boolean all = simulation.game().seesAll(simulation, player);
    compare(Scope.MATCH, 0, simulation, simulation.fieldValues(), NEAR | TEAM | OWNER, match);
    if (schema.toldWords(Scope.PLAYER) > 0) {
      for (int id = 0; id < simulation.playerCapacity(); id++) {
        HostPlayer other = simulation.player(id);
        if (other != null) {
          compare(
              Scope.PLAYER,
              id,
              other,
              other.fieldValues(),
              ofPlayer(other, all),
              at(players, Scope.PLAYER, id));
        }
      }
    }
    if (schema.toldWords(Scope.ENTITY) > 0) {
      for (int id = 0; id < simulation.entityCapacity(); id++) {
        HostEntity entity = simulation.entity(id);
        if (entity != null && sees.test(id)) {
          compare(
              Scope.ENTITY,
              id,
              entity,
              entity.fieldValues(),
              ofEntity(entity, all),
              at(entities, Scope.ENTITY, id));
        }
      }
    }
    if (changes.isEmpty()) {
      return null;
    }
    ThinServerMessage.Fields told = new ThinServerMessage.Fields(List.copyOf(changes));
    changes.clear();
    return told;
  }

  private Known at(List<Known> all, Scope scope, int id) {
    while (all.size() <= id) {
      all.add(new Known(schema.toldWords(scope)));
    }
    return all.get(id);
  }

  private int ofPlayer(HostPlayer other, boolean all) {
    if (all || other == player) {
      return NEAR | TEAM | OWNER;
    }
    HostEntity body = sightMatters ? other.entity() : null;
    return (body != null && sees.test(body.id()) ? NEAR : 0)
        | (other.team() == player.team() ? TEAM : 0);
  }

  private int ofEntity(HostEntity entity, boolean all) {
    HostPlayer owner = entity.owner();
    boolean team = owner != null && owner.team() == player.team();
    return NEAR | (all || team ? TEAM : 0) | (all || owner == player ? OWNER : 0);
  }

  private static boolean mayKnow(Audience of, int audience) {
    return switch (of) {
      case ALL -> true;
      case NEAR -> (audience & NEAR) != 0;
      case TEAM -> (audience & (TEAM | OWNER)) != 0;
      case OWNER -> (audience & OWNER) != 0;
      case NOBODY -> false;
    };
  }

  @SuppressWarnings("ReferenceEquality") // another target may have the id of one that is gone
  private void compare(
      Scope scope, int id, Object of, FieldValues values, int audience, Known known) {
    if (known.of == of && known.stamp == values.stamp() && known.audience == audience) {
      return;
    }
    known.of = of;
    known.stamp = values.stamp();
    known.audience = audience;
    for (int word = 0; word < known.words.length; word++) {
      boolean may =
          mayKnow(schema.field(scope, word).audience(), audience)
              && !(scope == Scope.MATCH && isOfRules[word]);
      if (may && (!known.told[word] || known.words[word] != values.word(word))) {
        known.told[word] = true;
        known.words[word] = values.word(word);
        changes.add(value(scope, id, word, schema.field(scope, word).value(values.word(word))));
      } else if (!may && known.told[word]) {
        known.told[word] = false;
        changes.add(value(scope, id, word, null));
      }
    }
  }

  private FieldValue value(Scope scope, int id, int word, Object value) {
    String path = schema.name(scope, word); // such as player.health, match.lamp[3]
    String name = path.substring(path.indexOf('.') + 1);
    return new FieldValue(scope.name().toLowerCase(Locale.ROOT), id, name, value);
  }
}

package carom.sim.level;

import carom.sim.field.Field;
import carom.sim.field.Schema;
import carom.sim.field.Scope;
import carom.text.Suggestion;
import java.util.ArrayList;
import java.util.List;

/**
 * A field of a level's bodies with the value that the level gives it. The level is read before its
 * game is known, so the name and the value are checked when the two meet.
 *
 * @param where file, line and place, for error messages
 * @param name of the field
 * @param value a {@code Double}, {@code Boolean} or {@code String}
 */
record LevelField(String where, String name, Object value) {
  /**
   * Returns the field of a game's entities with the level's start.
   *
   * @throws IllegalArgumentException if the game has no such field, or it can't begin so
   */
  Field<?> of(Schema schema) {
    Field<?> field = schema.find(Scope.ENTITY, name);
    if (field == null) {
      List<String> known = new ArrayList<>();
      for (Field<?> other : schema.fields()) {
        if (other.scope() == Scope.ENTITY) {
          known.add(other.name());
        }
      }
      throw new IllegalArgumentException(
          where
              + " isn't a field of the game's entities"
              + (known.isEmpty() ? ", which have none" : Suggestion.didYouMean(name, known)));
    }
    try {
      return field.startsFrom(value);
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException(where + ": " + e.getMessage(), e);
    }
  }
}

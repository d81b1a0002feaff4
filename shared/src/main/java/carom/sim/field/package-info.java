/**
 * State with names: what a game remembers of players, entities and the match, between ticks.
 *
 * <p>A game declares each {@link carom.sim.field.Field} once, with a name, a range, a {@link
 * carom.sim.field.Scope}, an audience and a start value. A {@link carom.sim.field.Schema} lays the
 * fields of one game out in words of 32 bits, equally on server and clients. {@link
 * carom.sim.field.FieldValues} are the words of one player, one entity or the match; {@link
 * carom.sim.field.FieldHolder} reads and writes them by the field's kind. A {@link
 * carom.sim.field.Gauge} says how a window draws a field.
 *
 * <pre>
 *   Field.count("health", 0, 100).of(PLAYER).to(ALL).startsAt(100)      a constant of the game
 *        │ Game.fields()
 *   Schema     PLAYER  health │ dashWait │ ... │ server only            an offset in words each
 *        │ FieldStore: one per simulation
 *   FieldValues   one per player, entity and match                      hashed, saved, sent
 *        │ FieldHolder
 *   p.get(HEALTH)   p.add(HEALTH, -20)   p.set(HEALTH, 100)
 * </pre>
 *
 * <p>Allowed imports: {@code carom.physics.math}, {@code carom.physics.archive}, {@code
 * carom.sim.event}, {@code carom.sim.phase}. Read first: {@link carom.sim.field.Field}, {@link
 * carom.sim.field.FieldHolder}.
 */
package carom.sim.field;

/**
 * Messages of a game's own: kinds, values, bytes, and queues. A game declares a {@link
 * carom.sim.message.MessageKind}; client and server exchange {@link carom.sim.message.Message}s of
 * it; {@link carom.sim.message.MessageKinds} turns them into bytes and back. Chat, emotes and what
 * players ask of the roster are {@link carom.sim.message.BuiltInKinds}. It knows no simulation, no
 * players and no network.
 */
package carom.sim.message;

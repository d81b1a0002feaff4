package carom.client.view;

import carom.client.field.ShownFields;
import carom.client.interpolation.Pose;
import carom.client.link.ConnectionPhase;
import carom.client.stats.NetStats;
import carom.net.protocol.ServerMessage.BestList;
import carom.net.protocol.ServerMessage.LevelList;
import carom.net.protocol.ServerMessage.PlayPage;
import carom.net.protocol.ServerMessage.RoomEntry;
import carom.net.protocol.ServerMessage.Roster;
import carom.net.protocol.ServerMessage.RosterEntry;
import carom.physics.Queries;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.Input;
import carom.sim.level.Archetype;
import carom.sim.level.Level;
import carom.sim.pool.Pools;
import java.util.List;

/**
 * Writes what a {@link ClientView} shows. The client or the replay that owns the view holds its
 * writer; users only get the view. One thread.
 */
public final class ViewWriter {
  private final ClientView view;

  /**
   * Creates a view and its writer.
   *
   * @param stats of the connection, for users of the view
   */
  public ViewWriter(NetStats stats) {
    view = new ClientView(stats);
  }

  /** Returns the view to read; the same object for ever. */
  public ClientView view() {
    return view;
  }

  /** Sets where the client stands, in words for the player, and the share of the level. */
  public void connection(ConnectionPhase phase, String message, double progress) {
    view.phase = phase;
    view.message = message;
    view.progress = progress;
  }

  /**
   * Sets the game that is shown from now on.
   *
   * @param game its name
   * @param playerId the own player's id, or -1
   * @param predicted the predicted simulation, for debug drawing, or null
   */
  public void game(String game, Level level, int playerId, int tickRate, SimulationHost predicted) {
    view.game = game;
    view.level = level;
    view.playerId = playerId;
    view.tickRate = tickRate;
    view.predictedWorld = predicted;
  }

  /** Notes that nothing is predicted any more. */
  public void withoutPrediction() {
    view.predictedWorld = null;
  }

  /** Sets the water and sand that is shown, or null. */
  public void pools(Pools pools) {
    view.pools = pools;
  }

  /** Sets the world whose static geometry {@link ClientView#isWall} asks, or null. */
  public void geometry(Queries<HostEntity> geometry) {
    view.geometry = geometry;
  }

  /** Sets the room, and the number of its match. */
  public void room(String name, int match) {
    view.room = name;
    view.matchNumber = match;
  }

  /** Sets the server's rooms. */
  public void rooms(List<RoomEntry> rooms) {
    view.rooms = rooms;
  }

  /** Sets the best lists of the room's game. */
  public void best(List<BestList> lists) {
    view.best = lists;
  }

  /** Sets where browsers play; null if the server has no page. */
  public void playPage(String host, PlayPage page) {
    view.playHost = host;
    view.playPage = page;
  }

  /** Sets the levels of players. */
  public void levels(LevelList levels) {
    view.levels = levels;
  }

  /** Sets the tick that is predicted. */
  public void tick(int tick) {
    view.tick = tick;
  }

  /** Sets the moment at which interpolated entities are drawn, ticks. */
  public void renderTick(double tick) {
    view.renderTick = tick;
  }

  /** Sets the input that was sampled last. */
  public void input(Input sampled) {
    view.input.set(sampled);
  }

  /** Sets where the game's fields are read. */
  public void fields(ShownFields fields) {
    view.fields = fields;
  }

  /** Sets the player that the picture follows, or -1. */
  public void watched(int playerId) {
    view.watchedPlayer = playerId;
  }

  /** Changes the list of players. */
  public void roster(Roster changes) {
    view.roster(changes);
  }

  /** Replaces the list of players. */
  public void roster(List<RosterEntry> entries) {
    view.roster(entries);
  }

  /** Adds a line for the player. */
  public void notice(String text, long nowNs) {
    view.notice(text, nowNs);
  }

  // ---- entities

  /** Sets what composes the entities when a user looks at them after {@link #invalidate}. */
  public void composer(Runnable composer) {
    view.composer(composer);
  }

  /** Marks the entities as out of date: there is a new moment to show. */
  public void invalidate() {
    view.invalidate();
  }

  /** Composes the entities of the last moment, which stay while nothing new comes. */
  public void freeze() {
    view.compose();
  }

  /** Removes all entities. */
  public void clear() {
    view.clear();
  }

  /**
   * Adds an entity. Ids must ascend.
   *
   * @param alpha opacity, 0..1
   * @param predicted weight of the prediction, 0..1
   * @return its pose, to be filled in
   */
  public Pose add(
      int id, int generation, Archetype archetype, int ownerId, float alpha, float predicted) {
    ClientView.Drawn drawn = view.add();
    drawn.id = id;
    drawn.generation = generation;
    drawn.archetype = archetype;
    drawn.ownerId = ownerId;
    drawn.alpha = alpha;
    drawn.predicted = predicted;
    return drawn.pose;
  }

  /** Makes the entity that was added last the own one. */
  public void markLastAsOwn() {
    view.markLastAsOwn();
  }
}

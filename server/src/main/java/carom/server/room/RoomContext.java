package carom.server.room;

import carom.server.config.ServerConfig;
import carom.server.metrics.Counters;
import carom.server.session.Seats;
import carom.sim.Simulation;

/**
 * What the parts of a room share.
 *
 * @param label begins each log line: the room's number, or empty if there is only one room
 */
record RoomContext(
    ServerConfig config, String label, Counters counters, Seats seats, Simulation simulation) {}

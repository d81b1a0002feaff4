package carom.server.web;

import carom.server.room.BodyLook;
import carom.server.room.Picture;
import carom.server.room.Room;
import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;

/**
 * The pictures of a room for all its viewers. It asks the room for one that shows what any of them
 * wants, and sends each what it wants itself. The page's thread.
 */
final class RoomFeed {
  private static final long PLAYERS_NS = 1_000_000_000L;

  private final Room room;
  private final PlayerRates rates = new PlayerRates();
  private long playersNs;
  private boolean playersAsked;

  RoomFeed(Room room) {
    this.room = room;
  }

  /**
   * Sends the picture that the room has made, and asks for the next.
   *
   * @param viewers those who look at the room; if there are none, nothing happens
   */
  void turn(List<Viewer> viewers, long nowNs) {
    if (viewers.isEmpty()) {
      return;
    }
    Picture picture = room.pictures().poll();
    if (picture != null) {
      send(picture, viewers, nowNs);
    }
    boolean cells = false;
    boolean contacts = false;
    Set<Integer> priorityOf = new TreeSet<>();
    for (Viewer viewer : viewers) {
      Viewer.Gaze gaze = viewer.gaze();
      cells |= gaze.cells();
      contacts |= gaze.contacts();
      if (gaze.priorityOf() >= 0) {
        priorityOf.add(gaze.priorityOf());
      }
    }
    // A request that the room hasn't answered is replaced, and what it asked for is asked again.
    playersAsked |= nowNs - playersNs >= PLAYERS_NS;
    room.pictures().ask(new Picture.Request(playersAsked, cells, contacts, priorityOf));
  }

  private void send(Picture picture, List<Viewer> viewers, long nowNs) {
    Map<Viewer.Gaze, ByteBuffer> encoded = new HashMap<>();
    for (Viewer viewer : viewers) {
      if (!viewer.isIdle()) {
        continue; // it gets the next one
      }
      if (viewer.learns(picture.match())) {
        viewer.send(PageJson.match(room, picture.match()));
      }
      List<BodyLook> unknown = viewer.learns(picture);
      if (!unknown.isEmpty()) {
        viewer.send(PageJson.looks(unknown));
      }
      viewer.send(
          encoded.computeIfAbsent(
              viewer.gaze(),
              gaze -> PictureBytes.of(picture, gaze.cells(), gaze.contacts(), gaze.priorityOf())));
    }
    if (picture.players() != null) {
      playersAsked = false;
      playersNs = nowNs;
      List<PlayerRates.Rate> now = rates.add(nowNs, picture.players());
      String best = PageJson.best(room, room.best());
      for (Viewer viewer : viewers) {
        viewer.send(PageJson.players(room, now, viewer.isAdmin()));
        viewer.send(best);
      }
    }
  }
}

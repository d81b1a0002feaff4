package carom.server.web;

import carom.server.http.Origins;
import carom.server.match.MatchInfo;
import carom.server.room.BodyLook;
import carom.server.room.Picture;
import io.undertow.websockets.core.CloseMessage;
import io.undertow.websockets.core.WebSocketCallback;
import io.undertow.websockets.core.WebSocketChannel;
import io.undertow.websockets.core.WebSockets;
import java.io.IOException;
import java.net.InetAddress;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * One open page: whether it may command, what it looks at, and which bodies it knows. What it looks
 * at is set by the thread that reads its messages, the bodies belong to the page's thread, and any
 * thread may send.
 */
final class Viewer {
  /** Messages that may wait for a slow viewer before it is cut off. */
  private static final int MAX_WAITING = 200;

  private static final int MESSAGES_PER_S = 20;
  private static final int BURST = 60;
  private static final double NS_PER_S = 1e9;

  private final WebSocketChannel channel;
  private final Origins.Origin origin;
  private final AtomicInteger waiting = new AtomicInteger();
  private volatile boolean admin;
  private volatile Gaze gaze = Gaze.NOTHING;
  private volatile long heardNs;
  private double messages = BURST;

  /** Number of the log's last line that it got. */
  private long logSeen;

  private MatchInfo match;
  private BodyLook[] known = {};

  private final WebSocketCallback<Void> sent =
      new WebSocketCallback<>() {
        @Override
        public void complete(WebSocketChannel on, Void context) {
          waiting.decrementAndGet();
        }

        @Override
        public void onError(WebSocketChannel on, Void context, Throwable error) {
          waiting.decrementAndGet();
          close();
        }
      };

  private final WebSocketCallback<Void> refused =
      new WebSocketCallback<>() {
        @Override
        public void complete(WebSocketChannel on, Void context) {
          close();
        }

        @Override
        public void onError(WebSocketChannel on, Void context, Throwable error) {
          close();
        }
      };

  /**
   * The room and the details that a viewer looks at. Immutable.
   *
   * @param room name of the room, or null for none
   * @param cells whether it shows the broadphase's trees
   * @param contacts whether it shows contact points
   * @param priorityOf id of the player whose priorities it shows, or -1
   */
  record Gaze(String room, boolean cells, boolean contacts, int priorityOf) {
    static final Gaze NOTHING = new Gaze(null, false, false, -1);
  }

  Viewer(WebSocketChannel channel, Origins.Origin origin, long nowNs) {
    this.channel = channel;
    this.origin = origin;
    heardNs = nowNs;
  }

  InetAddress address() {
    return origin.address();
  }

  /** Returns whether it sits at this machine for sure. */
  boolean isHere() {
    return origin.isHere();
  }

  boolean isAdmin() {
    return admin;
  }

  void becomeAdmin() {
    admin = true;
  }

  Gaze gaze() {
    return gaze;
  }

  void look(Gaze at) {
    gaze = at;
  }

  long heardNs() {
    return heardNs;
  }

  /** Notes a message; returns false if there are too many. The thread that reads messages. */
  boolean heard(long nowNs) {
    double seconds = (nowNs - heardNs) / NS_PER_S;
    messages = Math.min(BURST, messages + seconds * MESSAGES_PER_S) - 1;
    heardNs = nowNs;
    return messages >= 0;
  }

  /** Sends a text. A viewer that doesn't read is cut off. */
  void send(String text) {
    if (waiting.incrementAndGet() > MAX_WAITING) {
      close();
      return;
    }
    WebSockets.sendText(text, channel, sent);
  }

  /** Returns whether everything sent has left, so that a picture would be fresh. */
  boolean isIdle() {
    return waiting.get() == 0;
  }

  /** Sends numbers. They aren't changed. */
  void send(ByteBuffer bytes) {
    waiting.incrementAndGet();
    WebSockets.sendBinary(bytes.duplicate(), channel, sent);
  }

  /** Takes over that it knows a match, and returns whether it is another. The page's thread. */
  @SuppressWarnings("ReferenceEquality") // Each match has an object of its own.
  boolean learns(MatchInfo newMatch) {
    boolean other = match != newMatch;
    if (other) {
      match = newMatch;
      Arrays.fill(known, null);
    }
    return other;
  }

  /** Returns the bodies of a picture that it doesn't know, and notes that it does. Same thread. */
  @SuppressWarnings("ReferenceEquality") // A body that looks different has another object.
  List<BodyLook> learns(Picture picture) {
    List<BodyLook> unknown = new ArrayList<>();
    for (BodyLook look : picture.bodies()) {
      if (look.slot() >= known.length) {
        known = Arrays.copyOf(known, Math.max(look.slot() + 1, 2 * known.length));
      }
      if (known[look.slot()] != look) {
        known[look.slot()] = look;
        unknown.add(look);
      }
    }
    return unknown;
  }

  /** Returns the number of the log's last line that it got. The page's thread. */
  long logSeen() {
    return logSeen;
  }

  /** Notes the log's last line that it got. The page's thread. */
  void logSeen(long number) {
    logSeen = number;
  }

  /**
   * Ends the connection and says why. A connection that just ends isn't noticed by every client.
   */
  void refuse(String why) {
    WebSockets.sendClose(CloseMessage.MSG_VIOLATES_POLICY, why, channel, refused);
  }

  /** Ends the connection at once: for a viewer that doesn't read. */
  void close() {
    try {
      channel.close();
    } catch (IOException e) {
      // it is gone either way
    }
  }
}

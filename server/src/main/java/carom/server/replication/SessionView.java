package carom.server.replication;

import carom.net.codec.Quantizer;
import carom.net.snapshot.Interest;
import carom.net.snapshot.SnapshotEncoder;
import carom.net.snapshot.frame.EventRecord;
import carom.net.snapshot.frame.FrameRing;
import carom.net.snapshot.frame.FrameState;
import carom.physics.Body;
import carom.physics.BodyContactVisitor;
import carom.physics.broadphase.IntVisitor;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.event.Audience;
import carom.sim.level.Level;
import carom.sim.near.Neighbourhood;

/**
 * The part of the world that one player looks at: a rectangle around the own body, or around the
 * place that a spectator's client names. Entities enter at its border and leave a quarter further
 * out.
 *
 * <p>Everything is in sight in three cases: the level is no larger than the largest view; the world
 * has few entities and the operator has not set a view; or the player {@linkplain
 * carom.sim.Game#seesAll sees all}. While the room is too busy and {@linkplain
 * FrameCapture#narrowViews views are narrow}, only the last one counts.
 *
 * <p>The room's thread; no allocation after construction.
 */
final class SessionView implements Interest {
  /** Leaving takes a view this much larger than entering. */
  private static final float STAY = 1.25f;

  /** Largest half width and half height unless the operator has set them, metres. */
  private static final float DEFAULT_LIMIT = 64;

  /** With at most this many entities everything is in sight. */
  private static final int FEW = 1_024;

  /** With more than {@link #FEW}, everything is in sight again when so few are left. */
  private static final int FEW_AGAIN = 768;

  /** The smallest half width and half height, metres. */
  private static final float LEAST = 1;

  /** Rate of looking for entities that came into view. */
  private static final int LOOKS_PER_SECOND = 10;

  /** Weight of the own body against others at the same place. */
  private static final float OWN = 16;

  /** Weight of a body that touches the own body. */
  private static final float TOUCHED = 8;

  private static final int MAX_TOUCHED = 16;

  /** Fall of the priority with distance: at the border it is a quarter of that in the middle. */
  private static final float FAR = 3;

  /** Speed that doubles the priority of an entity, m/s. */
  private static final float SPEED = 4;

  /** The most by which speed raises the priority. */
  private static final float MAX_SPEED_FACTOR = 4;

  /** Radius up to which size does not raise the priority, metres. */
  private static final float SIZE = 0.5f;

  /** The most by which size raises the priority. */
  private static final float MAX_SIZE_FACTOR = 4;

  private final InterestIndex index;
  private final HostPlayer player;
  private final float limit;
  private final boolean smallLevel;
  private final boolean automatic;
  private boolean few = true;
  private final int lookTicks;
  private final int[] touched = new int[MAX_TOUCHED];
  private int touchedCount;
  private int ownSlot = -1;
  private float x;
  private float y;
  private float halfWidth;
  private float halfHeight;
  private int followed = -1;
  private float spectatorX;
  private float spectatorY;
  private boolean everything;
  private boolean everyone;
  private int team;
  private boolean sawAll;
  private int nextLook;
  private SnapshotEncoder encoder;

  private final IntVisitor notice =
      slot -> {
        encoder.notice(slot);
        return true;
      };

  private final BodyContactVisitor<HostEntity> touch =
      (other, normalX, normalY, impulse) -> {
        int slot = other.user().id();
        if (slot >= 0 && touchedCount < MAX_TOUCHED) {
          touched[touchedCount++] = slot;
        }
      };

  /**
   * Creates a view as large as allowed, in the middle of the level.
   *
   * @param viewMetres largest half width and half height; 0 = automatic
   */
  SessionView(InterestIndex index, HostPlayer player, int viewMetres, int tickRateHz) {
    this.index = index;
    this.player = player;
    automatic = viewMetres == 0;
    limit = automatic ? DEFAULT_LIMIT : viewMetres;
    lookTicks = Math.max(1, tickRateHz / LOOKS_PER_SECOND);
    nextLook = player.id() % lookTicks;
    Level.Bounds bounds = index.simulation().level().bounds();
    smallLevel =
        bounds.maxX() - bounds.minX() <= 2 * limit && bounds.maxY() - bounds.minY() <= 2 * limit;
    spectatorX = (bounds.minX() + bounds.maxX()) / 2;
    spectatorY = (bounds.minY() + bounds.maxY()) / 2;
    halfWidth = limit;
    halfHeight = limit;
  }

  /**
   * Takes over what the client says it shows; what is too large is cut.
   *
   * @param centreX where it looks while the player has no body, metres, finite
   * @param centreY where it looks while the player has no body, metres, finite
   * @param wantedHalfWidth half of what it shows, metres, finite
   * @param wantedHalfHeight half of what it shows, metres, finite
   * @param playerToFollow whose body it looks at while the player has none, or -1
   */
  void look(
      float centreX,
      float centreY,
      float wantedHalfWidth,
      float wantedHalfHeight,
      int playerToFollow) {
    followed = playerToFollow;
    spectatorX = centreX;
    spectatorY = centreY;
    halfWidth = Math.max(LEAST, Math.min(limit, wantedHalfWidth));
    halfHeight = Math.max(LEAST, Math.min(limit, wantedHalfHeight));
  }

  /** Moves to where the player is, and offers the encoder what may have come into view. */
  void update(FrameState frame, SnapshotEncoder to) {
    follow(frame);
    touchedCount = 0;
    if (ownSlot >= 0) {
      player.entity().body().forEachContact(touch);
    }
    if (player.team() != team || everyone != sawAll) {
      team = player.team();
      sawAll = everyone;
      encoder = to;
      index.special(frame, notice); // what rests, too, is shown to others now
    }
    if (everything || frame.tick() < nextLook) {
      return;
    }
    nextLook = frame.tick() + lookTicks;
    encoder = to;
    index.query(frame, x - halfWidth, y - halfHeight, x + halfWidth, y + halfHeight, notice);
    index.special(frame, notice);
    if (ownSlot >= 0) {
      to.notice(ownSlot);
    }
  }

  /** Moves to where the player is, which is all that {@link #hears} needs. */
  void follow(FrameState frame) {
    HostEntity own = player.entity();
    ownSlot = own == null ? -1 : own.id();
    HostEntity middle = own == null ? followedBody() : own;
    if (middle != null) {
      spectatorX = middle.body().x(); // without a body the player goes on looking at where it was
      spectatorY = middle.body().y();
    }
    x = spectatorX;
    y = spectatorY;
    few = automatic && frame.count() <= (few ? FEW : FEW_AGAIN);
    everyone = seesAll();
    everything = everyone || (!index.viewsAreNarrow() && (smallLevel || few));
  }

  /** Returns the body that the client wants to follow, if the game lets it; or null. */
  private HostEntity followedBody() {
    SimulationHost s = index.simulation();
    HostPlayer other = followed < 0 ? null : s.player(followed);
    HostEntity body = other == null ? null : other.entity();
    return body != null && s.game().mayFollow(s, player, other) ? body : null;
  }

  @Override
  public boolean everything() {
    return everything;
  }

  @Override
  public boolean sees(FrameState frame, int slot, boolean known) {
    if (slot == ownSlot) {
      return true;
    }
    if (FrameCapture.audience(frame, slot) == Audience.NEAR) {
      return everything || distance(frame, slot) <= (known ? STAY : 1);
    }
    return mayKnow(frame, slot);
  }

  @Override
  public long stay(FrameState frame, int word, long slots) {
    if (!everything) {
      return Interest.super.stay(frame, word, slots);
    }
    long result = slots;
    for (long rest = slots; rest != 0; rest &= rest - 1) {
      int slot = (word << 6) + Long.numberOfTrailingZeros(rest);
      boolean near = FrameCapture.audience(frame, slot) == Audience.NEAR;
      result ^= near || sees(frame, slot, true) ? 0 : Long.lowestOneBit(rest);
    }
    return result;
  }

  /**
   * Returns whether the player is told of an event. The player that caused it is always told.
   * Others are told as the game says; of an event {@link Audience#NEAR}, if its place is in sight
   * and none of its entities, nor the body of the player that caused it, was hidden at its tick.
   */
  boolean hears(FrameRing frames, EventRecord event, int recipients) {
    Audience audience = FrameCapture.audienceOf(recipients);
    if (event.player == player.id() && audience != Audience.NOBODY) {
      return true;
    }
    return switch (audience) {
      case ALL -> true;
      case TEAM -> FrameCapture.teamOf(recipients) == player.team() || seesAll();
      case OWNER, NOBODY -> seesAll();
      case NEAR ->
          isNear(event)
              && mightKnow(frames, event.tick, event.first)
              && mightKnow(frames, event.tick, event.second)
              && mightKnow(frames, event.tick, bodyOf(event.player));
    };
  }

  private int bodyOf(int id) {
    HostPlayer other = id < 0 ? null : index.simulation().player(id);
    HostEntity body = other == null ? null : other.entity();
    return body == null ? EventRecord.NONE : Neighbourhood.key(body.id(), body.generation());
  }

  private boolean isNear(EventRecord event) {
    return everything
        || (Math.abs(Quantizer.positionOf(event.x) - x) <= STAY * halfWidth
            && Math.abs(Quantizer.positionOf(event.y) - y) <= STAY * halfHeight);
  }

  /** Returns whether an entity wasn't hidden at a tick, or if it went in it, at the tick before. */
  private boolean mightKnow(FrameRing frames, int tick, int key) {
    if (key < 0) {
      return true;
    }
    FrameState frame = frames.at(tick);
    if (!holds(frame, key)) {
      frame = frames.at(tick - 1);
    }
    return !holds(frame, key) || mayKnow(frame, Neighbourhood.id(key));
  }

  private static boolean holds(FrameState frame, int key) {
    int slot = Neighbourhood.id(key);
    return frame != null
        && slot < frame.slotLimit()
        && frame.alive(slot)
        && frame.generation(slot) == Neighbourhood.generation(key);
  }

  /**
   * Returns whether the game lets the player know of an entity, wherever it is. An entity that
   * isn't in the frame is hidden, because the game hasn't been asked yet.
   */
  boolean mayKnow(FrameState frame, HostEntity e) {
    return holds(frame, Neighbourhood.key(e.id(), e.generation())) && mayKnow(frame, e.id());
  }

  private boolean mayKnow(FrameState frame, int slot) {
    Audience audience = FrameCapture.audience(frame, slot);
    if (audience == Audience.NEAR || audience == Audience.ALL || isOwn(slot)) {
      return true;
    }
    return switch (audience) {
      case TEAM -> FrameCapture.team(frame, slot) == player.team() || seesAll();
      case OWNER -> frame.owner(slot) == player.id() || seesAll();
      default -> seesAll();
    };
  }

  private boolean isOwn(int slot) {
    return player.entity() != null && player.entity().id() == slot;
  }

  private boolean seesAll() {
    return index.simulation().game().seesAll(index.simulation(), player);
  }

  /**
   * Returns the distance from the middle of the view to the entity's edge; 1 at the border of the
   * view.
   */
  private float distance(FrameState frame, int slot) {
    float reach = index.reach(frame, slot);
    float dx = Math.abs(Quantizer.positionOf(frame.x(slot)) - x) - reach;
    float dy = Math.abs(Quantizer.positionOf(frame.y(slot)) - y) - reach;
    return Math.max(0, Math.max(dx / halfWidth, dy / halfHeight));
  }

  private static float speed(Body<HostEntity> body) {
    return Math.max(Math.abs(body.velocityX()), Math.abs(body.velocityY()));
  }

  @Override
  public float priority(FrameState frame, int slot) {
    float distance = distance(frame, slot);
    float near = 1 / (1 + FAR * distance * distance);
    float size = Math.min(MAX_SIZE_FACTOR, Math.max(1, index.reach(frame, slot) / SIZE));
    HostEntity entity = index.simulation().entity(slot);
    float speed = entity == null ? 0 : speed(entity.body());
    float moving = Math.min(MAX_SPEED_FACTOR, 1 + speed / SPEED);
    float priority = near * size * moving;
    if (slot == ownSlot) {
      return priority * OWN;
    }
    for (int i = 0; i < touchedCount; i++) {
      if (touched[i] == slot) {
        return priority * TOUCHED;
      }
    }
    return priority;
  }
}

package carom.client.desktop.hud;

/**
 * Gives each panel of the HUD a place of its own in a picture. A panel gets the first of its
 * possible spots that is free of other panels and of the own body. A panel stays at its spot until
 * something comes near, so that it doesn't jump to and fro. Points, origin bottom left. Render
 * thread only; no allocation per picture.
 */
public final class HudLayout {
  /** A place at the window's edge. Parts at one spot stand below or above each other. */
  public enum Spot {
    /** The upper edge, in the middle. */
    TOP,
    /** The upper left corner. */
    TOP_LEFT,
    /** The upper right corner. */
    TOP_RIGHT,
    /** The lower edge, in the middle. */
    BOTTOM,
    /** The lower left corner. */
    BOTTOM_LEFT,
    /** The lower right corner. */
    BOTTOM_RIGHT;

    boolean isTop() {
      return ordinal() < BOTTOM.ordinal();
    }

    float x(float windowWidth, float width) {
      return switch (this) {
        case TOP, BOTTOM -> (windowWidth - width) / 2;
        case TOP_LEFT, BOTTOM_LEFT -> EDGE;
        case TOP_RIGHT, BOTTOM_RIGHT -> windowWidth - width - EDGE;
      };
    }
  }

  /** A panel of the HUD, which remembers where it stood. */
  public static final class Panel {
    private final Spot[] spots;
    private Spot spot;
    private float x;
    private float y;

    /** Creates a panel that may stand at some spots, the best one first. */
    public Panel(Spot... spots) {
      this.spots = spots.clone();
    }

    /** Returns its left edge. */
    public float x() {
      return x;
    }

    /** Returns its lower edge. */
    public float y() {
      return y;
    }
  }

  private static final float EDGE = 8;
  private static final float GAP = 6;

  /** Distance from the own body at which a panel leaves. */
  private static final float NEAR = 6;

  /** Distance from the own body that a panel needs to come. */
  private static final float FAR = 50;

  private final FreePlaces taken = new FreePlaces();
  private float floor;
  private float width;
  private float height;
  private boolean hasBody;
  private float bodyX;
  private float bodyY;
  private float bodyRadius;

  /** Sets a height at the lower edge that stays free of all panels, points. */
  public void floor(float points) {
    floor = points;
  }

  /** Begins a picture: everything is free. */
  void begin(float windowWidth, float windowHeight) {
    width = windowWidth;
    height = windowHeight;
    hasBody = false;
    taken.clear();
  }

  /** Keeps a disc free, because the own body is there. */
  void keepFree(float x, float y, float radius) {
    hasBody = true;
    bodyX = x;
    bodyY = y;
    bodyRadius = radius;
  }

  /** Takes a rectangle that is drawn at a fixed place. */
  public void take(float x, float y, float w, float h) {
    taken.take(x, y, w, h);
  }

  /**
   * Places a panel; its size may change from picture to picture.
   *
   * @return false when there is no room, so that it can't be drawn
   */
  public boolean place(Panel panel, float w, float h) {
    if (panel.spot != null && stands(panel, panel.spot, w, h, NEAR)) {
      return true;
    }
    for (Spot spot : panel.spots) {
      if (stands(panel, spot, w, h, FAR)) {
        return true;
      }
    }
    for (Spot spot : panel.spots) {
      if (stands(panel, spot, w, h, NEAR)) {
        return true;
      }
    }
    return false;
  }

  /** Places a panel that the player needs now, over the own body if there is no other room. */
  public boolean placeAnyhow(Panel panel, float w, float h) {
    if (place(panel, w, h)) {
      return true;
    }
    boolean had = hasBody;
    hasBody = false;
    boolean stands = place(panel, w, h);
    hasBody = had;
    return stands;
  }

  /** Puts a panel at a spot, past those that stand there, if it then is in the window and free. */
  private boolean stands(Panel panel, Spot spot, float w, float h, float clearance) {
    float x = spot.x(width, w);
    float y = spot.isTop() ? height - EDGE - h : floor + EDGE;
    for (int other = taken.at(x, y, w, h); other >= 0; other = taken.at(x, y, w, h)) {
      y = spot.isTop() ? taken.bottom(other) - GAP - h : taken.top(other) + GAP;
    }
    boolean inside = x >= 0 && x + w <= width && y >= floor && y + h <= height;
    if (!inside || coversBody(x, y, w, h, clearance)) {
      return false;
    }
    panel.spot = spot;
    panel.x = x;
    panel.y = y;
    taken.take(x, y, w, h);
    return true;
  }

  private boolean coversBody(float x, float y, float w, float h, float clearance) {
    float reach = bodyRadius + clearance;
    return hasBody
        && bodyX > x - reach
        && bodyX < x + w + reach
        && bodyY > y - reach
        && bodyY < y + h + reach;
  }
}

package carom.client.desktop.game;

import carom.client.desktop.hud.PlayerColours;
import carom.client.desktop.paint.Canvas;
import carom.client.desktop.paint.PictureParts;
import carom.client.desktop.paint.ShapePainter;
import carom.client.desktop.paint.UiColours;
import carom.client.view.ClientView;
import carom.client.view.ClientView.Drawn;
import carom.client.view.JointView;
import carom.game.Games;
import carom.physics.Body;
import carom.physics.JointType;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Segment;
import carom.physics.geometry.Shape;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.field.Ratio;
import carom.sim.level.Appearance;
import carom.sim.level.Archetype;
import carom.sim.level.Area;
import carom.sim.level.Level;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.graphics.OrthographicCamera;
import com.badlogic.gdx.math.Affine2;
import com.badlogic.gdx.math.MathUtils;
import com.badlogic.gdx.math.Matrix4;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** Draws a level and everything that moves in it, in metres. Render thread only. */
public final class WorldPainter {
  private static final float GRID_M = 2;
  private static final float SHADOW_X_M = 0.10f;
  private static final float SHADOW_Y_M = -0.14f;
  private static final float EDGE_M = 0.07f;

  /** Width of the rim in a player's own colour, metres. */
  private static final float RIM_M = 0.16f;

  /** Distance between the marks of a conveyor belt, and their size, metres. */
  private static final float BELT_STEP_M = 0.8f;

  private static final float BELT_MARK_M = 0.2f;

  /** Opacity of sensors. */
  private static final float SENSOR = 0.25f;

  /** Speed from which a body draws a streak behind it, m/s. */
  private static final float STREAK_M_S = 10.5f;

  /** Speed of the most visible streak, m/s. */
  private static final float STREAK_FULL_M_S = 20;

  private static final float STREAK_SECONDS = 0.11f; // of its way

  /** Depths of the strata of ground under a chain, and how far it shows below the level, metres. */
  private static final float TURF_M = 0.35f;

  private static final float SOIL_M = 1.4f;
  private static final float BELOW_M = 60;

  private final Canvas canvas;
  private final PictureParts parts;
  private final PlayerColours colours;
  private final ShapePainter shapes;
  private final JointPainter joints;
  private final AreaPainter areas;
  private final PoolPainter pools;
  private final Impacts impacts;
  private final LookPainter look;
  private final Splashes splashes = new Splashes();
  private final CooldownRings cooldowns = new CooldownRings();
  private final float[] streak = new float[6];
  private final float[] stratum = new float[8];
  private final Color fill = new Color();
  private final Color edge = new Color();
  private final Color detail = new Color();
  private final Affine2 affine = new Affine2();
  private final Matrix4 bend = new Matrix4();
  private final Matrix4 bent = new Matrix4();
  private final List<Scenery> scenery = new ArrayList<>();
  private Level sceneryOf;
  private boolean hasTeams;

  WorldPainter(Canvas canvas, PictureParts parts, PlayerColours colours, LookPainter look) {
    this.look = look;
    impacts = new Impacts(look.effects());
    this.canvas = canvas;
    this.colours = colours;
    this.parts = parts;
    shapes = new ShapePainter(canvas);
    joints = new JointPainter(canvas);
    areas = new AreaPainter(canvas);
    pools = new PoolPainter(canvas);
  }

  /**
   * Draws the picture of this moment. {@code seconds} runs on steadily, for what pulses; {@code
   * deltaSeconds} have passed since the last picture.
   */
  void draw(
      ClientView view,
      Flashes flashes,
      OrthographicCamera camera,
      float pixelsPerMetre,
      float seconds,
      float deltaSeconds) {
    Level level = view.level();
    parts.run("scenery", () -> gather(level));
    parts.run("impacts", () -> impacts.update(view, deltaSeconds));
    parts.run("splashes", () -> splashes.update(view, deltaSeconds));
    parts.run("flashes", () -> flashes.age(deltaSeconds));
    look.update(view, deltaSeconds, this::rgb);
    canvas.begin(camera.combined, pixelsPerMetre);
    parts.run("backdrop", () -> backdrop(level, camera));
    between(camera, pixelsPerMetre, () -> look.backgrounds(camera));
    parts.run("zones", () -> zones(level));
    parts.run("areas behind", () -> areasBehind(view, seconds));
    parts.run("shadows", () -> shadows(view));
    if (view.pools() != null) {
      parts.run("water and sand", () -> pools.draw(view.pools(), camera, pixelsPerMetre));
    }
    parts.run("scenery", () -> scenery(level, seconds));
    between(camera, pixelsPerMetre, () -> behindBodies(view, camera));
    parts.run("streaks", () -> streaks(view));
    parts.run("bodies", () -> bodies(view, camera, pixelsPerMetre, seconds));
    between(camera, pixelsPerMetre, () -> look.bodies(view, camera, this::rgb));
    parts.run("joints", () -> joints(view, pixelsPerMetre));
    parts.run("areas before", () -> areasBefore(view, seconds));
    parts.run("waits", () -> cooldowns.draw(view, canvas, deltaSeconds));
    parts.run("splashes", () -> splashes.draw(canvas));
    parts.run("impacts", () -> impacts.draw(canvas));
    parts.run("flashes", () -> flashes.draw(canvas));
    canvas.end();
    look.particles(camera, true);
  }

  /** Forgets what bodies did, as they are those of another moment now. */
  void forget() {
    impacts.clear();
    splashes.clear();
    look.clear();
  }

  /** Draws what a game's look has between the figures. */
  private void between(OrthographicCamera camera, float pixelsPerMetre, Runnable drawn) {
    if (look.isPlain()) {
      return;
    }
    canvas.end();
    drawn.run();
    canvas.begin(camera.combined, pixelsPerMetre);
  }

  private void behindBodies(ClientView view, OrthographicCamera camera) {
    look.shadows(view, camera);
    look.pieces(
        camera,
        () -> {
          for (Scenery s : scenery) {
            look.piece(s.archetype(), s.x(), s.y(), MathUtils.atan2(s.sin(), s.cos()));
          }
        });
    look.particles(camera, false);
  }

  private int rgb(Drawn drawn) {
    return bodyRgb(playerRgb(drawn), drawn);
  }

  /** Returns the pieces of the level that is drawn. Do not change the list. */
  List<Scenery> scenery() {
    return scenery;
  }

  private void scenery(Level level, float seconds) {
    for (Scenery s : scenery) {
      ground(s, level.bounds().minY() - BELOW_M);
    }
    for (Scenery s : scenery) {
      if (look.paints(s.archetype())) {
        continue;
      }
      shapes.pose(s.x(), s.y(), s.cos(), s.sin());
      boolean glows = s.archetype().appearance().look() == Appearance.Look.BUMPER;
      paint(
          s.archetype(),
          s.archetype().appearance().rgb(),
          1,
          seconds,
          glows ? glow(s.archetype(), s.x(), s.y()) : 0);
    }
  }

  /** Draws the ground under the lines of chains whose front is above, unless they look plain. */
  private void ground(Scenery s, float bottom) {
    if (s.archetype().appearance().look() == Appearance.Look.PLAIN) {
      return;
    }
    shapes.pose(s.x(), s.y(), s.cos(), s.sin());
    int rgb = s.archetype().appearance().rgb();
    for (Shape shape : s.archetype().shapes()) {
      for (Convex part : shape.parts()) {
        if (part instanceof Segment line && line.isOneSided()) {
          ground(line, 0, TURF_M, UiColours.shade(rgb, 1.1f, 1, fill), bottom);
          ground(line, TURF_M, SOIL_M, UiColours.shade(rgb, 0.8f, 1, fill), bottom);
          ground(line, SOIL_M, Float.MAX_VALUE, UiColours.shade(rgb, 0.62f, 1, fill), bottom);
        }
      }
    }
  }

  /** Draws a stratum below a line, from one depth to another, at most down to a height. */
  private void ground(Segment line, float from, float to, Color colour, float bottom) {
    float x0 = shapes.worldX(line.vertexX(1), line.vertexY(1)); // a line runs with its front right
    float x1 = shapes.worldX(line.vertexX(0), line.vertexY(0));
    if (x1 <= x0) {
      return;
    }
    float y0 = shapes.worldY(line.vertexX(1), line.vertexY(1));
    float y1 = shapes.worldY(line.vertexX(0), line.vertexY(0));
    stratum[0] = x0;
    stratum[1] = Math.max(bottom, y0 - to);
    stratum[2] = x1;
    stratum[3] = Math.max(bottom, y1 - to);
    stratum[4] = x1;
    stratum[5] = y1 - from;
    stratum[6] = x0;
    stratum[7] = y0 - from;
    canvas.convex(stratum, 4, colour);
  }

  private void streaks(ClientView view) {
    for (int i = 0; i < view.entityCount(); i++) {
      streak(view.entity(i));
    }
  }

  private void bodies(
      ClientView view, OrthographicCamera camera, float pixelsPerMetre, float seconds) {
    Drawn own = view.own();
    for (int i = 0; i < view.entityCount(); i++) {
      Drawn drawn = view.entity(i);
      if (look.paints(drawn.archetype())) {
        if (drawn == own) {
          pose(drawn, 0, 0);
          halo(drawn, extent(drawn.archetype()), seconds);
        }
        continue;
      }
      Reactions.Shown reaction = look.reaction(drawn);
      if (reaction == null || !reaction.isBent()) {
        body(drawn, reaction, view, seconds);
      } else {
        canvas.end();
        bent.set(camera.combined);
        bent.mul(bend.set(reaction.bend(drawn.x(), drawn.y(), affine)));
        canvas.begin(bent, pixelsPerMetre);
        body(drawn, reaction, view, seconds);
        canvas.end();
        canvas.begin(camera.combined, pixelsPerMetre);
      }
    }
  }

  private void body(Drawn drawn, Reactions.Shown reaction, ClientView view, float seconds) {
    pose(drawn, 0, 0);
    float glow = glow(drawn.archetype(), drawn.x(), drawn.y());
    int chosen = playerRgb(drawn);
    paint(drawn.archetype(), bodyRgb(chosen, drawn), drawn.alpha(), seconds, glow);
    if (drawn.archetype().appearance().look() == Appearance.Look.PLAYER) {
      if (chosen >= 0 && hasTeams) {
        rim(drawn, chosen);
      }
      face(drawn, drawn == view.own(), view, seconds);
    }
    float flash = reaction == null ? 0 : reaction.flash();
    if (flash > 0) {
      UiColours.shade(reaction.flashRgb(), 1, flash * drawn.alpha(), detail);
      for (Shape shape : drawn.archetype().shapes()) {
        shapes.fill(shape, detail);
      }
    }
  }

  private void shadows(ClientView view) {
    for (Scenery s : scenery) {
      if (!s.archetype().sensor()) {
        shapes.pose(s.x() + SHADOW_X_M, s.y() + SHADOW_Y_M, s.cos(), s.sin());
        shadow(s.archetype(), 1);
      }
    }
    for (int i = 0; i < view.entityCount(); i++) {
      Drawn drawn = view.entity(i);
      if (!look.paints(drawn.archetype())) {
        pose(drawn, SHADOW_X_M, SHADOW_Y_M);
        shadow(drawn.archetype(), drawn.alpha());
      }
    }
  }

  private void joints(ClientView view, float pixelsPerMetre) {
    joints.begin(pixelsPerMetre);
    for (int i = 0; i < view.jointCount(); i++) {
      JointView j = view.joint(i);
      if (j.type() == JointType.PULLEY) {
        joints.pulley(
            j.ax(),
            j.ay(),
            j.groundAX(),
            j.groundAY(),
            j.groundBX(),
            j.groundBY(),
            j.bx(),
            j.by(),
            j.alpha());
      } else {
        joints.draw(j.type(), j.ax(), j.ay(), j.bx(), j.by(), j.isSprung(), j.rest(), j.alpha());
      }
    }
  }

  private void areasBehind(ClientView view, float seconds) {
    areas.frame(0, 0, 1, 0);
    areas.power(1);
    for (Area area : view.level().areas()) {
      areas.behind(area, seconds);
    }
    for (int i = 0; i < view.entityCount(); i++) {
      Drawn drawn = view.entity(i);
      if (drawn.archetype().area() != null) {
        frame(view, drawn);
        areas.behind(drawn.archetype().area(), seconds);
      }
    }
  }

  private void areasBefore(ClientView view, float seconds) {
    areas.frame(0, 0, 1, 0);
    areas.power(1);
    for (Area area : view.level().areas()) {
      areas.before(area, seconds);
    }
    for (int i = 0; i < view.entityCount(); i++) {
      Drawn drawn = view.entity(i);
      if (drawn.archetype().area() != null) {
        frame(view, drawn);
        areas.before(drawn.archetype().area(), seconds);
      }
    }
  }

  private void frame(ClientView view, Drawn drawn) {
    Ratio power = drawn.archetype().areaPower();
    areas.power(power == null || !view.knowsFields() ? 1 : view.fields(drawn).get(power));
    areas.frame(drawn.x(), drawn.y(), MathUtils.cos(drawn.angle()), MathUtils.sin(drawn.angle()));
  }

  private float glow(Archetype archetype, float x, float y) {
    return impacts.glow(x, y, extent(archetype));
  }

  /** Draws a fading wedge behind a fast ball or a dashing player. */
  private void streak(Drawn drawn) {
    Appearance looks = drawn.archetype().appearance();
    float vx = drawn.velocityX();
    float vy = drawn.velocityY();
    float speed = (float) Math.sqrt(vx * vx + vy * vy);
    boolean shows = looks.look() == Appearance.Look.BALL || looks.look() == Appearance.Look.PLAYER;
    if (!shows || speed < STREAK_M_S || look.hasTrail(drawn.archetype())) {
      return;
    }
    int rgb = bodyRgb(playerRgb(drawn), drawn);
    float radius = 0.9f * extent(drawn.archetype());
    float nx = -vy / speed * radius;
    float ny = vx / speed * radius;
    float share = Math.min(1, 0.3f + 0.7f * (speed - STREAK_M_S) / (STREAK_FULL_M_S - STREAK_M_S));
    for (int layer = 1; layer <= 2; layer++) {
      streak[0] = drawn.x() + nx;
      streak[1] = drawn.y() + ny;
      streak[2] = drawn.x() - vx * STREAK_SECONDS * layer;
      streak[3] = drawn.y() - vy * STREAK_SECONDS * layer;
      streak[4] = drawn.x() - nx;
      streak[5] = drawn.y() - ny;
      canvas.convex(streak, 3, UiColours.shade(rgb, 1.2f, 0.22f * share * drawn.alpha(), fill));
    }
  }

  /** Reads the static bodies that a simulation makes of the level. */
  private void gather(Level level) {
    if (level == sceneryOf) {
      return;
    }
    sceneryOf = level;
    scenery.clear();
    forget();
    SimulationHost still =
        new SimulationHost(Games.create(level.gameName()), level, 0, 60, Role.PREDICTION);
    still.world().forEachBody(this::gather);
    hasTeams = !still.game().teams().isEmpty();
    checkLook(still);
  }

  private void checkLook(SimulationHost still) {
    Set<String> things = new HashSet<>();
    scenery.forEach(s -> things.add(s.archetype().name()));
    for (int i = 0; i < still.archetypes().size(); i++) {
      things.add(still.archetypes().get(i).name());
    }
    Set<String> events = new HashSet<>();
    for (int i = 0; i < still.eventKinds().size(); i++) {
      events.add(still.eventKinds().get(i).name());
    }
    Set<String> named = new HashSet<>();
    sceneryOf.zones().forEach(zone -> named.add(zone.name()));
    look.check(things, events, named);
  }

  private void gather(Body<HostEntity> body) {
    if (body.user().isLevel()) {
      scenery.add(new Scenery(body.user().archetype(), body.x(), body.y(), body.cos(), body.sin()));
    }
  }

  private void backdrop(Level level, OrthographicCamera camera) {
    float left = camera.position.x - camera.viewportWidth / 2;
    float bottom = camera.position.y - camera.viewportHeight / 2;
    canvas.gradient(
        left,
        bottom,
        camera.viewportWidth,
        camera.viewportHeight,
        UiColours.shade(level.theme().background(), 1, 1, fill),
        UiColours.shade(level.theme().sky(), 1, 1, edge));
    Level.Bounds b = level.bounds();
    if (!look.hasBackground()) {
      Color grid = UiColours.shade(level.theme().grid(), 1, 0.4f, fill);
      canvas.grid(b.minX(), b.minY(), b.maxX(), b.maxY(), GRID_M, grid);
    }
  }

  private void zones(Level level) {
    for (Level.Zone zone : level.zones()) {
      if (zone.rgb() >= 0) {
        zone(zone);
      }
    }
  }

  private void zone(Level.Zone zone) {
    float width = zone.maxX() - zone.minX();
    float height = zone.maxY() - zone.minY();
    canvas.rect(
        zone.minX(), zone.minY(), width, height, UiColours.shade(zone.rgb(), 1, 0.22f, fill));
    UiColours.shade(zone.rgb(), 1, 0.7f, fill);
    canvas.frame(zone.minX(), zone.minY(), width, height, EDGE_M, fill);
  }

  private void pose(Drawn drawn, float dx, float dy) {
    shapes.pose(
        drawn.x() + dx, drawn.y() + dy, MathUtils.cos(drawn.angle()), MathUtils.sin(drawn.angle()));
  }

  private void shadow(Archetype archetype, float alpha) {
    fill.set(UiColours.SHADOW).a *= alpha;
    for (Shape shape : archetype.shapes()) {
      shapes.fill(shape, fill);
    }
  }

  /** Returns the colour of a body's player; -1 if it has none, or is no player's. */
  private int playerRgb(Drawn drawn) {
    boolean isPlayer = drawn.archetype().appearance().look() == Appearance.Look.PLAYER;
    return isPlayer ? colours.rgb(drawn.ownerId()) : -1;
  }

  private int bodyRgb(int chosen, Drawn drawn) {
    return chosen >= 0 && !hasTeams ? chosen : drawn.archetype().appearance().rgb();
  }

  /** Draws a rim in the colour of a player whose body has that of the team. */
  private void rim(Drawn drawn, int rgb) {
    UiColours.shade(rgb, 1, drawn.alpha(), detail);
    for (Shape shape : drawn.archetype().shapes()) {
      shapes.outline(shape, RIM_M, detail);
    }
  }

  private void paint(Archetype archetype, int rgb, float alpha, float seconds, float glow) {
    Appearance look = archetype.appearance();
    if (archetype.sensor() && look.look() == Appearance.Look.PLAIN) {
      alpha *= SENSOR;
    }
    UiColours.shade(rgb, 1 + 0.6f * glow, alpha, fill);
    UiColours.shade(look.outlineRgb(), 1, alpha, edge);
    for (Shape shape : archetype.shapes()) {
      shapes.paint(shape, fill, EDGE_M, edge);
    }
    for (int i = 0; i < archetype.shapes().size(); i++) {
      float speed = archetype.materials().get(i).tangentSpeed();
      for (Convex part : archetype.shapes().get(i).parts()) {
        detail(look, part, alpha, seconds);
        if (speed != 0 && part instanceof Box box) {
          UiColours.shade(look.rgb(), 1.5f, alpha, detail);
          belt(box, speed * seconds, 1);
          belt(box, -speed * seconds, -1);
        }
      }
    }
  }

  /** Draws slanted marks along the upper (side 1) or lower (side -1) edge of a conveyor belt. */
  private void belt(Box box, float moved, int side) {
    float left = box.vertexX(0);
    float inset = Math.min(BELT_MARK_M, box.halfHeight());
    float outer = box.vertexY(side > 0 ? 2 : 0);
    float inner = outer - side * inset;
    float first = ((moved % BELT_STEP_M) + BELT_STEP_M) % BELT_STEP_M;
    float lean = Math.signum(moved) * inset;
    for (float at = first; at < 2 * box.halfWidth() - inset; at += BELT_STEP_M) {
      float from = left + Math.max(at, inset);
      canvas.line(
          shapes.worldX(from - lean, outer),
          shapes.worldY(from - lean, outer),
          shapes.worldX(from, inner),
          shapes.worldY(from, inner),
          EDGE_M,
          detail);
    }
  }

  private void detail(Appearance look, Convex part, float alpha, float seconds) {
    float radius = extent(part);
    UiColours.shade(look.rgb(), 1.35f, alpha, detail);
    float x = shapes.worldX(0, 0);
    float y = shapes.worldY(0, 0);
    switch (look.look()) {
      case BALL -> {
        // Three spots that turn with it, so that rolling shows.
        for (int i = 0; i < 3; i++) {
          float angle = i * MathUtils.PI2 / 3;
          float px = MathUtils.cos(angle) * radius * 0.55f;
          float py = MathUtils.sin(angle) * radius * 0.55f;
          canvas.disc(shapes.worldX(px, py), shapes.worldY(px, py), radius * 0.2f, edge);
        }
      }
      case CRATE -> {
        float h = radius * 0.62f;
        canvas.line(
            shapes.worldX(-h, -h),
            shapes.worldY(-h, -h),
            shapes.worldX(h, h),
            shapes.worldY(h, h),
            EDGE_M * 1.4f,
            edge);
        canvas.line(
            shapes.worldX(-h, h),
            shapes.worldY(-h, h),
            shapes.worldX(h, -h),
            shapes.worldY(h, -h),
            EDGE_M * 1.4f,
            edge);
      }
      case BUMPER -> {
        float pulse = 0.55f + 0.06f * MathUtils.sin(seconds * 3 + x);
        canvas.ring(x, y, radius * pulse, EDGE_M * 1.6f, detail);
        canvas.disc(x, y, radius * 0.22f, detail);
      }
      case COIN -> canvas.ring(x, y, radius * 0.72f, EDGE_M, detail);
      case LAMP -> canvas.disc(x, y, radius * 0.5f, detail);
      default -> {
        if (part instanceof Circle && look.look() == Appearance.Look.PLAIN) {
          canvas.line(x, y, shapes.worldX(radius, 0), shapes.worldY(radius, 0), EDGE_M, edge);
        }
      }
    }
  }

  /** Draws two eyes that look where the player goes or aims, and a halo around the own body. */
  private void face(Drawn drawn, boolean own, ClientView view, float seconds) {
    float radius = extent(drawn.archetype());
    float angle = own ? view.input().aim() : drawn.angle();
    if (!own
        && drawn.velocityX() * drawn.velocityX() + drawn.velocityY() * drawn.velocityY() > 0.3f) {
      angle = MathUtils.atan2(drawn.velocityY(), drawn.velocityX());
    }
    float cos = MathUtils.cos(angle);
    float sin = MathUtils.sin(angle);
    for (int side = -1; side <= 1; side += 2) {
      float px = drawn.x() + radius * (0.42f * cos - 0.3f * side * sin);
      float py = drawn.y() + radius * (0.42f * sin + 0.3f * side * cos);
      canvas.disc(px, py, radius * 0.24f, UiColours.shade(0xffffff, 1, drawn.alpha(), detail));
      canvas.disc(
          px + radius * 0.09f * cos,
          py + radius * 0.09f * sin,
          radius * 0.12f,
          UiColours.shade(0x10141c, 1, drawn.alpha(), detail));
    }
    if (own) {
      halo(drawn, radius, seconds);
    }
  }

  private void halo(Drawn drawn, float radius, float seconds) {
    UiColours.shade(0xffffff, 1, 0.7f + 0.25f * MathUtils.sin(seconds * 4), detail);
    for (Shape shape : drawn.archetype().shapes()) {
      if (shape instanceof Circle) {
        canvas.ring(drawn.x(), drawn.y(), radius * 1.3f, EDGE_M, detail);
      } else {
        shapes.outline(shape, EDGE_M, detail);
      }
    }
  }

  /** Returns half of the smaller side of an archetype's first shape, metres. */
  public static float extent(Archetype archetype) {
    return extent(archetype.shapes().get(0).parts().get(0));
  }

  private static float extent(Convex part) {
    if (part instanceof Circle circle) {
      return circle.radius();
    }
    if (part instanceof Box box) {
      return Math.min(box.halfWidth(), box.halfHeight());
    }
    return 0.4f;
  }
}

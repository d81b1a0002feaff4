package carom.client.look;

import carom.physics.math.Limits;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;

/**
 * Receives what a {@link GameView} declares, and hands it to what draws. Methods that declare throw
 * {@link IllegalArgumentException} for what can't be meant.
 */
public final class ViewSetup {
  /** Most sprites, and most of anything else that is declared one by one. */
  public static final int MAX = 500;

  private final List<Action> actions = new ArrayList<>();
  private final List<Sprite> sprites = new ArrayList<>();
  private final List<Background> backgrounds = new ArrayList<>();
  private final Map<String, List<Effect>> events = new HashMap<>();
  private final Map<String, List<Effect>> blows = new HashMap<>();
  private final Map<String, Particles> trails = new HashMap<>();
  private final CameraSetup camera = new CameraSetup();
  private final List<HudItem> hud = new ArrayList<>();
  private HudItem.Place minimap;
  private final Set<String> marks = new TreeSet<>();
  private HudPainter painter;
  private String music = "";

  /** Creates the set-up of a view that declares nothing, which is the usual look. */
  public ViewSetup() {}

  /**
   * Adds actions. The buttons of a view take the place of all usual buttons, its movements and its
   * aim that of the usual ones. The player can change the keys, and sees them beside the body in
   * the first minute.
   */
  public void actions(Action... added) {
    List<Action> all = new ArrayList<>(actions);
    all.addAll(Range.all("action", added));
    Set<String> names = new HashSet<>();
    for (Action action : all) {
      for (Action.Binding binding : action.bindings()) {
        if (!names.add(binding.name())) {
          throw new IllegalArgumentException(
              "action=\"" + binding.name() + "\" is there already; give each a name of its own");
        }
      }
    }
    requireOneMovement(all);
    actions.clear();
    actions.addAll(all);
  }

  private static void requireOneMovement(List<Action> all) {
    List<Action> moving = new ArrayList<>(all);
    moving.removeIf(a -> a.kind() == Action.Kind.BUTTON || a.kind() == Action.Kind.AIM);
    for (Action action : moving) {
      if (action.kind() == Action.Kind.POINT && moving.size() > 1) {
        throw new IllegalArgumentException(
            "action=\"" + action.name() + "\": a place is the whole movement; declare no other");
      }
    }
  }

  /** Returns the actions in the order in which they were declared. Do not change the list. */
  public List<Action> actions() {
    return actions;
  }

  private static <T> T limited(int present, T added) {
    if (present >= MAX) {
      throw new IllegalArgumentException(added.getClass().getSimpleName() + ": more than " + MAX);
    }
    return added;
  }

  /**
   * Adds a picture for each entity of an archetype, in place of its shapes.
   *
   * @param archetype its name; that of a level's piece or body works, too
   * @param file name of a PNG or JPEG file, as {@link Class#getResource} finds it: beside the
   *     view's class, or with a leading slash from the jar's root
   */
  public Sprite sprite(String archetype, String file) {
    Sprite sprite = limited(sprites.size(), new Sprite(archetype, file));
    sprites.add(sprite);
    return sprite;
  }

  /** Adds a picture behind the level, before those that were added earlier. */
  public Background background(String file) {
    Background background = limited(backgrounds.size(), new Background(file));
    backgrounds.add(background);
    return background;
  }

  /**
   * Adds what an event sets off. Particles take the place of the event's ring, sounds that of its
   * usual sound; its word stays.
   *
   * @param name of the kind of event
   */
  public void event(String name, Effect... effects) {
    List<Effect> all = Range.all("effect", effects);
    events
        .computeIfAbsent(
            Limits.notNull("name", name), n -> limited(events.size(), new ArrayList<>()))
        .addAll(all);
  }

  /**
   * Adds what a blow to a body sets off, in place of the usual sparks.
   *
   * @param archetype name of the body's archetype
   * @throws IllegalArgumentException for a {@link SlowMotion}, which only an event has
   */
  public void blow(String archetype, Effect... effects) {
    List<Effect> all = Range.all("effect", effects);
    if (hasSlowMotion(all)) {
      throw new IllegalArgumentException(
          "blow=\"" + archetype + "\" can't have a slow motion; declare it for an event");
    }
    blows
        .computeIfAbsent(
            Limits.notNull("archetype", archetype), n -> limited(blows.size(), new ArrayList<>()))
        .addAll(all);
  }

  /** Returns whether any event is shown again in slow motion. */
  public boolean hasSlowMotion() {
    return events.values().stream().anyMatch(ViewSetup::hasSlowMotion);
  }

  private static boolean hasSlowMotion(List<Effect> effects) {
    return effects.stream().anyMatch(SlowMotion.class::isInstance);
  }

  /** Sets what bodies of an archetype leave behind them, in place of the usual streak. */
  public void trail(String archetype, Particles particles) {
    Limits.notNull("archetype", archetype);
    trails.put(archetype, limited(trails.size(), Limits.notNull("particles", particles)));
  }

  /** Returns what the window shows of the level, to be changed. */
  public CameraSetup camera() {
    return camera;
  }

  /** Adds lines about the own player, in place of the game's own bars and numbers. */
  public void hud(HudItem... lines) {
    List<HudItem> all = Range.all("line", lines);
    limited(hud.size() + all.size() - 1, this);
    hud.addAll(all);
  }

  /**
   * Shows the whole level with its players, small, at a place, unless the picture shows it all.
   *
   * @param marked names of archetypes whose entities are on it, too, such as a flag or a ball. A
   *     client knows those far away only if their audience is all players
   */
  public void minimap(HudItem.Place place, String... marked) {
    Limits.notNull("place", place);
    List<String> all = Range.all("marked", marked);
    minimap = place;
    marks.clear();
    marks.addAll(all);
  }

  /** Sets what draws over each picture of the window. Browsers don't have it. */
  public void paint(HudPainter over) {
    painter = Limits.notNull("painter", over);
  }

  /** Returns what draws over each picture; null for nothing. */
  public HudPainter painter() {
    return painter;
  }

  /** Returns where the minimap stands; null for none. */
  public HudItem.Place minimap() {
    return minimap;
  }

  /** Returns the names of archetypes whose entities are on the minimap. Do not change the set. */
  public Set<String> marks() {
    return marks;
  }

  /** Returns the lines about the own player in their order. Do not change the list. */
  public List<HudItem> hud() {
    return hud;
  }

  /** Sets the music of the game, a {@code .wav} or {@code .ogg} file that is played on and on. */
  public void music(String file) {
    SoundFile.requireSound(file);
    music = file;
  }

  /** Returns the file of the music; empty for none. */
  public String music() {
    return music;
  }

  /** Returns the sprites. Do not change the list. */
  public List<Sprite> sprites() {
    return sprites;
  }

  /** Returns the backgrounds, the furthest first. Do not change the list. */
  public List<Background> backgrounds() {
    return backgrounds;
  }

  /** Returns what an event sets off; null for the usual. */
  public List<Effect> event(String name) {
    return events.get(name);
  }

  /** Returns what a blow to an archetype's body sets off; null for the usual. */
  public List<Effect> blow(String archetype) {
    return blows.get(archetype);
  }

  /** Returns what an archetype's bodies leave behind them; null for the usual. */
  public Particles trail(String archetype) {
    return trails.get(archetype);
  }

  /** Returns whether bodies, backdrop, events and blows have the usual look. */
  public boolean isPlain() {
    return sprites.isEmpty() && backgrounds.isEmpty() && effects().isEmpty() && trails.isEmpty();
  }

  /** Returns what events and blows set off. */
  public List<Effect> effects() {
    List<Effect> all = new ArrayList<>();
    events.values().forEach(all::addAll);
    blows.values().forEach(all::addAll);
    return all;
  }

  /** Returns the files of all pictures that are declared, in order. */
  public Set<String> pictures() {
    Set<String> files = new TreeSet<>();
    sprites.forEach(sprite -> files.add(sprite.file()));
    backgrounds.forEach(background -> files.add(background.file()));
    hud.stream()
        .filter(line -> line.kind() == HudItem.Kind.ICONS)
        .forEach(l -> files.add(l.label()));
    List<Effect> flying = effects();
    flying.addAll(trails.values());
    for (Effect effect : flying) {
      if (effect instanceof Particles particles && !particles.picture().isEmpty()) {
        files.add(particles.picture());
      }
    }
    return files;
  }

  /** Returns the names of archetypes and pieces that are declared anything for, in order. */
  public Set<String> things() {
    Set<String> names = new TreeSet<>(blows.keySet());
    names.addAll(trails.keySet());
    names.addAll(marks);
    sprites.forEach(sprite -> names.add(sprite.archetype()));
    return names;
  }

  /** Returns the names of kinds of events that are declared anything for, in order. */
  public Set<String> events() {
    return new TreeSet<>(events.keySet());
  }
}

package carom.client.look;

import carom.sim.field.Choice;
import carom.sim.field.Countdown;
import carom.sim.field.EntityRef;
import carom.sim.field.Field;
import carom.sim.field.Flag;
import carom.sim.field.FloatField;
import carom.sim.field.PlayerRef;
import carom.sim.field.Ratio;
import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** Writes what a view declares as JSON, for painters that can't load its class. One thread. */
final class LookWriter {
  private final Map<String, String> files;
  private final JsonGenerator json;

  private LookWriter(JsonGenerator json, Map<String, String> files) {
    this.json = json;
    this.files = files;
  }

  /** Writes one item of a list. */
  @FunctionalInterface
  private interface Part<T> {
    void write(T item) throws IOException;
  }

  /**
   * Returns the JSON of a look, as UTF-8.
   *
   * @param files by their names in the view, those that the JSON shall have
   */
  static byte[] write(String game, ViewSetup v, Map<String, String> files) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try (JsonGenerator json = new JsonFactory().createGenerator(out)) {
      new LookWriter(json, files).look(game, v);
    } catch (IOException e) {
      throw new UncheckedIOException(e); // can't happen in memory
    }
    return out.toByteArray();
  }

  private void look(String game, ViewSetup v) throws IOException {
    json.writeStartObject();
    json.writeStringField("game", game);
    list("actions", v.actions(), this::action);
    list("sprites", v.sprites(), this::sprite);
    list("backgrounds", v.backgrounds(), this::background);
    json.writeObjectFieldStart("events");
    for (String name : v.events()) {
      // The page keeps no pictures, so it shows none again.
      list(
          name,
          v.event(name).stream().filter(e -> !(e instanceof SlowMotion)).toList(),
          this::effect);
    }
    json.writeEndObject();
    json.writeObjectFieldStart("blows");
    for (String name : v.things()) {
      if (v.blow(name) != null) {
        list(name, v.blow(name), this::effect);
      }
    }
    json.writeEndObject();
    json.writeObjectFieldStart("trails");
    for (String name : v.things()) {
      if (v.trail(name) != null) {
        json.writeFieldName(name);
        effect(v.trail(name));
      }
    }
    json.writeEndObject();
    json.writeObjectFieldStart("camera");
    number("height", v.camera().height());
    number("lead", v.camera().leadSeconds());
    json.writeBooleanField("all", v.camera().isFramingAll());
    texts("zones", v.camera().zones());
    value("condition", v.camera().condition());
    number("otherHeight", v.camera().otherHeight());
    json.writeEndObject();
    list("hud", v.hud(), this::line);
    json.writeStringField("minimap", v.minimap() == null ? "" : v.minimap().name());
    texts("marks", List.copyOf(v.marks()));
    json.writeStringField("music", v.music().isEmpty() ? "" : files.get(v.music()));
    json.writeEndObject();
  }

  private <T> void list(String name, Collection<T> items, Part<T> part) throws IOException {
    json.writeArrayFieldStart(name);
    for (T item : items) {
      part.write(item);
    }
    json.writeEndArray();
  }

  private void texts(String name, List<String> texts) throws IOException {
    list(name, texts, json::writeString);
  }

  private void number(String name, float value) throws IOException {
    json.writeFieldName(name);
    if (value == Math.rint(value) && Math.abs(value) < 1e7f) {
      json.writeNumber((int) value);
    } else {
      json.writeNumber(Float.toString(value));
    }
  }

  private void range(String name, float least, float most) throws IOException {
    json.writeArrayFieldStart(name);
    json.writeNumber(Float.toString(least));
    json.writeNumber(Float.toString(most));
    json.writeEndArray();
  }

  private void file(String name, String file) throws IOException {
    json.writeStringField(name, file.isEmpty() ? "" : files.get(file));
  }

  private void action(Action a) throws IOException {
    json.writeStartObject();
    json.writeStringField("kind", a.kind().name());
    json.writeNumberField("button", a.button());
    json.writeNumberField("range", a.range());
    list(
        "bindings",
        a.bindings(),
        binding -> {
          json.writeStartObject();
          json.writeStringField("name", binding.name());
          texts("keys", binding.keys());
          json.writeEndObject();
        });
    texts("mouse", a.mouse());
    texts("pad", a.pad());
    texts("sticks", a.sticks());
    json.writeEndObject();
  }

  private void sprite(Sprite s) throws IOException {
    json.writeStartObject();
    json.writeStringField("archetype", s.archetype());
    file("file", s.file());
    number("width", s.width());
    number("height", s.height());
    number("x", s.offsetX());
    number("y", s.offsetY());
    json.writeNumberField("frames", s.frames());
    number("perSecond", s.framesPerSecond());
    number("perMetre", s.framesPerMetre());
    value("by", s.frameBy());
    json.writeStringField("turn", s.turn().name());
    json.writeBooleanField("flips", s.isFlipping());
    json.writeBooleanField("tiled", s.isTiled());
    json.writeBooleanField("tint", s.isTinted());
    json.writeNumberField("rgb", s.rgb());
    json.writeEndObject();
  }

  private void background(Background b) throws IOException {
    json.writeStartObject();
    file("file", b.file());
    number("height", b.height());
    number("parallax", b.parallax());
    if (!Float.isNaN(b.bottom())) {
      number("bottom", b.bottom());
    }
    number("driftX", b.driftX());
    number("driftY", b.driftY());
    number("alpha", b.alpha());
    json.writeEndObject();
  }

  private void effect(Effect effect) throws IOException {
    json.writeStartObject();
    if (effect instanceof Particles p) {
      json.writeStringField("kind", "PARTICLES");
      json.writeNumberField("count", p.count());
      range("speed", p.speed(0), p.speed(1));
      range("seconds", p.seconds(0), p.seconds(1));
      range("size", p.size(0), p.size(1));
      json.writeNumberField("rgb", p.rgbAtFirst());
      json.writeNumberField("rgbAtLast", p.rgbAtLast());
      number("alpha", p.alpha());
      number("gravity", p.gravity());
      number("drag", p.drag());
      number("spread", p.spread());
      json.writeBooleanField("glows", p.isGlowing());
      file("picture", p.picture());
    } else if (effect instanceof Reaction r) {
      json.writeStringField("kind", "REACTION");
      number("squash", r.squash());
      number("hold", r.hold());
      json.writeNumberField("flash", r.flashRgb());
      number("seconds", r.seconds());
    } else if (effect instanceof Shake s) {
      json.writeStringField("kind", "SHAKE");
      number("metres", s.metres());
      number("seconds", s.seconds());
    } else if (effect instanceof SoundFile s) {
      json.writeStringField("kind", "SOUND");
      texts("files", s.files().stream().map(files::get).toList());
      number("volume", s.volume());
      range("pitch", s.pitch(0), s.pitch(1));
    }
    json.writeEndObject();
  }

  private void line(HudItem h) throws IOException {
    json.writeStartObject();
    json.writeStringField("kind", h.kind().name());
    boolean hasIcons = h.kind() == HudItem.Kind.ICONS;
    json.writeStringField("label", hasIcons ? files.get(h.label()) : h.label());
    value("value", h.value());
    value("condition", h.condition());
    json.writeStringField("place", h.place().name());
    json.writeNumberField("rgb", h.rgb());
    if (h.scale() != 1) {
      number("scale", h.scale());
    }
    if (h.decimals() != 0) {
      json.writeNumberField("decimals", h.decimals());
    }
    json.writeEndObject();
  }

  /** Writes which field a value comes from, and what it may be. */
  private void value(String name, ShownValue value) throws IOException {
    if (value == null) {
      json.writeNullField(name);
      return;
    }
    Field<?> field = value.field();
    boolean real = field instanceof FloatField<?>;
    json.writeObjectFieldStart(name);
    json.writeStringField("scope", field.scope().holder().name().toLowerCase(Locale.ROOT));
    json.writeStringField("field", field.name());
    json.writeStringField(
        "type",
        field instanceof Countdown
            ? "COUNTDOWN"
            : field instanceof Flag
                ? "FLAG"
                : field instanceof PlayerRef || field instanceof EntityRef
                    ? "REFERENCE"
                    : field instanceof Choice<?>
                        ? "CHOICE"
                        : field instanceof Ratio ? "RATIO" : real ? "REAL" : "COUNT");
    json.writeNumberField("least", real ? 0 : field.min());
    json.writeNumberField("most", real ? 1 : field.max());
    if (field instanceof Choice<?>) {
      json.writeArrayFieldStart("choices");
      for (int word = 0; word <= field.max(); word++) {
        json.writeString(field.value(word).toString());
      }
      json.writeEndArray();
    }
    json.writeEndObject();
  }
}

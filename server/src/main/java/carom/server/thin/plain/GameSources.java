package carom.server.thin.plain;

import carom.server.thin.GameClasses;
import carom.server.thin.GameClasses.GameClass;
import carom.server.thin.GameClasses.GameField;
import carom.sim.message.Argument;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.StringJoiner;
import java.util.TreeMap;

/** Writes a game's messages as Java 8 classes for programs with stock KryoNet. */
public final class GameSources {
  private GameSources() {}

  /**
   * Returns the sources by the names of their classes.
   *
   * @param inPackage name of their package
   * @param game name of the game, for comments
   */
  public static Map<String, String> of(GameClasses classes, String inPackage, String game) {
    Map<String, String> sources = new TreeMap<>();
    StringBuilder lines = new StringBuilder();
    for (GameClass c : classes.all()) {
      lines.append("    kryo.register(").append(c.name()).append(".class);\n");
      for (GameField field : c.fields()) {
        if (field.argument().type() == Argument.Type.CHOICE) {
          lines.append("    kryo.register(%s.%s.class);\n".formatted(c.name(), field.type()));
        }
      }
      sources.put(c.name(), ascii(source(c, inPackage)));
    }
    String registry =
        """
        package %s;

        /**
         * Registers the messages of game %s for stock KryoNet. Written by carom plain, as all of this package.
         */
        public final class %s {
          /** Digest of these classes, for {@code carom.plain.Join.digest}. */
          public static final String DIGEST = "%s";

          private Messages() {}

          /** Registers all messages; call it right after {@code carom.plain.Plain.register}. */
          public static void register(com.esotericsoftware.kryo.Kryo kryo) {
        %s  }
        }
        """
            .formatted(inPackage, comment(game), GameClasses.REGISTRY, classes.digest(), lines);
    sources.put(GameClasses.REGISTRY, ascii(registry));
    return sources;
  }

  private static String source(GameClass c, String inPackage) {
    StringBuilder text = new StringBuilder();
    text.append("package ").append(inPackage).append(";\n\n");
    String from =
        switch (c.kind().direction()) {
          case FROM_CLIENT -> "sent by clients";
          case FROM_SERVER -> "sent by the server";
          case BOTH -> "sent by clients and the server";
        };
    text.append(doc("", "A message %s, %s".formatted(comment(c.kind().name()), from)));
    text.append("public final class ").append(c.name()).append(" {\n");
    for (GameField field : c.fields()) {
      text.append(doc("  ", meaning(field.argument())));
      text.append("  public %s %s = %s;\n\n".formatted(field.type(), field.name(), initial(field)));
    }
    text.append(doc("  ", "Creates one to be filled in"));
    text.append("  public ").append(c.name()).append("() {}\n");
    if (!c.fields().isEmpty()) {
      StringJoiner parameters = new StringJoiner(", ");
      c.fields().forEach(field -> parameters.add(field.type() + " " + field.name()));
      text.append('\n').append(doc("  ", "Creates one"));
      text.append("  public ").append(c.name()).append("(").append(parameters).append(") {\n");
      for (GameField field : c.fields()) {
        text.append("    this.%s = %s;\n".formatted(field.name(), field.name()));
      }
      text.append("  }\n");
    }
    for (GameField field : c.fields()) {
      if (field.argument().type() == Argument.Type.CHOICE) {
        List<String> constants = new ArrayList<>();
        field
            .constants()
            .forEach(name -> constants.add(doc("    ", comment(name)) + "    " + name));
        text.append('\n').append(doc("  ", "Values of " + field.name()));
        text.append("  public enum ").append(field.type()).append(" {\n");
        text.append(String.join(",\n", constants)).append("\n  }\n");
      }
    }
    return text.append("}\n").toString();
  }

  private static String doc(String indent, String sentence) {
    return indent + "/" + "** " + sentence + ". */\n";
  }

  private static String meaning(Argument a) {
    return switch (a.type()) {
      case PLAYER -> "Id of a player, or -1";
      case ENTITY -> "Id of a body, or -1";
      case CHOICE -> "One of the values";
      case TEXT -> "Text of at most " + a.max() + " characters";
      case FLAG -> "True or false";
      case COUNT -> "Number " + a.min() + ".." + a.max();
      case REAL -> "Number " + Float.intBitsToFloat(a.min()) + ".." + Float.intBitsToFloat(a.max());
    };
  }

  /** Returns a value that the server takes. */
  private static String initial(GameField field) {
    Argument a = field.argument();
    return switch (a.type()) {
      case PLAYER, ENTITY -> "-1";
      case CHOICE -> field.type() + "." + field.constants().get(0);
      case TEXT -> "\"\"";
      case FLAG -> "false";
      case COUNT -> String.valueOf(Math.max(a.min(), Math.min(a.max(), 0)));
      case REAL ->
          Math.max(Float.intBitsToFloat(a.min()), Math.min(Float.intBitsToFloat(a.max()), 0)) + "f";
    };
  }

  private static String comment(String text) {
    return text.replaceAll("[^\\p{L}\\p{N} .:-]", "_");
  }

  /** Returns a source that a compiler reads alike in every encoding. */
  private static String ascii(String source) {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < source.length(); i++) {
      char c = source.charAt(i);
      text.append(c < 0x80 ? String.valueOf(c) : String.format(Locale.ROOT, "\\u%04x", (int) c));
    }
    return text.toString();
  }
}

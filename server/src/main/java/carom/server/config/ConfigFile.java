package carom.server.config;

import carom.text.TextFile;
import com.typesafe.config.Config;
import com.typesafe.config.ConfigException;
import com.typesafe.config.ConfigFactory;
import com.typesafe.config.ConfigList;
import com.typesafe.config.ConfigParseOptions;
import com.typesafe.config.ConfigSyntax;
import com.typesafe.config.ConfigValue;
import com.typesafe.config.ConfigValueType;
import java.io.IOException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** Reads a file of settings, written in HOCON: {@code name = value} lines with comments. */
final class ConfigFile {
  private ConfigFile() {}

  /**
   * The value of a setting in a layer.
   *
   * @param texts one text, or several for a setting that may be repeated
   * @param origin place for people, such as {@code data/carom.conf: 12}
   */
  record Value(List<String> texts, String origin) {}

  /**
   * Returns the values of a file by name.
   *
   * @throws BadSettingException if the file can't be read; the message says what to do
   */
  static Map<String, Value> read(Path file) throws BadSettingException {
    String text;
    try {
      text = TextFile.read(file, TextFile.MAX_BYTES);
    } catch (NoSuchFileException e) {
      throw unreadable(file, "there is no such file; carom-server --print-config writes one", e);
    } catch (IOException e) {
      throw unreadable(file, e.getMessage() + "; name a text file that this user may read", e);
    }
    try {
      ConfigParseOptions strict =
          ConfigParseOptions.defaults()
              .setSyntax(ConfigSyntax.CONF)
              .setAllowMissing(false)
              .setOriginDescription(file.toString());
      return values(ConfigFactory.parseString(text, strict).resolve());
    } catch (ConfigException e) {
      throw new BadSettingException(explain(file, e), e);
    }
  }

  private static BadSettingException unreadable(Path file, String why, Exception cause) {
    return new BadSettingException("config=" + file + " can't be read: " + why, cause);
  }

  /** Returns where a file is wrong. The library's own message may quote what stands there. */
  private static String explain(Path file, ConfigException e) {
    String place =
        e.origin() == null || e.origin().lineNumber() < 1
            ? file.toString()
            : file + ": " + e.origin().lineNumber();
    return place
        + ": this can't be read; lines look like tick-rate = 60, texts with spaces need \"quotes\"";
  }

  private static Map<String, Value> values(Config config) throws BadSettingException {
    Map<String, Value> values = new TreeMap<>();
    for (Map.Entry<String, ConfigValue> entry : config.root().entrySet()) {
      ConfigValue value = entry.getValue();
      String origin = value.origin().description();
      if (value.valueType() == ConfigValueType.OBJECT) {
        throw new BadSettingException(
            "%s: %s has a block or a dot in its name, settings are plain lines: name = value"
                .formatted(origin, entry.getKey()));
      }
      if (value.valueType() == ConfigValueType.LIST) {
        List<String> texts =
            ((ConfigList) value).stream().map(each -> String.valueOf(each.unwrapped())).toList();
        values.put(entry.getKey(), new Value(texts, origin));
      } else if (value.valueType() != ConfigValueType.NULL) {
        String text = String.valueOf(value.unwrapped());
        values.put(entry.getKey(), new Value(List.of(text), origin));
      }
    }
    return values;
  }
}

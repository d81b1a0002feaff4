package carom.docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.lang.reflect.Field;
import java.lang.reflect.Method;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * Goal: a game developer who writes what a sentence of a page names compiles. Method: every {@code
 * Type.member} in the prose of the pages for developers is a public member of a type of that name.
 * Snippets are compiled by other tests.
 */
final class NamesTest {
  private static final Path ROOT = Path.of("..").toAbsolutePath().normalize();
  private static final List<String> MODULES = List.of("shared", "client", "server", "testkit");
  private static final Pattern CODE = Pattern.compile("`([^`]+)`");
  private static final Pattern MEMBER = Pattern.compile("(?<![\\w./])([A-Z]\\w+)\\.([a-z]\\w*)");

  private static Map<String, List<Class<?>>> types() throws Exception {
    Map<String, List<Class<?>>> types = new HashMap<>();
    for (String module : MODULES) {
      Path sources = ROOT.resolve(module).resolve("src/main/java");
      for (Path file : files(sources, ".java")) {
        String name = sources.relativize(file).toString().replaceAll("\\.java$", "");
        if (!name.endsWith("-info")) {
          Class<?> type =
              Class.forName(
                  name.replace('/', '.').replace('\\', '.'),
                  false,
                  NamesTest.class.getClassLoader());
          types.computeIfAbsent(type.getSimpleName(), none -> new ArrayList<>()).add(type);
        }
      }
    }
    return types;
  }

  private static List<Path> files(Path folder, String ending) throws IOException {
    try (Stream<Path> files = Files.walk(folder)) {
      return files.filter(file -> file.toString().endsWith(ending)).sorted().toList();
    }
  }

  private static Set<String> members(List<Class<?>> types) {
    Set<String> members = new TreeSet<>();
    for (Class<?> type : types) {
      members.addAll(Stream.of(type.getMethods()).map(Method::getName).toList());
      members.addAll(Stream.of(type.getFields()).map(Field::getName).toList());
    }
    return members;
  }

  /** Returns the text outside of fenced snippets. */
  private static String prose(Path page) throws IOException {
    String[] parts = Files.readString(page).split("(?m)^```");
    return Stream.iterate(0, i -> i < parts.length, i -> i + 2)
        .map(i -> parts[i])
        .collect(Collectors.joining("\n"));
  }

  @Test
  void everyMemberThatAPageNamesIsThere() throws Exception {
    Map<String, List<Class<?>>> types = types();
    Set<String> wrong = new TreeSet<>();
    int named = 0;
    List<Path> pages = new ArrayList<>(files(ROOT.resolve("docs/games"), ".md"));
    pages.addAll(files(ROOT.resolve("docs/engine"), ".md"));
    for (Path page : pages) {
      Matcher code = CODE.matcher(prose(page));
      while (code.find()) {
        Matcher member = MEMBER.matcher(code.group(1));
        while (member.find()) {
          List<Class<?>> meant = types.get(member.group(1));
          if (meant != null) {
            named++;
            if (!members(meant).contains(member.group(2))) {
              wrong.add(page.getFileName() + ": " + member.group());
            }
          }
        }
      }
    }
    assertTrue(named > 100, "pages name " + named);
    assertEquals(Set.of(), wrong);
  }
}

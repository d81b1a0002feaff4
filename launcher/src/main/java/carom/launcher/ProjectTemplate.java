package carom.launcher;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.zip.ZipEntry;
import java.util.zip.ZipInputStream;

/**
 * The project {@code docs/starter}, which comes packed, under another name. In its files and their
 * names, {@code hill} stands for the name of the game and nothing else.
 */
final class ProjectTemplate {
  private static final String PACKED = "starter.zip";
  private static final String NAME = "hill";
  private static final String TITLE = "Hill";

  private final String name;
  private final String title;

  /**
   * Creates it.
   *
   * @param name lower-case letters and digits
   */
  ProjectTemplate(String name) {
    this.name = name;
    title = name.substring(0, 1).toUpperCase(Locale.ROOT) + name.substring(1);
  }

  /**
   * Writes the project.
   *
   * @param project folder, empty or not there
   * @param repository where both build tools find Carom's artifacts; null for where they look
   *     anyhow
   */
  void layOut(Path project, Path repository) throws IOException {
    try (ZipInputStream zip = new ZipInputStream(packed())) {
      for (ZipEntry entry = zip.getNextEntry(); entry != null; entry = zip.getNextEntry()) {
        if (!entry.isDirectory()) {
          String text = new String(zip.readAllBytes(), StandardCharsets.UTF_8);
          write(project.resolve(named(entry.getName())), named(text));
        }
      }
    }
    project.resolve("gradlew").toFile().setExecutable(true, false);
    write(project.resolve(".gitignore"), ".gradle/\nbuild/\ntarget/\n");
    if (repository != null) {
      write(
          project.resolve("gradle.properties"),
          "# Where this machine has Carom's artifacts.\ncaromRepository="
              + repository.toUri()
              + "\n");
      write(
          project.resolve(".mvn/maven.config"), "-Dcarom.repository=" + repository.toUri() + "\n");
    }
  }

  private static InputStream packed() {
    InputStream packed = ProjectTemplate.class.getResourceAsStream(PACKED);
    if (packed == null) {
      throw new IllegalStateException("this build lacks " + PACKED);
    }
    return packed;
  }

  private static void write(Path file, String text) throws IOException {
    Files.createDirectories(file.getParent());
    Files.writeString(file, text);
  }

  private String named(String text) {
    return text.replace(NAME, name).replace(TITLE, title);
  }
}

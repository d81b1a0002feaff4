package carom.suite;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** What came of the tests of one class. */
final class ClassReport {
  private final TestClass testClass;
  private final List<TestEvent> tests = new ArrayList<>();
  private String running;
  private double seconds;
  private double cpuSeconds;

  ClassReport(TestClass testClass) {
    this.testClass = testClass;
  }

  void add(TestEvent event) {
    switch (event.kind()) {
      case STARTED -> running = event.test();
      case CLASS_DONE -> {
        seconds = event.seconds();
        cpuSeconds = event.cpuSeconds();
      }
      default -> {
        running = null;
        tests.add(event);
      }
    }
  }

  /** Adds a failure of the test that runs, or of the class if none does. */
  TestEvent broken(String reason, double afterSeconds) {
    seconds = afterSeconds;
    String test = running == null ? "the class" : running;
    TestEvent event = new TestEvent(TestEvent.Kind.FAILED, test, afterSeconds, 0, reason);
    add(event);
    return event;
  }

  String name() {
    return testClass.name();
  }

  double seconds() {
    return seconds;
  }

  double cpuSeconds() {
    return cpuSeconds;
  }

  int tests() {
    return tests.size();
  }

  int count(TestEvent.Kind kind) {
    return (int) tests.stream().filter(test -> test.kind() == kind).count();
  }

  /** Writes the class's results as JUnit's XML, which tools read. */
  void write(Path folder) throws IOException {
    StringBuilder xml = new StringBuilder("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    xml.append(
        String.format(
            Locale.ROOT,
            "<testsuite name=\"%s\" tests=\"%d\" skipped=\"%d\" failures=\"%d\" errors=\"0\""
                + " time=\"%.3f\">%n",
            name(),
            tests.size(),
            count(TestEvent.Kind.SKIPPED),
            count(TestEvent.Kind.FAILED),
            seconds));
    for (TestEvent test : tests) {
      xml.append(
          String.format(
              Locale.ROOT,
              "  <testcase name=\"%s\" classname=\"%s\" time=\"%.3f\"",
              escape(test.test()),
              name(),
              test.seconds()));
      switch (test.kind()) {
        case FAILED -> xml.append("><failure>").append(escape(test.text())).append("</failure>");
        case SKIPPED ->
            xml.append("><skipped message=\"").append(escape(test.text())).append("\"/>");
        default -> xml.append('>');
      }
      xml.append("</testcase>\n");
    }
    xml.append("</testsuite>\n");
    String part =
        testClass.isOfTheClass() ? "" : "-" + testClass.part().name().toLowerCase(Locale.ROOT);
    Files.writeString(folder.resolve("TEST-" + name() + part + ".xml"), xml);
  }

  /** Replaces what XML 1.0 can't hold. */
  private static String escape(String text) {
    StringBuilder escaped = new StringBuilder(text.length());
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      switch (c) {
        case '&' -> escaped.append("&amp;");
        case '<' -> escaped.append("&lt;");
        case '>' -> escaped.append("&gt;");
        case '"' -> escaped.append("&quot;");
        case '\n', '\t' -> escaped.append(c);
        default -> escaped.append(c < ' ' || c >= 0xd800 && c < 0xe000 || c > 0xfffd ? '?' : c);
      }
    }
    return escaped.toString();
  }
}

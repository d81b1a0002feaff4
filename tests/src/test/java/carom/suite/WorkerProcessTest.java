package carom.suite;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.MethodOrderer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestMethodOrder;
import org.junit.jupiter.api.io.TempDir;

/** Goal: no test class hides what became of it or of others. Method: classes that do it. */
@Needs("processes")
final class WorkerProcessTest {
  @TestMethodOrder(MethodOrderer.MethodName.class)
  static class Mixed {
    @Test
    void fails() {
      fail("as <it> should");
    }

    @Test
    void isSkipped() {
      assumeTrue(false, "nothing to do");
    }

    @Alone("nothing")
    @Test
    void isAlone() {}

    @Needs("nothing")
    @Test
    void needsNothing() {}

    @Test
    void passes() {}
  }

  @TestMethodOrder(MethodOrderer.MethodName.class)
  static class Halting {
    @Test
    void aPasses() {}

    @Test
    void bHalts() {
      Runtime.getRuntime().halt(7);
    }
  }

  static class Hanging {
    @Test
    void waitsForever() throws InterruptedException {
      new CountDownLatch(1).await();
    }
  }

  @TempDir private Path folder;

  private ClassReport run(
      WorkerProcess worker, Class<?> type, String methods, TestClass.Part part, int seconds)
      throws Exception {
    List<TestEvent> told = new ArrayList<>();
    ClassReport report =
        worker.run(
            new TestClass(type.getName(), methods, part, false),
            seconds,
            (r, event) -> told.add(event));
    report.write(folder);
    assertFalse(told.isEmpty());
    return report;
  }

  private String xml(Class<?> type) throws Exception {
    return Files.readString(folder.resolve("TEST-" + type.getName() + ".xml"));
  }

  @Test
  void whatPassesFailsAndIsSkippedIsTold() throws Exception {
    try (WorkerProcess worker =
        new WorkerProcess(folder.resolve("output.txt"), true, false, List.of())) {
      ClassReport beside = run(worker, Mixed.class, "", TestClass.Part.COMPUTING, 600);
      assertEquals(3, beside.tests());
      assertEquals(1, beside.count(TestEvent.Kind.FAILED));
      assertEquals(1, beside.count(TestEvent.Kind.SKIPPED));
      String xml = xml(Mixed.class);
      assertTrue(xml.contains("tests=\"3\" skipped=\"1\" failures=\"1\""), xml);
      assertTrue(xml.contains("as &lt;it&gt; should"), xml);
      assertEquals(1, run(worker, Mixed.class, "", TestClass.Part.ALONE, 600).tests());
      assertEquals(1, run(worker, Mixed.class, "", TestClass.Part.NEEDING, 600).tests());
      assertEquals(
          2, run(worker, Mixed.class, "pass.*|fails", TestClass.Part.COMPUTING, 600).tests());
      assertTrue(worker.usable());
    }
  }

  @Test
  void aTestThatEndsItsProcessFailsByNameAndTheOnesBeforeArePassed() throws Exception {
    try (WorkerProcess worker =
        new WorkerProcess(folder.resolve("output.txt"), true, false, List.of())) {
      ClassReport report = run(worker, Halting.class, "", TestClass.Part.COMPUTING, 600);
      assertEquals(1, report.count(TestEvent.Kind.PASSED));
      assertEquals(1, report.count(TestEvent.Kind.FAILED));
      String xml = xml(Halting.class);
      assertTrue(xml.contains("name=\"bHalts\""), xml);
      assertTrue(xml.contains("ended in it, with exit value 7"), xml);
      assertFalse(worker.usable());
    }
  }

  @Test
  void aTestThatHangsFailsByNameAndTellsWhereItWas() throws Exception {
    String xml = "";
    // On a busy machine a class may not have begun after five seconds.
    for (int seconds = 5; !xml.contains("waitsForever") && seconds <= 80; seconds *= 4) {
      try (WorkerProcess worker =
          new WorkerProcess(folder.resolve("output.txt"), false, false, List.of())) {
        ClassReport report = run(worker, Hanging.class, "", TestClass.Part.COMPUTING, seconds);
        assertEquals(1, report.count(TestEvent.Kind.FAILED));
        xml = xml(Hanging.class);
        assertTrue(xml.contains("still ran after " + seconds + " s"), xml);
        assertFalse(worker.usable());
      }
    }
    assertTrue(xml.contains("waitsForever") && xml.contains("CountDownLatch.await"), xml);
  }
}

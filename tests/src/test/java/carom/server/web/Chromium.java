package carom.server.web;

import carom.text.Json;
import carom.text.JsonException;
import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.http.WebSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A headless Chromium with one page, driven over the DevTools protocol: what a person would do and
 * see. Errors of the page, such as exceptions and what its security policy forbids, are collected.
 */
public final class Chromium implements AutoCloseable {
  private static final List<String> NAMES =
      List.of("chromium", "chromium-browser", "google-chrome", "chrome");
  private static final Pattern LISTENING = Pattern.compile("DevTools listening on ws://([^/]+)/");
  private static final Pattern ANSWER = Pattern.compile("\\{\"id\":(\\d+)");
  private static final Pattern LINE_BREAK = Pattern.compile("(?<!\\\\)((?:\\\\\\\\)*)\\\\[nrt]");
  private static final String DATA = "\"data\":\"";
  private static final long ANSWER_S = 60;

  private final Process process;
  private final WebSocket socket;
  private final AtomicInteger ids = new AtomicInteger();
  private final Map<Integer, CompletableFuture<String>> waiting = new ConcurrentHashMap<>();
  private final List<String> errors = new CopyOnWriteArrayList<>();

  private Chromium(Process process, String debugger) {
    this.process = process;
    socket =
        HttpClient.newHttpClient()
            .newWebSocketBuilder()
            .buildAsync(URI.create(debugger), new Messages())
            .join();
  }

  /** Returns the program, or null if this machine has none. */
  public static Path find() {
    for (String folder : System.getenv("PATH").split(File.pathSeparator)) {
      for (String name : NAMES) {
        Path path = Path.of(folder, name);
        if (Files.isExecutable(path)) {
          return path;
        }
      }
    }
    return null;
  }

  /**
   * Starts the program with an empty page.
   *
   * @param profile an empty folder
   */
  public static Chromium start(Path program, Path profile) throws Exception {
    ProcessBuilder builder =
        new ProcessBuilder(
            program.toString(),
            "--headless=new",
            "--no-sandbox",
            "--disable-gpu",
            "--disable-dev-shm-usage",
            "--no-first-run",
            "--disable-background-networking",
            "--disable-component-update",
            "--hide-scrollbars",
            "--remote-debugging-port=0",
            "--user-data-dir=" + profile,
            "about:blank");
    builder.redirectErrorStream(true);
    Process process = builder.start();
    BufferedReader lines = process.inputReader(StandardCharsets.UTF_8);
    for (String line; (line = lines.readLine()) != null; ) {
      Matcher matcher = LISTENING.matcher(line);
      if (matcher.find()) {
        Thread drain = new Thread(() -> lines.lines().forEach(rest -> {}), "chromium-output");
        drain.setDaemon(true);
        drain.start();
        return new Chromium(process, pageOf(matcher.group(1)));
      }
    }
    throw new IOException("the browser ended: exit code " + process.waitFor());
  }

  private static String pageOf(String address) throws Exception {
    HttpRequest list =
        HttpRequest.newBuilder(URI.create("http://" + address + "/json/list")).build();
    String text =
        HttpClient.newHttpClient().send(list, HttpResponse.BodyHandlers.ofString()).body();
    for (Json target : Json.parse(text.getBytes(StandardCharsets.UTF_8)).items) {
      if (target.fields.get("type").text.equals("page")) {
        return target.fields.get("webSocketDebuggerUrl").text;
      }
    }
    throw new IOException("no page in " + text);
  }

  private final class Messages implements WebSocket.Listener {
    private final StringBuilder text = new StringBuilder();

    @Override
    public CompletionStage<?> onText(WebSocket from, CharSequence data, boolean last) {
      text.append(data);
      if (last) {
        take(text.toString());
        text.setLength(0);
      }
      from.request(1);
      return null;
    }

    private void take(String message) {
      Matcher id = ANSWER.matcher(message);
      if (id.lookingAt()) {
        waiting.remove(Integer.valueOf(id.group(1))).complete(message);
        return;
      }
      try {
        Json event = Json.parse(message.getBytes(StandardCharsets.UTF_8));
        Json params = event.fields.get("params");
        String method = string(event, "method");
        if (method.equals("Runtime.exceptionThrown")) {
          errors.add(string(params, "exceptionDetails", "exception", "description"));
        } else if (method.equals("Log.entryAdded")
            && string(params, "entry", "level").equals("error")) {
          errors.add(string(params, "entry", "text"));
        }
      } catch (JsonException e) {
        errors.add("unreadable: " + message);
      }
    }
  }

  private static String string(Json json, String... path) {
    Json at = json;
    for (String name : path) {
      at = at == null ? null : at.fields.get(name);
    }
    return at == null ? "" : at.text;
  }

  private Json call(String method, String params) throws Exception {
    // Errors of the page have several lines; the reader of settings refuses texts of several lines.
    String answer = LINE_BREAK.matcher(ask(method, params)).replaceAll("$1 ");
    Json message = Json.parse(answer.getBytes(StandardCharsets.UTF_8));
    if (message.fields.containsKey("error")) {
      throw new IOException(method + ": " + string(message, "error", "message"));
    }
    return message.fields.get("result");
  }

  /** Sends a command and returns the answer, which may be too long to be read as JSON. */
  private String ask(String method, String params) throws Exception {
    int id = ids.incrementAndGet();
    CompletableFuture<String> answer = new CompletableFuture<>();
    waiting.put(id, answer);
    socket
        .sendText(
            String.format(
                Locale.ROOT, "{\"id\":%d,\"method\":\"%s\",\"params\":{%s}}", id, method, params),
            true)
        .get(ANSWER_S, TimeUnit.SECONDS);
    return answer.get(ANSWER_S, TimeUnit.SECONDS);
  }

  private static String quoted(String text) {
    StringBuilder out = new StringBuilder("\"");
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      out.append(
          c < ' ' || c == '"' || c == '\\' || c > '~'
              ? String.format(Locale.ROOT, "\\u%04x", (int) c)
              : c);
    }
    return out.append('"').toString();
  }

  /** Sets the size of the window in pixels, and whether the system's colours are dark. */
  public void look(int width, int height, boolean dark) throws Exception {
    call(
        "Emulation.setDeviceMetricsOverride",
        String.format(
            Locale.ROOT,
            "\"width\":%d,\"height\":%d,\"deviceScaleFactor\":1,\"mobile\":false",
            width,
            height));
    call(
        "Emulation.setEmulatedMedia",
        "\"features\":[{\"name\":\"prefers-color-scheme\",\"value\":\"%s\"}]"
            .formatted(dark ? "dark" : "light"));
  }

  /** Opens an address. */
  public void open(String url) throws Exception {
    call("Runtime.enable", "");
    call("Log.enable", "");
    call("Page.enable", "");
    call("Page.bringToFront", "");
    call("Page.navigate", "\"url\":" + quoted(url));
  }

  /** Loads the page again, and returns when a new one has begun. */
  public void reload() throws Exception {
    evaluate("window.isOld = true");
    call("Page.reload", "");
    for (boolean old = true; old; Thread.sleep(50)) {
      try {
        old = evaluate("window.isOld").equals("true");
      } catch (IOException e) {
        old = true; // the one that ends has no answer
      }
    }
  }

  /** Returns what an expression of the page is, as text. */
  public String evaluate(String expression) throws Exception {
    Json result =
        call(
            "Runtime.evaluate",
            "\"awaitPromise\":true,\"returnByValue\":true,\"expression\":"
                + quoted("String(" + expression + ")"));
    if (result.fields.containsKey("exceptionDetails")) {
      throw new IOException(
          expression + ": " + string(result, "exceptionDetails", "exception", "description"));
    }
    return string(result, "result", "value");
  }

  /**
   * Waits until an expression of the page is true, at most 20 s. One that throws isn't yet, nor is
   * any of a page that ends.
   */
  public void await(String condition) throws Exception {
    String asked =
        "(() => { try { return Boolean(" + condition + "); } catch (e) { return e; } })()";
    long endNs = System.nanoTime() + TimeUnit.SECONDS.toNanos(20);
    for (String is; !(is = evaluateOrSay(asked)).equals("true"); Thread.sleep(50)) {
      if (System.nanoTime() > endNs) {
        throw new AssertionError(
            "never: "
                + condition
                + ", it is "
                + is
                + "; errors: "
                + errors
                + "; page: "
                + evaluate("document.body.innerText.slice(0, 2000).replace(/\\s+/g, ' ')"));
      }
    }
  }

  private String evaluateOrSay(String expression) throws Exception {
    try {
      return evaluate(expression);
    } catch (IOException e) {
      return e.getMessage(); // the page goes to another one
    }
  }

  /** Clicks in the middle of an element, as a mouse does. */
  public void click(String element) throws Exception {
    String at =
        evaluate(
            "(e => { e.scrollIntoView({block: 'center'}); const r = e.getBoundingClientRect();"
                + " return (r.x + r.width / 2) + ' ' + (r.y + r.height / 2); })("
                + element
                + ")");
    clickAt(Double.parseDouble(at.split(" ")[0]), Double.parseDouble(at.split(" ")[1]));
  }

  /** Clicks at a point of the window. */
  public void clickAt(double x, double y) throws Exception {
    for (String type : List.of("mousePressed", "mouseReleased")) {
      call(
          "Input.dispatchMouseEvent",
          "\"type\":\"%s\",\"x\":%s,\"y\":%s,\"button\":\"left\",\"clickCount\":1"
              .formatted(type, x, y));
    }
  }

  /** Types into the element that has the focus. */
  public void type(String text) throws Exception {
    call("Input.insertText", "\"text\":" + quoted(text));
  }

  /** Presses a key, such as {@code Enter} or {@code Tab}. */
  public void press(String key, int code) throws Exception {
    String text = key.equals("Enter") ? ",\"text\":\"\\r\"" : "";
    for (String type : List.of("keyDown", "keyUp")) {
      call(
          "Input.dispatchKeyEvent",
          String.format(
              Locale.ROOT,
              "\"type\":\"%s\",\"key\":\"%s\",\"code\":\"%s\",\"windowsVirtualKeyCode\":%d%s",
              type,
              key,
              key,
              code,
              type.equals("keyDown") ? text : ""));
    }
  }

  /** Returns the window as PNG. */
  public byte[] screenshot() throws Exception {
    String answer = ask("Page.captureScreenshot", "\"format\":\"png\"");
    int begin = answer.indexOf(DATA) + DATA.length();
    return Base64.getDecoder().decode(answer.substring(begin, answer.indexOf('"', begin)));
  }

  /** Returns what went wrong in the page. */
  public List<String> errors() {
    return new ArrayList<>(errors);
  }

  @Override
  public void close() {
    socket.abort();
    // Its helpers outlive it for a moment, and write to the profile that the test then deletes.
    List<ProcessHandle> helpers = process.descendants().toList();
    process.destroy();
    try {
      if (!process.waitFor(10, TimeUnit.SECONDS)) {
        process.destroyForcibly().waitFor();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    for (ProcessHandle helper : helpers) {
      helper.destroyForcibly();
      helper.onExit().orTimeout(10, TimeUnit.SECONDS).exceptionally(e -> helper).join();
    }
  }

  /** Takes pictures of an address at two widths, light and dark: URL FOLDER [TOKEN]. */
  public static void main(String[] args) throws Exception {
    Path folder = Path.of(args[1]);
    try (Chromium browser = start(find(), Files.createTempDirectory("chromium"))) {
      browser.look(1280, 1100, false);
      browser.open(args[0]);
      browser.await("document.querySelector('#state.live')");
      if (args.length > 2) {
        browser.click("document.querySelector('#secret')");
        browser.type(args[2]);
        browser.press("Enter", 13);
        browser.await("document.body.classList.contains('is-admin')");
      }
      for (String script : args.length > 3 ? List.of(args[3].split(";;")) : List.<String>of()) {
        browser.evaluate(script);
        Thread.sleep(1_500);
      }
      Thread.sleep(8_000);
      for (boolean dark : new boolean[] {false, true}) {
        for (int width : new int[] {1280, 400}) {
          int height = width == 400 ? 2600 : 1300;
          browser.look(width, height, dark);
          browser.evaluate("caromScene.fit()");
          Thread.sleep(1_500);
          Files.write(
              folder.resolve("page-" + width + (dark ? "-dark" : "-light") + ".png"),
              browser.screenshot());
        }
      }
      System.out.println(browser.errors());
    }
  }
}

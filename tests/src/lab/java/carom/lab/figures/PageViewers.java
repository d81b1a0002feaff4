package carom.lab.figures;

import carom.text.Json;
import carom.text.JsonException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicLong;

/**
 * Measures what open pages cost a running server's ticks: windows without viewers and with them
 * take turns, and an observer that looks at no room reads each second's tick times. Arguments: the
 * page's address, number of viewers, pairs of windows, seconds of a window.
 */
public final class PageViewers {
  private static final int SETTLE_S = 2;
  private static final String LOOK = "{\"do\":\"look\",\"room\":\"%s\",\"contacts\":true}";
  private static final String ALIVE = "{\"do\":\"alive\"}";

  private final HttpClient client = HttpClient.newHttpClient();
  private final String url;
  private final List<double[]> seconds = new CopyOnWriteArrayList<>();
  private volatile List<String> columns = List.of();
  private volatile String room = "";
  private final AtomicLong pictureBytes = new AtomicLong();

  private PageViewers(String url) {
    this.url = url;
  }

  private WebSocket open(boolean observes) {
    return client
        .newWebSocketBuilder()
        .header("Origin", url)
        .buildAsync(URI.create(url.replace("http:", "ws:") + "/live"), new Page(observes))
        .join();
  }

  private final class Page implements WebSocket.Listener {
    private final boolean observes;
    private final StringBuilder text = new StringBuilder();

    Page(boolean observes) {
      this.observes = observes;
    }

    @Override
    public CompletionStage<?> onText(WebSocket from, CharSequence data, boolean last) {
      text.append(observes ? data : "");
      if (last && observes) {
        try {
          take(from, Json.parse(text.toString().getBytes(StandardCharsets.UTF_8)));
        } catch (JsonException e) {
          throw new IllegalStateException(e);
        }
        text.setLength(0);
      }
      from.request(1);
      return null;
    }

    @Override
    public CompletionStage<?> onBinary(WebSocket from, ByteBuffer data, boolean last) {
      pictureBytes.addAndGet(data.remaining());
      from.request(1);
      return null;
    }
  }

  private void take(WebSocket from, Json message) {
    Json rooms = message.fields.get("rooms");
    if (message.fields.get("t").text.equals("hello")) {
      columns = message.fields.get("columns").items.stream().map(column -> column.text).toList();
      room = rooms.items.get(0).fields.get("name").text;
    } else if (message.fields.get("t").text.equals("second")) {
      Json row = rooms.items.get(0).fields.get("row");
      seconds.add(row.items.stream().mapToDouble(value -> value.number).toArray());
      var unused = from.sendText(ALIVE, true);
    }
  }

  /** Returns a window's medians of the seconds' values, in the order of {@code names}. */
  private double[] window(int length, String... names) throws InterruptedException {
    Thread.sleep(1_000L * SETTLE_S);
    int begin = seconds.size();
    Thread.sleep(1_000L * length);
    List<double[]> rows = new ArrayList<>(seconds.subList(begin, seconds.size()));
    return Arrays.stream(names).mapToDouble(name -> median(rows, columns.indexOf(name))).toArray();
  }

  private static double median(List<double[]> rows, int column) {
    double[] values = rows.stream().mapToDouble(row -> row[column]).sorted().toArray();
    return values[values.length / 2];
  }

  /** Measures, and prints a row for each pair and the medians of all. */
  public static void main(String[] args) throws InterruptedException {
    PageViewers pages = new PageViewers(args[0]);
    int viewers = Integer.parseInt(args[1]);
    int pairs = Integer.parseInt(args[2]);
    int length = Integer.parseInt(args[3]);
    WebSocket observer = pages.open(true);
    while (pages.columns.isEmpty()) {
      Thread.sleep(100);
    }
    String[] names = {"p50", "p99", "picture"};
    List<double[]> ratios = new ArrayList<>();
    for (int pair = 0; pair < pairs; pair++) {
      double[][] of = new double[2][];
      for (int turn = 0; turn < 2; turn++) {
        boolean watched = (turn + pair) % 2 == 1; // either goes first in turns
        List<WebSocket> open = new ArrayList<>();
        for (int i = 0; watched && i < viewers; i++) {
          open.add(pages.open(false));
          open.get(i).sendText(LOOK.formatted(pages.room), true).join();
        }
        of[watched ? 1 : 0] = pages.window(length, names);
        open.forEach(WebSocket::abort);
      }
      System.out.printf(
          Locale.ROOT,
          "pair %d: p50 %.3f -> %.3f ms, p99 %.3f -> %.3f ms, picture %.4f ms a tick%n",
          pair,
          of[0][0],
          of[1][0],
          of[0][1],
          of[1][1],
          of[1][2]);
      ratios.add(new double[] {of[1][0] / of[0][0], of[1][1] / of[0][1]});
    }
    System.out.printf(
        Locale.ROOT,
        "viewers=%d pairs=%d: p50 x %.3f, p99 x %.3f (medians of the pairs), %d kB of pictures%n",
        viewers,
        pairs,
        median(ratios, 0),
        median(ratios, 1),
        pages.pictureBytes.get() >> 10);
    observer.abort();
  }
}

package carom.client.bots;

import carom.text.Json;
import carom.text.JsonException;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/** Plays by WebSocket, see docs/protocol/THIN.md: texts of JSON, or the binary form. */
public final class WebDoor implements ThinDoor, WebSocket.Listener {
  private static final float STEPS_PER_METRE = 512;
  private static final int STEPS_PER_TURN = 1_024;
  private static final int PATIENCE_S = 15;

  private final ThinPicture told;
  private final Map<Integer, int[]> steps = new HashMap<>(); // poses of the binary form
  private final StringBuilder text = new StringBuilder();
  private final ByteArrayOutputStream part = new ByteArrayOutputStream();
  private byte[] bytes;
  private int at;
  private WebSocket socket;
  private CompletableFuture<?> sent = CompletableFuture.completedFuture(null);
  private String controls = "";
  private long bytesOut;

  private WebDoor(ThinPicture told) {
    this.told = told;
  }

  /**
   * Returns what opens connections that share one client of the JDK.
   *
   * @param address such as {@code ws://localhost:8080/thin}
   * @param binary whether snapshots come in the binary form
   */
  public static Opener opener(String address, boolean binary) {
    HttpClient http =
        HttpClient.newBuilder().connectTimeout(Duration.ofSeconds(PATIENCE_S)).build();
    URI own = URI.create(address);
    return (name, goal, told) -> {
      WebDoor door = new WebDoor(told);
      URI there = goal.server().isEmpty() ? own : at(own, goal.server());
      try {
        door.socket =
            http.newWebSocketBuilder().buildAsync(there, door).get(PATIENCE_S, TimeUnit.SECONDS);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        throw new IOException("interrupted", e);
      } catch (ExecutionException | TimeoutException e) {
        throw new IOException(there + ": " + (e.getCause() == null ? e : e.getCause()), e);
      }
      door.say(
          String.format(
              Locale.ROOT,
              "{\"join\":{\"name\":\"%s\",\"room\":\"%s\",\"binary\":%s%s%s}}",
              name,
              goal.room(),
              binary,
              field("secret", goal.secret()),
              field("token", goal.token())));
      return door;
    };
  }

  private static String field(String name, String value) {
    return value.isEmpty() ? "" : ",\"" + name + "\":\"" + value + '"';
  }

  /** Returns the same resource of another server. */
  private static URI at(URI own, String server) throws IOException {
    try {
      return URI.create(own.getScheme() + "://" + server + own.getRawPath());
    } catch (IllegalArgumentException e) {
      throw new IOException("server=" + server + " is no address", e);
    }
  }

  private synchronized void say(String message) {
    bytesOut += message.length();
    sent = sent.handle((last, failed) -> null).thenCompose(x -> socket.sendText(message, true));
  }

  @Override
  public void input(int count, int seen, int buttons, float moveX, float moveY, float aim) {
    String now = String.format(Locale.ROOT, "[%d,%.3f,%.3f,%.3f]", buttons, moveX, moveY, aim);
    String both = controls.isEmpty() ? now : now + "," + controls;
    controls = now;
    say("{\"input\":{\"count\":" + count + ",\"seen\":" + seen + ",\"inputs\":[" + both + "]}}");
  }

  @Override
  public void close() {
    say("{\"leave\":{}}");
    try {
      sent.get(1, TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (ExecutionException | TimeoutException e) {
      told.end("the connection broke");
    }
    socket.abort();
  }

  @Override
  public long bytesOut() {
    return bytesOut;
  }

  @Override
  public CompletionStage<?> onText(WebSocket from, CharSequence data, boolean last) {
    text.append(data);
    if (last) {
      byte[] message = text.toString().getBytes(StandardCharsets.UTF_8);
      text.setLength(0);
      told.bytes(message.length);
      try {
        Json.parseMachineMade(message).fields.forEach(this::hear);
      } catch (JsonException | RuntimeException e) {
        told.error();
      }
    }
    from.request(1);
    return null;
  }

  private void hear(String name, Json body) {
    Map<String, Json> values = body.fields;
    switch (name) {
      case "match" -> {
        steps.clear();
        told.match(whole(values.get("player")), values.get("room").text);
      }
      case "snapshot" -> snapshot(values);
      case "roster" -> {
        for (Json player : values.get("players").items) {
          if (whole(player.fields.get("id")) == told.player()) {
            told.ping(whole(player.fields.get("ping")));
          }
        }
      }
      case "scores" -> {
        var all = values.get("scores").items;
        for (int i = 0; i + 2 < all.size(); i += 3) {
          if (whole(all.get(i)) == told.player()) {
            told.ping(whole(all.get(i + 2)));
          }
        }
      }
      case "welcome" -> told.welcome(values.get("secret").text);
      case "standby" -> told.standby(values.get("server").text);
      case "redirect" ->
          told.redirect(
              values.get("server").text, values.get("room").text, values.get("token").text);
      case "refused", "goodbye" -> told.refuse(values.get("reason").text);
      default -> {} // a bot shows nothing of it
    }
  }

  private void snapshot(Map<String, Json> values) {
    told.snapshot(whole(values.get("tick")), 1, whole(values.get("input")), System.nanoTime());
    for (Json one : values.get("bodies").items) {
      var b = one.items;
      boolean named = b.size() > 4;
      told.body(
          whole(b.get(0)),
          (float) b.get(1).number,
          (float) b.get(2).number,
          (float) b.get(3).number,
          named ? whole(b.get(4)) : -1,
          named ? whole(b.get(5)) : -1);
    }
    values.get("gone").items.forEach(id -> told.gone(whole(id)));
  }

  private static int whole(Json value) {
    return (int) value.number;
  }

  @Override
  public CompletionStage<?> onBinary(WebSocket from, ByteBuffer data, boolean last) {
    byte[] piece = new byte[data.remaining()];
    data.get(piece);
    part.writeBytes(piece);
    if (last) {
      bytes = part.toByteArray();
      part.reset();
      told.bytes(bytes.length);
      try {
        binary();
      } catch (RuntimeException e) {
        told.error();
      }
    }
    from.request(1);
    return null;
  }

  private void binary() {
    at = 1;
    int tick = varint();
    told.snapshot(tick, 1, varint() - 1, System.nanoTime());
    int id = 0;
    for (int i = varint(); i > 0; i--) {
      id += varint();
      told.gone(id);
      steps.remove(id);
    }
    id = 0;
    for (int i = varint(); i > 0; i--) {
      int head = varint();
      id += head >> 1;
      boolean named = (head & 1) != 0;
      int[] pose = named ? new int[3] : steps.get(id);
      for (int k = 0; k < pose.length; k++) {
        pose[k] += signed();
      }
      pose[2] = Math.floorMod(pose[2], STEPS_PER_TURN);
      steps.put(id, pose);
      told.body(
          id,
          pose[0] / STEPS_PER_METRE,
          pose[1] / STEPS_PER_METRE,
          (float) (pose[2] * 2 * Math.PI / STEPS_PER_TURN),
          named ? varint() : -1,
          named ? varint() - 1 : -1);
    }
  }

  private int varint() {
    int value = 0;
    for (int shift = 0; ; shift += 7) {
      int next = bytes[at++];
      value |= (next & 0x7f) << shift;
      if (next >= 0) {
        return value;
      }
    }
  }

  private int signed() {
    int value = varint();
    return value >>> 1 ^ -(value & 1);
  }

  @Override
  public CompletionStage<?> onClose(WebSocket from, int status, String reason) {
    told.end(status + " " + reason);
    return null;
  }

  @Override
  public void onError(WebSocket from, Throwable error) {
    told.end(error.toString());
  }
}

import carom.plain.*;
import com.badlogic.gdx.ApplicationAdapter;
import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.Input.Keys;
import com.badlogic.gdx.backends.lwjgl3.*;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.graphics.OrthographicCamera;
import com.badlogic.gdx.graphics.g2d.*;
import com.badlogic.gdx.graphics.glutils.ShapeRenderer;
import com.badlogic.gdx.math.*;
import com.badlogic.gdx.utils.ScreenUtils;
import com.esotericsoftware.kryonet.*;
import java.util.*;

/** A game in a window: stock KryoNet and libGDX. Arguments: HOST TCP UDP NAME. */
public class PlayClient extends ApplicationAdapter {
  /** A body as it is shown; its poses are tick, x, y and angle, the oldest first. */
  static class Shown {
    Body told;
    final List<float[]> poses = new ArrayList<>();
  }

  final String[] args;
  final Client client = new Client(65536, 65536);
  final Map<Integer, Shown> bodies = new HashMap<>();
  final Map<Integer, Player> players = new HashMap<>();
  final List<Archetype> archetypes = new ArrayList<>();
  final List<Ground> ground = new ArrayList<>();
  final OrthographicCamera camera = new OrthographicCamera();
  ShapeRenderer shapes;
  SpriteBatch texts;
  BitmapFont font;
  Welcome welcome;
  Match match;
  Input input;
  String line = "";
  int newest = -1, before = -1;
  float shownTick;

  PlayClient(String[] args) {
    this.args = args;
  }

  public void create() {
    shapes = new ShapeRenderer();
    texts = new SpriteBatch();
    font = new BitmapFont();
    Plain.register(client.getKryo());
    client.addListener(new Listener() {
      public void received(Connection link, Object o) {
        Gdx.app.postRunnable(() -> hear(o)); // all that follows runs on one thread
      }
    });
    client.start();
    try {
      client.connect(5000, args[0], Integer.parseInt(args[1]), Integer.parseInt(args[2]));
      client.sendTCP(new Join(args[3]));
    } catch (java.io.IOException e) {
      line = e.getMessage();
    }
  }

  void hear(Object o) {
    if (o instanceof Snapshot) take((Snapshot) o);
    else if (o instanceof Welcome) welcome = (Welcome) o;
    else if (o instanceof Match) {
      match = (Match) o; // a new one: forget all
      for (Collection<?> all : List.of(bodies.values(), players.values(), archetypes, ground)) all.clear();
      newest = before = -1;
      add(match.archetypes, match.ground);
    } else if (o instanceof More) add(((More) o).archetypes, ((More) o).ground);
    else if (o instanceof Roster) {
      for (Player p : ((Roster) o).players) players.put(p.id, p);
      for (int id : ((Roster) o).gone) players.remove(id);
    } else if (o instanceof Chat) line = ((Chat) o).text;
    else if (o instanceof Refused) line = ((Refused) o).text;
    else if (o instanceof Goodbye) line = ((Goodbye) o).text;
  }

  void add(Archetype[] kinds, Ground[] pieces) {
    archetypes.addAll(Arrays.asList(kinds));
    ground.addAll(Arrays.asList(pieces));
  }

  void take(Snapshot s) {
    if (s.tick < newest) return; // it is late
    if (s.tick > newest) before = newest;
    newest = s.tick;
    for (Body b : s.bodies) {
      Shown body = bodies.computeIfAbsent(b.id, id -> new Shown());
      if (b.archetype >= 0) { // a new one, or it has jumped
        body.told = b;
        body.poses.clear();
      }
      float[] last = body.poses.isEmpty() ? null : body.poses.get(body.poses.size() - 1);
      if (last != null && last[0] < before) // it kept still until then
        body.poses.add(new float[] {before, last[1], last[2], last[3]});
      body.poses.add(new float[] {s.tick, b.x, b.y, b.angle});
    }
    for (int id : s.gone) bodies.remove(id);
  }

  /** Returns x, y and angle at the tick that is shown, between two poses that were told. */
  float[] pose(Shown body) {
    List<float[]> p = body.poses;
    while (p.size() > 1 && p.get(1)[0] <= shownTick) p.remove(0);
    float[] a = p.get(0), b = p.get(p.size() > 1 ? 1 : 0);
    float part = a == b ? 0 : MathUtils.clamp((shownTick - a[0]) / (b[0] - a[0]), 0, 1);
    return new float[] {a[1] + part * (b[1] - a[1]), a[2] + part * (b[2] - a[2]), MathUtils.lerpAngle(a[3], b[3], part)};
  }

  public void render() {
    ScreenUtils.clear(0.07f, 0.08f, 0.1f, 1);
    if (match != null) {
      float wanted = newest - 2f * welcome.tickRate / welcome.rate; // two snapshots late
      shownTick += Gdx.graphics.getDeltaTime() * welcome.tickRate;
      shownTick += MathUtils.clamp(wanted - shownTick, -0.2f, 0.2f); // keeps the distance
      if (Math.abs(wanted - shownTick) > 30) shownTick = wanted;
      draw();
      play();
    }
    texts.begin();
    font.draw(texts, line, 10, 20);
    texts.end();
  }

  void draw() {
    camera.setToOrtho(false, 32f * Gdx.graphics.getWidth() / Gdx.graphics.getHeight(), 32);
    for (Shown body : bodies.values())
      if (body.told.owner == match.player) camera.position.set(pose(body)[0], pose(body)[1], 0);
    camera.update();
    shapes.setProjectionMatrix(camera.combined);
    shapes.begin(ShapeRenderer.ShapeType.Filled);
    for (Ground g : ground) draw(g.kind, g.kind.rgb, new float[] {g.x, g.y, g.angle});
    for (Shown body : bodies.values()) {
      Archetype kind = archetypes.get(body.told.archetype);
      Player owner = players.get(body.told.owner);
      draw(kind, owner != null && owner.rgb >= 0 ? owner.rgb : kind.rgb, pose(body));
    }
    shapes.end();
  }

  void draw(Archetype kind, int rgb, float[] pose) {
    shapes.setColor(new Color(rgb << 8 | 0xff));
    float cos = MathUtils.cos(pose[2]), sin = MathUtils.sin(pose[2]);
    for (Part part : kind.parts) {
      int n = part.corners.length;
      float[] at = new float[n];
      for (int i = 0; i < n; i += 2) {
        at[i] = pose[0] + cos * part.corners[i] - sin * part.corners[i + 1];
        at[i + 1] = pose[1] + sin * part.corners[i] + cos * part.corners[i + 1];
      }
      for (int i = 2; i + 2 < n; i += 2)
        shapes.triangle(at[0], at[1], at[i], at[i + 1], at[i + 2], at[i + 3]);
      for (int i = 0; part.radius > 0 && i < n; i += 2) { // rounded
        shapes.circle(at[i], at[i + 1], part.radius, 24);
        shapes.rectLine(at[i], at[i + 1], at[(i + 2) % n], at[(i + 3) % n], 2 * part.radius);
      }
    }
  }

  void play() {
    float x = held(Keys.D, Keys.RIGHT) - held(Keys.A, Keys.LEFT);
    float y = held(Keys.W, Keys.UP) - held(Keys.S, Keys.DOWN);
    int buttons = held(Keys.SPACE, Keys.W) + 2 * held(Keys.SHIFT_LEFT, Keys.E); // jump, action
    Vector3 mouse = camera.unproject(new Vector3(Gdx.input.getX(), Gdx.input.getY(), 0));
    float aim = MathUtils.atan2(mouse.y - camera.position.y, mouse.x - camera.position.x);
    input = new Input(input, newest, buttons, x, y, aim); // carries the two before, too
    client.sendUDP(input);
  }

  int held(int key, int other) {
    return Gdx.input.isKeyPressed(key) || Gdx.input.isKeyPressed(other) ? 1 : 0;
  }

  public void dispose() {
    client.sendTCP(new Leave());
    client.stop();
  }

  public static void main(String[] args) {
    String[] usual = {"localhost", "54560", "54780", "Ann"};
    Lwjgl3ApplicationConfiguration config = new Lwjgl3ApplicationConfiguration();
    config.setTitle("Carom by stock KryoNet");
    config.setWindowedMode(960, 640);
    config.setForegroundFPS(60); // an input for each frame
    new Lwjgl3Application(new PlayClient(args.length == 4 ? args : usual), config);
  }
}

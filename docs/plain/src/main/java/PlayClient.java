import carom.plain.*;
import com.badlogic.gdx.ApplicationAdapter;
import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.Input.Keys;
import com.badlogic.gdx.backends.lwjgl3.*;
import com.badlogic.gdx.graphics.*;
import com.badlogic.gdx.graphics.glutils.ShapeRenderer;
import com.badlogic.gdx.math.*;
import com.esotericsoftware.kryonet.*;
import java.util.*;

/** A game in a window: stock KryoNet and libGDX. Arguments: HOST TCP UDP NAME. */
public class PlayClient extends ApplicationAdapter {
  final Client client = new Client(65536, 65536);
  final Queue<Object> heard = new java.util.concurrent.ConcurrentLinkedQueue<>();
  final Map<Integer, Body> bodies = new HashMap<>(); // as they were told first
  final Map<Integer, List<float[]>> poses = new HashMap<>(); // tick, x, y, angle; the oldest first
  final Map<Integer, Player> players = new HashMap<>();
  final List<Archetype> archetypes = new ArrayList<>();
  final List<Ground> ground = new ArrayList<>();
  final OrthographicCamera camera = new OrthographicCamera();
  ShapeRenderer shapes;
  Welcome welcome;
  Match match;
  Input input;
  int newest = -1, before = -1;
  float shownTick;

  public void create() {
    shapes = new ShapeRenderer();
  }

  void hear(Object o) {
    if (o instanceof Snapshot) take((Snapshot) o);
    else if (o instanceof Welcome) welcome = (Welcome) o;
    else if (o instanceof Match) {
      match = (Match) o; // a new one: forget all
      for (Collection<?> all :
          List.of(bodies.values(), poses.values(), players.values(), archetypes, ground))
        all.clear();
      newest = before = -1;
      Collections.addAll(archetypes, match.archetypes);
      Collections.addAll(ground, match.ground);
    } else if (o instanceof More) { // of a level that is too long for one message
      Collections.addAll(archetypes, ((More) o).archetypes);
      Collections.addAll(ground, ((More) o).ground);
    } else if (o instanceof Roster) {
      for (Player p : ((Roster) o).players) players.put(p.id, p);
      for (int id : ((Roster) o).gone) players.remove(id);
    } else if (o instanceof Chat) Gdx.graphics.setTitle(((Chat) o).text);
    else if (o instanceof Refused) Gdx.graphics.setTitle(((Refused) o).text);
    else if (o instanceof Goodbye) Gdx.graphics.setTitle(((Goodbye) o).text);
  }

  void take(Snapshot s) {
    if (match == null || s.match != match.number || s.tick < newest) return; // early or late
    if (s.tick > newest) before = newest;
    newest = s.tick;
    for (Body b : s.bodies) {
      if (b.archetype >= 0) { // a new one, or it has jumped
        bodies.put(b.id, b);
        poses.put(b.id, new ArrayList<>());
      }
      List<float[]> all = poses.computeIfAbsent(b.id, id -> new ArrayList<>());
      float[] last = all.isEmpty() ? null : all.get(all.size() - 1);
      if (last != null && last[0] < before)
        all.add(new float[] {before, last[1], last[2], last[3]}); // it kept still
      all.add(new float[] {s.tick, b.x, b.y, b.angle});
    }
    for (int id : s.gone) bodies.remove(id);
  }

  /** Returns x, y and angle at the tick that is shown, between two poses that were told. */
  float[] pose(Body body) {
    List<float[]> p = poses.get(body.id);
    while (p.size() > 1 && p.get(1)[0] <= shownTick) p.remove(0);
    float[] a = p.get(0), b = p.get(p.size() > 1 ? 1 : 0);
    float part = a == b ? 0 : MathUtils.clamp((shownTick - a[0]) / (b[0] - a[0]), 0, 1);
    return new float[] {
      a[1] + part * (b[1] - a[1]),
      a[2] + part * (b[2] - a[2]),
      MathUtils.lerpAngle(a[3], b[3], part)
    };
  }

  public void render() {
    com.badlogic.gdx.utils.ScreenUtils.clear(0.07f, 0.08f, 0.1f, 1);
    for (Object o; (o = heard.poll()) != null; ) hear(o);
    if (match == null) return;
    float wanted = newest - 2f * welcome.tickRate / welcome.rate; // two snapshots late
    shownTick += Gdx.graphics.getDeltaTime() * welcome.tickRate;
    shownTick += MathUtils.clamp(wanted - shownTick, -0.2f, 0.2f); // keeps the distance
    if (Math.abs(wanted - shownTick) > 30) shownTick = wanted;
    camera.setToOrtho(false, 32f * Gdx.graphics.getWidth() / Gdx.graphics.getHeight(), 32);
    for (Body body : bodies.values())
      if (body.owner == match.player) camera.position.set(pose(body)[0], pose(body)[1], 0);
    camera.update();
    shapes.setProjectionMatrix(camera.combined);
    shapes.begin(ShapeRenderer.ShapeType.Filled);
    for (Ground g : ground) draw(g.kind, g.kind.rgb, new float[] {g.x, g.y, g.angle});
    for (Body body : bodies.values()) {
      Archetype kind = archetypes.get(body.archetype);
      Player owner = players.get(body.owner);
      draw(kind, owner != null && owner.rgb >= 0 ? owner.rgb : kind.rgb, pose(body));
    }
    shapes.end();
    play();
  }

  void draw(Archetype kind, int rgb, float[] at) {
    shapes.setColor(new Color(rgb << 8 | 0xff));
    shapes.setTransformMatrix(
        new Matrix4().setToTranslation(at[0], at[1], 0).rotateRad(Vector3.Z, at[2]));
    for (Part part : kind.parts) {
      float[] c = part.corners;
      for (int i = 2; i + 2 < c.length; i += 2)
        shapes.triangle(c[0], c[1], c[i], c[i + 1], c[i + 2], c[i + 3]);
      for (int i = 0, n = c.length; part.radius > 0 && i < n; i += 2) { // rounded
        shapes.circle(c[i], c[i + 1], part.radius, 24);
        shapes.rectLine(c[i], c[i + 1], c[(i + 2) % n], c[(i + 3) % n], 2 * part.radius);
      }
    }
  }

  void play() {
    float x = held(Keys.D) - held(Keys.A), y = held(Keys.W) - held(Keys.S);
    int buttons = Math.max(held(Keys.SPACE), held(Keys.W)) + 2 * held(Keys.E); // jump, action
    Vector3 mouse = camera.unproject(new Vector3(Gdx.input.getX(), Gdx.input.getY(), 0));
    float aim = MathUtils.atan2(mouse.y - camera.position.y, mouse.x - camera.position.x);
    input = new Input(input, newest, buttons, x, y, aim); // carries the two before, too
    client.sendUDP(input);
  }

  int held(int key) {
    return Gdx.input.isKeyPressed(key) || Gdx.input.isKeyJustPressed(key) ? 1 : 0; // a short tap counts, too
  }

  public void dispose() {
    client.sendTCP(new Leave());
    client.stop();
  }

  public static void main(String[] given) throws java.io.IOException {
    String[] args = given.length == 4 ? given : new String[] {"localhost", "54560", "54780", "Ann"};
    PlayClient game = new PlayClient();
    Plain.register(game.client.getKryo());
    game.client.addListener(
        new Listener() {
          public void received(Connection link, Object o) {
            game.heard.add(o); // render takes it: all else runs on one thread
          }
        });
    game.client.start();
    game.client.connect(5000, args[0], Integer.parseInt(args[1]), Integer.parseInt(args[2]));
    game.client.sendTCP(new Join(args[3]));
    Lwjgl3ApplicationConfiguration config = new Lwjgl3ApplicationConfiguration();
    config.setForegroundFPS(60); // an input for each frame
    new Lwjgl3Application(game, config);
  }
}

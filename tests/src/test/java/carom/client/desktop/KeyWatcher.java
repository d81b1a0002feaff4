package carom.client.desktop;

import carom.client.app.ClientMain;
import carom.client.view.ClientView;
import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.Input;
import java.awt.AWTException;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;

/**
 * A program that opens the client's window, presses keys as a user does, through the display, and
 * looks at the screen: prints for each press how many pixels around the own body differ by the end
 * of the second frame after it, and how many did while it rested. Then it opens the menu and closes
 * it.
 */
final class KeyWatcher {
  private static final int TOLERANCE = 10;
  private static final int PRESSES = 10;
  private static final int AROUND = 30;
  private static final int CALM_FPS = 20;
  private static final Rectangle SCREEN = new Rectangle(0, 0, 1_280, 720);

  /** Way of the body's middle in a tenth of a second that counts as none, px. */
  private static final double AT_REST = 0.02;

  private final Robot robot;
  private final int rgb;

  /** The middle of the own body when it was looked for last, and its pixels. */
  private double[] found;

  private KeyWatcher(Robot robot, int rgb) {
    this.robot = robot;
    this.rgb = rgb;
  }

  /**
   * Runs the program.
   *
   * @param args colour of the own body, and the flags of the client
   */
  public static void main(String[] args) {
    int rgb = Integer.parseInt(args[0]);
    Thread presser = new Thread(() -> press(rgb), "presser");
    presser.setDaemon(true);
    presser.start();
    String[] flags = new String[args.length - 1];
    System.arraycopy(args, 1, flags, 0, flags.length);
    System.exit(ClientMain.run(flags));
  }

  private static void press(int rgb) {
    try {
      Robot robot = new Robot();
      KeyWatcher watcher = new KeyWatcher(robot, rgb);
      watcher.run();
      watcher.openMenu();
    } catch (AWTException | InterruptedException e) {
      System.out.println("failed: " + e);
    }
    Gdx.app.exit();
  }

  private void run() throws InterruptedException {
    robot.mouseMove(640, 60);
    CalmWindow.awaitPictures(CALM_FPS);
    while (found == null || found[2] < 200) {
      Thread.sleep(200);
      found = find(SCREEN);
    }
    robot.keyPress(KeyEvent.VK_F1); // hides the hints, which would go by themselves after 12 s
    robot.delay(100);
    robot.keyRelease(KeyEvent.VK_F1);
    Thread.sleep(6_000); // until clocks have settled
    Gdx.graphics.setForegroundFPS(60); // as on most screens: a virtual one has no vsync
    for (int i = 0; i < PRESSES; i++) {
      awaitRest();
      Rectangle near =
          new Rectangle((int) found[0] - AROUND, (int) found[1] - AROUND, 2 * AROUND, 2 * AROUND);
      BufferedImage rest = robot.createScreenCapture(near);
      BufferedImage before = robot.createScreenCapture(near);
      // A correction that comes late on a busy machine moves the body once more.
      for (int attempt = 0; changed(rest, before) > 0 && attempt < 20; attempt++) {
        Thread.sleep(100);
        rest = robot.createScreenCapture(near);
        before = robot.createScreenCapture(near);
      }
      int key = i % 2 == 0 ? KeyEvent.VK_D : KeyEvent.VK_A;
      robot.keyPress(key);
      awaitSecondFrame(i % 2 == 0 ? Input.Keys.D : Input.Keys.A);
      BufferedImage after = robot.createScreenCapture(near);
      robot.keyRelease(key);
      System.out.printf("rested %d%n", changed(rest, before));
      System.out.printf("moved %d%n", changed(before, after));
      Thread.sleep(500);
    }
  }

  /**
   * Waits for the end of the second frame after the one that read the key. On a machine that keeps
   * up, a tick begins in each of the two; on one that doesn't, the frames that no tick began in
   * aren't counted, as they can't show more.
   */
  private void awaitSecondFrame(int key) {
    while (!Gdx.input.isKeyPressed(key)) {
      Thread.onSpinWait();
    }
    ClientView view =
        ((GameScreen) ((CaromWindow) Gdx.app.getApplicationListener()).screen()).view();
    int tick = view.tick();
    long frame = Gdx.graphics.getFrameId();
    while (view.tick() < tick + 2) {
      Thread.onSpinWait();
    }
    // A tick begins before its frame is drawn: that frame has ended when the next one begins.
    long end = Math.max(frame + 3, Gdx.graphics.getFrameId() + 1);
    while (Gdx.graphics.getFrameId() < end) {
      Thread.onSpinWait();
    }
  }

  /**
   * Opens the menu and closes it, and prints how much of the picture's middle changed each time.
   */
  private void openMenu() throws InterruptedException {
    Rectangle middle = new Rectangle(540, 260, 200, 200);
    BufferedImage game = robot.createScreenCapture(middle);
    for (int i = 0; i < 2; i++) {
      robot.keyPress(KeyEvent.VK_ESCAPE);
      Thread.sleep(100);
      robot.keyRelease(KeyEvent.VK_ESCAPE);
      long frame = Gdx.graphics.getFrameId();
      while (Gdx.graphics.getFrameId() < frame + 10) {
        Thread.sleep(20);
      }
      BufferedImage now = robot.createScreenCapture(middle);
      System.out.printf("changed %.3f%n", changed(game, now) / 40_000.0);
    }
  }

  /** Returns the number of pixels that differ. */
  private static int changed(BufferedImage from, BufferedImage to) {
    int changed = 0;
    for (int y = 0; y < from.getHeight(); y++) {
      for (int x = 0; x < from.getWidth(); x++) {
        changed += from.getRGB(x, y) == to.getRGB(x, y) ? 0 : 1;
      }
    }
    return changed;
  }

  /** Waits until the body stands still for half a second. */
  private void awaitRest() throws InterruptedException {
    int still = 0;
    while (still < 5) {
      Thread.sleep(100);
      double[] now = find(around(found));
      now = now[2] > 0 ? now : find(SCREEN); // it reappeared elsewhere
      still = Math.hypot(now[0] - found[0], now[1] - found[1]) < AT_REST ? still + 1 : 0;
      found = now;
    }
  }

  /** Returns where a body can be that was found a tenth of a second ago. */
  private static Rectangle around(double[] found) {
    int reach = 4 * AROUND;
    int x = (int) found[0] - reach;
    int y = (int) found[1] - reach;
    return new Rectangle(x, y, 2 * reach, 2 * reach).intersection(SCREEN);
  }

  /** Returns the middle of the pixels of the body's colour, and how many there are. */
  private double[] find(Rectangle where) {
    BufferedImage image = robot.createScreenCapture(where);
    double x = 0;
    double y = 0;
    int count = 0;
    for (int row = 0; row < image.getHeight(); row++) {
      for (int column = 0; column < image.getWidth(); column++) {
        int seen = image.getRGB(column, row);
        if (near(seen, 16) && near(seen, 8) && near(seen, 0)) {
          x += column;
          y += row;
          count++;
        }
      }
    }
    return new double[] {where.x + x / Math.max(1, count), where.y + y / Math.max(1, count), count};
  }

  private boolean near(int seen, int shift) {
    return Math.abs((seen >> shift & 0xff) - (rgb >> shift & 0xff)) <= TOLERANCE;
  }
}

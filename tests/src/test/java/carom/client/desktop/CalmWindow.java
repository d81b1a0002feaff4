package carom.client.desktop;

import carom.client.app.ClientMain;
import com.badlogic.gdx.Gdx;

/**
 * A program that opens the client's window and draws it ten times a second: software draws it, and
 * a virtual display holds it back by nothing.
 */
final class CalmWindow {
  private static final int FPS = 10;

  private CalmWindow() {}

  /**
   * Runs the program.
   *
   * @param args the client's flags
   */
  public static void main(String[] args) {
    Thread calming =
        new Thread(
            () -> {
              try {
                awaitPictures(FPS);
              } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
              }
            },
            "calming");
    calming.setDaemon(true);
    calming.start();
    System.exit(ClientMain.run(args));
  }

  /** Waits for the window's first pictures, and limits how many follow in a second. */
  static void awaitPictures(int fps) throws InterruptedException {
    while (Gdx.graphics == null || Gdx.graphics.getFrameId() < 3) {
      Thread.sleep(20);
    }
    Gdx.graphics.setForegroundFPS(fps);
  }
}

import barter.Deal;
import barter.Messages;
import barter.Odd_name_;
import barter.Offer;
import carom.plain.Custom;
import carom.plain.Goodbye;
import carom.plain.Join;
import carom.plain.Leave;
import carom.plain.Match;
import carom.plain.Plain;
import carom.plain.Refused;
import carom.plain.Welcome;
import com.esotericsoftware.kryonet.Client;
import com.esotericsoftware.kryonet.Connection;
import com.esotericsoftware.kryonet.Listener;
import com.esotericsoftware.minlog.Log;
import java.util.concurrent.CountDownLatch;

/**
 * Makes an offer by the classes that carom plain has written, prints what the server answers, and
 * leaves. Arguments: TCP port, UDP port, digest or "own".
 */
public final class Barterer {
  private Barterer() {}

  public static void main(String[] args) throws Exception {
    Log.set(Log.LEVEL_NONE);
    final Client client = new Client(65536, 65536);
    final CountDownLatch over = new CountDownLatch(1);
    Plain.register(client.getKryo());
    Messages.register(client.getKryo());
    client.addListener(
        new Listener() {
          @Override
          public void received(Connection link, Object o) {
            if (o instanceof Welcome) {
              say("welcome");
            } else if (o instanceof Match) {
              client.sendTCP(new Offer(3, 70, 7, 2.5f, true, Offer.Mood.SOUR, "b\u00e4rgain"));
            } else if (o instanceof Deal) {
              Deal d = (Deal) o;
              say(
                  "deal to="
                      + d.to
                      + " ball="
                      + d.ball
                      + " count="
                      + d.count
                      + " price="
                      + d.price
                      + " rush="
                      + d.rush
                      + " mood="
                      + d.mood
                      + " note="
                      + (int) d.note.charAt(1));
              client.sendTCP(new Odd_name_());
            } else if (o instanceof Odd_name_) {
              Odd_name_ d = (Odd_name_) o;
              say("odd class=" + d.class_ + " item=" + d.it_em + " " + d.it_em_ + " " + d.string);
              client.sendTCP(new Leave());
            } else if (o instanceof Custom) {
              say("custom " + ((Custom) o).kind);
            } else if (o instanceof Refused) {
              say("refused " + ((Refused) o).reason + " " + ((Refused) o).text);
            } else if (o instanceof Goodbye) {
              say("goodbye " + ((Goodbye) o).reason);
            }
          }

          @Override
          public void disconnected(Connection link) {
            over.countDown();
          }
        });
    client.start();
    client.connect(8000, "127.0.0.1", Integer.parseInt(args[0]), Integer.parseInt(args[1]));
    Join join = new Join("Ann");
    join.digest = args[2].equals("own") ? Messages.DIGEST : args[2];
    client.sendTCP(join);
    over.await();
    client.stop();
  }

  private static void say(String text) {
    System.out.println(text);
    System.out.flush();
  }
}

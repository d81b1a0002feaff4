package carom.lab.soak;

import carom.client.ClientConfig;
import carom.client.link.ConnectionPhase;
import carom.net.transport.Impairment;
import carom.sim.message.Emote;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.util.List;

/** A real client, which decodes, interpolates or predicts. Its stepper advances it. */
final class FullGuest implements Guest {
  private final Stepper stepper;
  private final SimulatedClient client;

  FullGuest(Stepper stepper, ClientConfig config, Impairment network, long seed) {
    this.stepper = stepper;
    client = stepper.add(config, network.withSeed(seed), Scripts.wander(seed));
  }

  /** Returns the client. */
  SimulatedClient client() {
    return client;
  }

  @Override
  public void update(long nowNs) {}

  @Override
  public boolean isConnected() {
    return client.isConnected();
  }

  @Override
  public boolean isPlaying() {
    return client.view().phase() == ConnectionPhase.PLAYING;
  }

  @Override
  public String name() {
    return client.name();
  }

  @Override
  public String room() {
    return client.view().room();
  }

  @Override
  public int playerId() {
    return client.view().playerId();
  }

  @Override
  public void cut() {
    client.cut();
  }

  @Override
  public void blackout(double seconds) {
    stepper.blackout(client, seconds);
  }

  @Override
  public void freeze(boolean stopped) {
    client.freeze(stopped);
  }

  @Override
  public void impair(Impairment network) {
    client.impair(network);
  }

  @Override
  public void say(String text) {
    client.game().chat(text);
  }

  @Override
  public void show(Emote emote) {
    client.game().emote(emote);
  }

  @Override
  public void changeRoom(String name) {
    client.game().changeRoom(name);
  }

  @Override
  public void end(boolean dies) {
    if (!dies) {
      client.leave();
    } else if (client.isConnected()) {
      client.kill();
    }
    stepper.remove(client);
  }

  @Override
  public List<Object> roots() {
    return List.of(client);
  }

  @Override
  public long compared() {
    return client.compared();
  }

  @Override
  public String toString() {
    return client.toString();
  }
}

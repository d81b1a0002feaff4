package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.kryo.KryoMessageCodec;
import carom.server.config.ServerConfig;
import org.junit.jupiter.api.Test;

class GameWarmupTest {
  @Test
  void everybodyJoinsPlaysAndLeaves() {
    TestGame game = new TestGame(3);
    GameWarmup.play(
        ServerConfig.defaults().with(ServerConfig.ROOMS, 3),
        () -> game,
        TestGame.shortLevel(),
        new KryoMessageCodec());
    assertEquals(4, game.joins);
    assertEquals(4, game.leaves);
    assertTrue(game.inputs > 20, "inputs=" + game.inputs);
  }
}

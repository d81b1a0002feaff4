package carom.lab.bench;

import carom.lab.measure.BenchJob;
import carom.lab.measure.BenchRow;
import carom.lab.measure.Entrant;
import carom.lab.measure.Measurement;
import java.util.ArrayList;
import java.util.List;

/** The job that steps a scene, with Carom and with other engines. */
record SceneJob(BenchScene scene) implements BenchJob {
  @Override
  public String name() {
    return scene.name();
  }

  @Override
  public List<Entrant> entrants(Choice wanted) {
    List<Entrant> all = new ArrayList<>(wanted.carom());
    if (scene.peers()) {
      wanted.peers().forEach(peer -> all.add(Entrant.of(peer)));
    }
    return all;
  }

  @Override
  public BenchRow run(Entrant entrant, Measurement measurement) {
    BenchEngine engine =
        entrant.isCarom() ? new CaromEngine(entrant.threads()) : Peers.engine(entrant.engine());
    return SceneMeasurement.run(scene, engine, entrant, measurement);
  }
}

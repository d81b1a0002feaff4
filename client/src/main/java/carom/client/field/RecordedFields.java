package carom.client.field;

import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.field.FieldStore;
import carom.sim.field.FieldValues;
import carom.sim.field.Scope;
import carom.sim.phase.Phases;

/**
 * The fields of a simulation of which everything is known, such as a recording's. Each look copies
 * the values, so that nothing can be changed. One thread; allocates for each look.
 */
public final class RecordedFields implements ShownFields {
  private final SimulationHost simulation;
  private final FieldStore store;

  /** Creates the fields of a simulation. */
  public RecordedFields(SimulationHost simulation) {
    this.simulation = simulation;
    store = new FieldStore(simulation.schema(), simulation::tick, new Finder(), new Phases<>(true));
  }

  private final class Finder implements FieldStore.References<FieldView, FieldView> {
    @Override
    public FieldView entity(int id, int generation) {
      return RecordedFields.this.entity(id, generation);
    }

    @Override
    public FieldView player(int id) {
      return RecordedFields.this.player(id);
    }
  }

  @Override
  public FieldView match() {
    return view(Scope.MATCH, -1, simulation.fieldValues());
  }

  @Override
  public FieldView player(int id) {
    HostPlayer player = simulation.player(id);
    return view(Scope.PLAYER, id, player == null ? null : player.fieldValues());
  }

  @Override
  public FieldView entity(int id, int generation) {
    HostEntity entity = simulation.entity(id);
    boolean same = entity != null && entity.generation() == generation;
    return view(Scope.ENTITY, id, same ? entity.fieldValues() : null).of(id, generation);
  }

  private FieldView view(Scope scope, int id, FieldValues values) {
    FieldView view = new FieldView(store, scope, id);
    for (int i = 0; values != null && i < values.size(); i++) {
      view.fieldValues().mirror(i, values.word(i));
    }
    return view;
  }
}

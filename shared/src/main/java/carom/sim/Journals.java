package carom.sim;

import carom.sim.entity.Newcomer;
import carom.sim.message.PlayerRole;
import java.util.ArrayList;
import java.util.List;

/** The journals of a simulation, each of which receives all that enters it. One thread. */
final class Journals implements Journal {
  private final List<Journal> all = new ArrayList<>(2);

  /** Adds a journal, behind those that are there. */
  void add(Journal journal) {
    all.add(journal);
  }

  /** Removes a journal; nothing happens if it isn't there. */
  void remove(Journal journal) {
    all.remove(journal);
  }

  boolean isEmpty() {
    return all.isEmpty();
  }

  @Override
  public void joining(SimulationHost s, int id, Newcomer newcomer) {
    for (int i = 0; i < all.size(); i++) {
      all.get(i).joining(s, id, newcomer);
    }
  }

  @Override
  public void watching(SimulationHost s, int id, Newcomer newcomer) {
    for (int i = 0; i < all.size(); i++) {
      all.get(i).watching(s, id, newcomer);
    }
  }

  @Override
  public void changing(SimulationHost s, int id, PlayerRole role) {
    for (int i = 0; i < all.size(); i++) {
      all.get(i).changing(s, id, role);
    }
  }

  @Override
  public void keeping(SimulationHost s, int id, int[] values) {
    for (int i = 0; i < all.size(); i++) {
      all.get(i).keeping(s, id, values);
    }
  }

  @Override
  public void leaving(SimulationHost s, int id) {
    for (int i = 0; i < all.size(); i++) {
      all.get(i).leaving(s, id);
    }
  }

  @Override
  public void stepping(SimulationHost s) {
    for (int i = 0; i < all.size(); i++) {
      all.get(i).stepping(s);
    }
  }

  @Override
  public void stepped(SimulationHost s) {
    for (int i = 0; i < all.size(); i++) {
      all.get(i).stepped(s);
    }
  }
}

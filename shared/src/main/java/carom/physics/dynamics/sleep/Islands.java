package carom.physics.dynamics.sleep;

/**
 * Which awake bodies hold each other, directly or through others: a forest over the active list, in
 * which two bodies are in the same tree if they are in the same island.
 */
final class Islands {
  private int[] parent = new int[0];

  /** Per root: whether something keeps its island awake. */
  private boolean[] restless = new boolean[0];

  /** Starts with every body alone. */
  void reset(int count) {
    if (parent.length < count) {
      int capacity = Math.max(count, 2 * parent.length);
      parent = new int[capacity];
      restless = new boolean[capacity];
    }
    for (int i = 0; i < count; i++) {
      parent[i] = i;
      restless[i] = false;
    }
  }

  /** The root of a body's island. */
  int find(int i) {
    while (parent[i] != i) {
      parent[i] = parent[parent[i]];
      i = parent[i];
    }
    return i;
  }

  void join(int i, int j) {
    int a = find(i);
    int b = find(j);
    int root = Math.min(a, b);
    parent[a] = root;
    parent[b] = root;
    restless[root] = restless[a] || restless[b];
  }

  /** Keeps a body's island awake. */
  void keepAwake(int i) {
    restless[find(i)] = true;
  }

  boolean keptAwake(int i) {
    return restless[find(i)];
  }
}

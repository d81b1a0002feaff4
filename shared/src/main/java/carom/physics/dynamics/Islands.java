package carom.physics.dynamics;

/**
 * A union-find structure over the active list: two bodies are in the same tree if they are in the
 * same island, because they hold each other directly or through others.
 */
final class Islands {
  private int[] parent = new int[0];

  /** Per root: whether something keeps its island awake. */
  private boolean[] restless = new boolean[0];

  /** Makes room for bodies. */
  void reserve(int capacity) {
    if (parent.length < capacity) {
      parent = new int[capacity];
      restless = new boolean[capacity];
    }
  }

  /** Starts with an island per body, for which there is room. */
  void reset(int count) {
    for (int i = 0; i < count; i++) {
      parent[i] = i;
      restless[i] = false;
    }
  }

  /** Returns the root of a body's island. */
  int find(int i) {
    while (parent[i] != i) {
      parent[i] = parent[parent[i]];
      i = parent[i];
    }
    return i;
  }

  /** Makes one island of two. */
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

  /** Returns whether something keeps a body's island awake. */
  boolean keptAwake(int i) {
    return restless[find(i)];
  }
}

package carom.server.threads;

/** A duty that does nothing, needs a turn each millisecond and never fails, for tests to change. */
class TestDuty implements Duty {
  @Override
  public void turn(long nowNs) {}

  @Override
  public long napNs(long nowNs) {
    return 1_000_000;
  }

  @Override
  public boolean hasLinks() {
    return false;
  }

  @Override
  public int progress() {
    return 0;
  }

  @Override
  public boolean hasFailed() {
    return false;
  }

  @Override
  public void fail(String why) {}

  @Override
  public void close(long nowNs) {}

  @Override
  public boolean isDeserted() {
    return true;
  }

  @Override
  public void closeLinks() {}
}

package carom.client.app;

import picocli.CommandLine.IVersionProvider;

/** What {@code --version} says: the version in the jar's manifest. */
public final class ProgramVersion implements IVersionProvider {
  /** Called by the command line. */
  public ProgramVersion() {}

  @Override
  public String[] getVersion() {
    String version = ProgramVersion.class.getPackage().getImplementationVersion();
    return new String[] {"Carom " + (version == null ? "(development build)" : version)};
  }
}

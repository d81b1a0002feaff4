package carom.server.account;

/** Goal: the store of other tests keeps what the contract asks for, too. */
final class MemoryAccountsTest extends AccountStoreContract {
  private final MemoryAccounts kept = new MemoryAccounts();

  @Override
  AccountStore store() {
    return kept;
  }
}

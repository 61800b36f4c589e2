"""The command ``warm``."""

from tilewright.cli.options import DryRun, Json, Quiet
from tilewright.cli.performing import perform


def command(dry_run: DryRun = False, quiet: Quiet = False, json: Json = False) -> None:
    """Compile all loops now, once for this version, so that no later command waits for that.

    Else a command compiles what it needs when it is first used, which takes up to ten seconds. What is
    compiled is kept in the user's cache folder.

    Example: tilewright warm

    Calls tilewright.jobs.WarmJob().run(). That does small work of every kind.
    """
    perform("WarmJob", locals())

"""What somebody may give who does not know the program, or means it ill: one sentence that names the cause, at once."""
import os

from harness import ROOT, SCRATCH, SystemTest, completed, fresh, hawser, main

CHAIN = ROOT / "tests/reliability/chain.xml"
WATERS = ROOT / "inputs/tutorials/two_waters"


def made(name, content=None):
    """A file, or without content a pipe that nobody writes into."""
    path = SCRATCH / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.unlink(missing_ok=True)
    if content is None:
        os.mkfifo(path)
    else:
        path.write_bytes(content)
    return path


class CommandLines(SystemTest):
    def test_are_told_what_is_wrong_with_them(self):
        for arguments, sentence in (
                (["rnu", CHAIN], "there is no verb 'rnu'; there are run, restart, .*; did you mean 'run'\\?"),
                (["frobnicate"], "there is no verb 'frobnicate'; there are run, "),
                (["run", CHAIN, "--stop-afer", "5h"], "'run' has no option '--stop-afer'; did you mean '--stop-after'\\?"),
                (["check", "--msh", CHAIN], "'check' has no option '--msh'; did you mean '--mesh'\\?"),
                (["run", CHAIN, CHAIN], "not expected"),
                (["run"], "deck is required"),
                *((["run", CHAIN, "-o", "x", "--end", end], f"--end: '{end}' is no end time; needed is a number of seconds, "
                   "greater than 0, or --set time/end=\"1 h\" with a unit") for end in ("nan", "-5", "0", "1 h", "inf", "")),
                (["run", CHAIN, "-o", "x", "--set", "="], "needed is path=value"),
                (["study", CHAIN, "-o", "x", "-j", "-1"], "not in range 1 to 10000")):
            with self.subTest(arguments=arguments[1:]):
                done = hawser(1, *arguments)
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertRegex(done.stderr, sentence)
                self.assertLess(len(done.stderr), 500)


class Files(SystemTest):
    def refused(self, code, sentence, *arguments):
        done = hawser(1, *arguments, seconds=20)
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertRegex(done.stderr, sentence)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)

    def test_that_are_no_meshes(self):
        deck = made("waters.xml", b"")
        for mesh, sentence in ((SCRATCH, "is a folder, no mesh file"), ("/dev/zero", "no mesh file but a pipe or a device"),
                               (made("pipe"), "no mesh file but a pipe or a device"),
                               (made("empty.msh", b""), "empty.msh:1: the file is empty"),
                               (made("bom.msh", b"\xef\xbb\xbf" + WATERS.with_suffix(".msh").read_bytes()),
                                "bom.msh:1: the file begins with a byte-order mark"),
                               (CHAIN, "chain.xml:1: expected \\$MeshFormat: no MSH file")):
            with self.subTest(mesh=str(mesh)):
                deck.write_text(WATERS.with_suffix(".xml").read_text().replace("two_waters.msh", str(mesh)))
                self.refused(4, f"waters.xml:9:4: .*{sentence}", "check", "--mesh", deck)

    def test_that_are_no_tables(self):
        for table in "/dev/zero", SCRATCH, "/dev/null":
            self.refused(3, f"--set .*: cannot read the table {table}", "run", CHAIN, "--dry-run", "--set",
                         f"conditions/prescribe[tow]/table={table}")

    def test_that_are_no_decks(self):
        for deck in SCRATCH, "/dev/zero", SCRATCH / "nowhere.xml":
            self.refused(3, f"{deck}: the deck cannot be read", "check", deck)

    def test_that_are_no_checkpoints(self):
        for path, sentence in ((SCRATCH, "is a folder; a checkpoint is a file, such as .*/checkpoint.h5"),
                               (made("pipe"), "is not a checkpoint: it is no file"),
                               ("/dev/zero", "is not a checkpoint: it is no file"),
                               (CHAIN, "is not a checkpoint: it is no HDF5 file"),
                               (SCRATCH / "nowhere.h5", "No such file or directory")):
            self.refused(7, sentence, "restart", path)

    def test_a_step_that_is_lost_in_round_off(self):
        folder = fresh("lost")
        completed(1, "run", CHAIN, "-o", folder, "-q", "--end", "100")
        self.refused(3, "a step of 1e-20 s is lost in the round-off of t = 101 s", "restart", folder / "checkpoint.h5", "-q",
                     "--end", "101", "--set", "time/step=1e-20")


if __name__ == "__main__":
    main()

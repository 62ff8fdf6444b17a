"""What goes wrong ends with one sentence and its exit code, on one rank and on two, and never hangs."""
import re
import shutil

import h5py

from harness import DECKS, SCRATCH, Results, SystemTest, completed, edited, fresh, hawser, main

RANKS = 1, 2
INSIDE_OUT = r"cell \d+ of region 'water', which started near .* m, turned inside out \(det F <= 0\)"
JUMP = '<prescribe field="displacement" on="tail" from="60" value="2000 2000"/></conditions>'


def folding_deck():
    """Runs well for three steps; then the cable's tail must leap out of the box."""
    deck = edited("folding", time_least_step="5", time_end="100", output_fields_every="1")
    deck.write_text(deck.read_text().replace("</conditions>", JUMP))
    return deck


class Failures(SystemTest):
    def test_usage(self):
        for ranks in RANKS:
            for arguments in (), ("sail",), ("run", DECKS / "tow.xml"), ("check",), \
                    ("run", DECKS / "tow.xml", "-o", fresh("usage"), "--end", "-1"):
                with self.subTest(ranks=ranks, arguments=arguments):
                    done = hawser(ranks, *arguments)
                    self.assertEqual(done.returncode, 2, done.stderr)
                    self.assertEqual(done.stderr.count("Run with --help for more information."), 1)
            self.assertFails(2, "a deck has nothing called 'cabel'; hawser describe lists all there is; "
                                "did you mean 'cable'\\?", ranks, "describe", "cabel")

    def test_no_such_deck(self):
        for ranks in RANKS:
            self.assertFails(3, "nowhere.xml: the deck cannot be read", ranks, "check", "nowhere.xml")

    def test_a_result_folder_that_cannot_be_made(self):
        obstacle = SCRATCH / "obstacle"
        SCRATCH.mkdir(parents=True, exist_ok=True)
        obstacle.write_text("a regular file")
        for ranks in RANKS:
            self.assertFails(7, "cannot make the folder .*/obstacle/results: Not a directory", ranks,
                             "run", DECKS / "tow.xml", "-q", "-o", obstacle / "results")

    def test_results_of_a_finished_run_are_kept(self):
        deck, folder = edited("finished", time_end="20"), fresh("finished")
        completed(1, "run", deck, "-q", "-o", folder)
        before = {path: path.read_bytes() for path in folder.iterdir()}
        for ranks in RANKS:
            self.assertFails(7, ".*/finished holds the results of another run .*--force .*", ranks,
                             "run", deck, "-q", "-o", folder)
        self.assertEqual(before, {path: path.read_bytes() for path in folder.iterdir()})
        completed(2, "run", deck, "-q", "-o", folder, "--force")

    def test_an_expression_that_is_not_a_number(self):
        begin = edited("nan_at_the_start", initial_value="0; -0.5*sqrt(-1-t)")
        later = edited("nan_later", prescribe_value="0; -0.07*sqrt(50-t)", time_least_step="20")
        for ranks in RANKS:
            self.assertFails(6, r".*nan_at_the_start.xml:\d+:\d+: the expression '-0.5\*sqrt\(-1-t\)' is not a "
                                r"number at x = .*, y = .* m, t = 0 s", ranks,
                             "run", begin, "-q", "-o", fresh("nan_at_the_start"))
            folder = fresh("nan_later")
            self.assertFails(6, r".*nan_later.xml:\d+:\d+: the expression '-0.07\*sqrt\(50-t\)' is not a number at "
                                r"x = .*, y = .* m, t = 60 s; the least step was reached, .*checkpoint.h5",
                             ranks, "run", later, "-q", "-o", folder)
            self.assertEqual(list(Results(folder).history()["t_s"]), [20, 40])

    def test_newton_that_does_not_converge(self):
        deck = edited("newton", newton_max_iterations="1", newton_tolerance="1e-12", time_least_step="5")
        for ranks in RANKS:
            folder = fresh("newton")
            done = self.assertFails(6, "Newton: no convergence in 1 iterations; .* residual .*; the least step was "
                                       "reached, the last accepted state is in .*/newton/checkpoint.h5",
                                    ranks, "run", deck, "-q", "-o", folder)
            self.assertEqual(re.findall("step of (.*) s from t = 0 s rejected", done.stdout), ["20", "10", "5"])
            self.assertFails(6, "Newton: no convergence .*", ranks, "restart", folder / "checkpoint.h5", "-q")

    def test_a_mesh_that_folds_leaves_what_was_written_readable(self):
        deck = folding_deck()
        for ranks in RANKS:
            folder = fresh("folding")
            done = self.assertFails(6, rf"{INSIDE_OUT} at t = 65 s; the least step was reached, the last "
                                       "accepted state is in .*/folding/checkpoint.h5", ranks, "run", deck, "-q", "-o", folder)
            self.assertEqual(re.findall("step of (.*) s from t = 60 s rejected", done.stdout), ["20", "10", "5"])
            results = Results(folder)
            self.assertFalse((folder / "summary.json").exists())
            self.assertEqual(list(results.history()["t_s"]), [20, 40, 60])
            self.assertEqual(set(results.table("cable.csv")["t_s"]), {20, 40, 60})
            self.assertEqual(results.steps(), [1, 2, 3])
            with h5py.File(folder / "checkpoint.h5") as checkpoint:
                self.assertEqual((checkpoint.attrs["step"], checkpoint.attrs["time"]), (3, 60))
                kept = checkpoint["arrays/displacement-vertices-value"][:]
            shown = results.fields(3)["displacement"][:, :2]  # with the cable's nodes twice
            self.assertEqual(set(map(tuple, kept)), set(map(tuple, shown)))
            again = self.assertFails(6, f"{INSIDE_OUT} .*", ranks, "restart", folder / "checkpoint.h5", "-q")
            self.assertIn("from t = 60 s rejected", again.stdout)
            self.assertEqual(list(results.history()["t_s"]), [20, 40, 60])


class BrokenCheckpoint(SystemTest):
    def setUp(self):
        self.folder = fresh("broken")
        completed(1, "run", edited("broken", output_checkpoint_every="1", time_end="20"), "-q", "-o", self.folder)
        self.checkpoint = self.folder / "checkpoint.h5"

    def refused(self, sentence):
        for ranks in RANKS:
            self.assertFails(7, sentence, ranks, "restart", self.checkpoint, "--end", "40", "-q")
        self.assertTrue((self.folder / "summary.json").exists(), "earlier results must stay")

    def test_that_is_not_there(self):
        self.checkpoint.unlink()
        self.refused("cannot read the checkpoint .*/checkpoint.h5: No such file or directory")

    def test_that_is_no_hdf5_file(self):
        self.checkpoint.write_text("Dear diary, today")
        self.refused(".*/checkpoint.h5 is not a checkpoint: it is no HDF5 file")

    def test_that_is_cut_short(self):
        whole = self.checkpoint.read_bytes()
        self.checkpoint.write_bytes(whole[:len(whole) // 2])
        self.refused(".*/checkpoint.h5.*")

    def test_of_which_one_number_changed(self):
        with h5py.File(self.checkpoint, "r+") as file:
            array = next(iter(file["arrays"].values()))
            array[0, 0] += 1e-12
        self.refused(".*/checkpoint.h5 is damaged: it is not what was written")

    def test_that_is_another_hdf5_file(self):
        shutil.copy(self.folder / "flow-000001.h5", self.checkpoint)
        self.refused(".*/checkpoint.h5 is not a checkpoint")

    def test_of_a_run_that_is_at_its_end(self):
        for ranks in RANKS:
            self.assertFails(2, ".*/checkpoint.h5 is at t = 20 s, and the run ends at 20 s: nothing is left to do; "
                                "--end sets a later end", ranks, "restart", self.checkpoint)

    def test_does_not_let_other_results_be_replaced(self):
        other = fresh("other")
        completed(1, "run", edited("other", time_end="20"), "-q", "-o", other)
        self.assertFails(7, ".*/other holds the results of another run .*", 1, "restart", self.checkpoint,
                         "--end", "40", "-o", other)


if __name__ == "__main__":
    main()

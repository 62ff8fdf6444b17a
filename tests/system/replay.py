"""Navigation out and in: a line that a model sailed, as P1/90 read by a reader of this test's own, and replayed."""
import json
import math

import numpy as np

from harness import DECKS, SCRATCH, Results, SystemTest, completed, fresh, hawser, main

def read_p190(path):
    """By the public description of UKOOA P1/90 alone, columns from 1: per shot its number, seconds since the first one,
    latitude and longitude in degrees, and {receiver: (easting, northing, depth)}."""
    shots, day0 = [], None

    def degrees(text, width):
        value = int(text[:width]) + int(text[width:width + 2]) / 60 + float(text[width + 2:width + 7]) / 3600
        return -value if text[width + 7] in "SW" else value

    for record in path.read_text().splitlines():
        if record.startswith("EOF"):
            continue
        assert len(record) == 80, record
        if record[0] == "S":
            day, clock = int(record[70:73]), record[73:79]
            day0 = day if day0 is None else day0
            days = (day - day0) % 365
            seconds = days * 86400 + int(clock[:2]) * 3600 + int(clock[2:4]) * 60 + int(clock[4:])
            shots.append(dict(line=record[1:13].strip(), number=int(record[19:25]), time=seconds, at=(degrees(record[25:35], 2), degrees(record[35:46], 3)),
                              head=(float(record[46:55]), float(record[55:64])), receivers={}))
        elif record[0] == "R":
            for start in 1, 27, 53:
                part = record[start:start + 26]
                if part.strip():
                    shots[-1]["receivers"][int(part[:4])] = (float(part[4:13]), float(part[13:22]), float(part[22:26]))
        else:
            assert record[0] in "HV", record
    return shots


def utm(latitude, longitude, zone):
    """Easting and northing on WGS 84, north of the equator: Snyder, Map Projections, 1987, equations 8-9 to 8-15."""
    a, e2, k0 = 6378137.0, 0.00669437999014, 0.9996
    phi, delta = math.radians(latitude), math.radians(longitude - (6 * zone - 183))
    n = a / math.sqrt(1 - e2 * math.sin(phi) ** 2)
    t, c = math.tan(phi) ** 2, e2 / (1 - e2) * math.cos(phi) ** 2
    x = delta * math.cos(phi)
    m = a * ((1 - e2 / 4 - 3 * e2 ** 2 / 64 - 5 * e2 ** 3 / 256) * phi - (3 * e2 / 8 + 3 * e2 ** 2 / 32 + 45 * e2 ** 3 / 1024) * math.sin(2 * phi)
             + (15 * e2 ** 2 / 256 + 45 * e2 ** 3 / 1024) * math.sin(4 * phi) - 35 * e2 ** 3 / 3072 * math.sin(6 * phi))
    east = k0 * n * (x + (1 - t + c) * x ** 3 / 6 + (5 - 18 * t + t ** 2 + 72 * c - 58 * e2 / (1 - e2)) * x ** 5 / 120)
    north = k0 * (m + n * math.tan(phi) * (x ** 2 / 2 + (5 - t + 9 * c + 4 * c ** 2) * x ** 4 / 24))
    return 500000 + east, north


class Replay(SystemTest):
    @classmethod
    def setUpClass(cls):
        sailed = Results(fresh("sailed"))
        completed(1, "run", DECKS / "sailed.xml", "-o", sailed.folder, "-q", seconds=600)
        cls.folder = sailed.folder
        cls.rows = sailed.table("receivers.csv")
        cls.shots = read_p190(cls.folder / "line.p190")
        cls.csv = SCRATCH / "line.csv"
        numbers = np.unique(cls.rows["t_s"], return_inverse=True)[1]
        cls.write(cls.csv, zip(numbers, cls.rows["receiver"] * 4, cls.rows["x_m"], cls.rows["y_m"], cls.rows["t_s"]))

    @staticmethod
    def write(path, rows, header="shot,receiver,east_m,north_m,time_s"):
        path.write_text(header + "\n" + "".join(f"{s:.0f},{r:.0f},{x:.4f},{y:.4f},{t:.6f}\n" for s, r, x, y, t in rows))

    def replayed(self, line, name, *options, ranks=1):
        folder = SCRATCH / name
        done = completed(ranks, "replay", line, "-o", folder, "-f", *options, seconds=600)
        return json.loads((folder / "replay.json").read_text()), done.stdout

    def test_tangents_are_exact(self):
        completed(1, "jacobian", DECKS / "sailed.xml")  # cable, drag and drogue

    def test_any_part_of_the_line_will_do(self):
        # Ends of runs are times of shots, whatever digits they have.
        rows = self.csv.read_text().splitlines()
        for first, last, speed in (3, 41, 2.3456789), (20, 77, 1.9), (50, 90, 2.71):
            part = SCRATCH / f"part_{first}.csv"
            part.write_text("\n".join(row.rsplit(",", 1)[0] for row in rows if row[0] == "s" or first <= int(row.split(",")[0]) <= last) + "\n")
            found, _ = self.replayed(part, f"part_{first}", "--spacing", "25", "--speed", speed, "--segments", "15")
            self.assertEqual(found["shots"], last - first + 1)

    def test_shots_are_every_50_m_of_tow(self):
        heads = self.rows["receiver"] == 1
        ways = np.hypot(np.diff(self.rows["x_m"][heads]), np.diff(self.rows["y_m"][heads]))
        self.assertGreater(len(ways), 80)
        np.testing.assert_allclose(ways, 50, atol=0.05)  # chords of a turn of 800 m

    def test_p190_says_where_when_and_on_which_datum(self):
        times = np.unique(self.rows["t_s"])
        self.assertEqual([shot["number"] for shot in self.shots], list(range(1001, 1001 + len(times))))
        for i, shot in enumerate(self.shots):
            self.assertEqual(shot["line"], "SAILED")
            self.assertLessEqual(abs(shot["time"] - self.shots[0]["time"] - times[i]), 0.5 + 1e-9)  # whole seconds, over New Year
            of_shot = self.rows["t_s"] == times[i]
            self.assertEqual(list(shot["receivers"]), list(range(1, 17)))
            places = np.array(list(shot["receivers"].values()))
            np.testing.assert_allclose(places[:, 0], self.rows["x_m"][of_shot] + 400000, atol=0.051)
            np.testing.assert_allclose(places[:, 1], self.rows["y_m"][of_shot] + 6500000, atol=0.051)
            np.testing.assert_array_equal(places[:, 2], 8)
            np.testing.assert_allclose(utm(*shot["at"], zone=31), shot["head"], atol=0.25)  # .01" and .1 m
        headers = (self.folder / "line.p190").read_text()
        for words in "WGS 84 6378137.000 298.2572236", "WGS 84 / UTM zone 31N", "EPSG:32631", "GMT", "METRES":
            self.assertIn(words, headers)

    def test_a_twin_is_found_again(self):
        found, _ = self.replayed(self.csv, "twin", "--smooth", "0", "--shape-smooth", "0", "--spacing", "25", "--set", "tail_drag_area=0.3", "--fit", "ct,current_east,current_north", "--segments", "30")
        values = {p["name"]: p["value"] for p in found["fit"]["parameters"]}
        self.assertLess(found["model"]["rms_m"], 1)
        self.assertGreater(found["path_in_the_water"]["rms_m"], 30)
        self.assertAlmostEqual(values["current_east"], 0.08, delta=0.004)
        self.assertAlmostEqual(values["current_north"], -0.05, delta=0.004)
        self.assertAlmostEqual(values["ct"], 0.008, delta=0.0004)

    def test_p190_is_replayed_like_csv(self):
        of_csv, _ = self.replayed(self.csv, "of_csv", "--spacing", "25", "--set", "ct=0.008", "--set", "tail_drag_area=0.3")
        of_p190, _ = self.replayed(self.folder / "line.p190", "of_p190", "--spacing", "100", "--set", "ct=0.008", "--set", "tail_drag_area=0.3")
        self.assertEqual(of_p190["format"], "P1/90")
        self.assertEqual(of_csv["shots"], of_p190["shots"])
        self.assertAlmostEqual(of_csv["model"]["rms_m"], of_p190["model"]["rms_m"], delta=1.5)

    def test_the_deck_runs_to_the_same_places(self):
        self.replayed(self.csv, "deck", "--spacing", "25", "--segments", "15", "--step", "100", "--set", "diameter=50 mm")
        folder = SCRATCH / "deck"
        self.assertIn('name="diameter" value="0.05 m"', (folder / "deck.xml").read_text())
        completed(1, "check", folder / "deck.xml")
        completed(2, "run", folder / "deck.xml", "-o", folder / "run", "-f", "-q", seconds=600)
        ran, told = Results(folder / "run").table("receivers.csv"), Results(folder).table("residuals.csv")
        for name in "x_m", "y_m":
            np.testing.assert_allclose(ran[name], told["model_" + name], atol=1e-3)  # of three decimals

    def test_ranks_make_no_difference_and_parameters_are_handed_on(self):
        one, _ = self.replayed(self.csv, "one", "--spacing", "25", "--segments", "15", "--step", "100", "--fit", "ct")
        two, _ = self.replayed(self.csv, "two", "--spacing", "25", "--segments", "15", "--step", "100", "--with", SCRATCH / "one", ranks=2)
        self.assertEqual(one["parameters"], two["parameters"])
        self.assertAlmostEqual(one["model"]["rms_m"], two["model"]["rms_m"], delta=1e-6)
        self.assertTrue((SCRATCH / "one/map.png").exists() and (SCRATCH / "one/errors.png").exists())

    def test_says_what_the_line_does_not_tell(self):
        # Straight on at one speed: drag coefficients only turn the cable a little, and cn does what ct undoes.
        _, told = self.replayed(self.csv, "apart", "--spacing", "25", "--segments", "15", "--fit", "ct")
        self.assertRegex(told, r"cn was held, and moves the receivers as ct does \(cosine -1\.0")

    def test_what_cannot_be_is_told(self):
        text = self.csv.read_text().splitlines()
        cases = {
            "swapped": (["receiver,shot" + text[0][len("shot,receiver"):], *text[1:]], "are the columns shot and receiver mixed up"),
            "gap": ([line for line in text if not line.startswith(tuple(f"{i}," for i in range(30, 40)))], "the head is not known for"),
            "back": ([text[0], *(line.rsplit(",", 1)[0] + f",{1000 - float(line.rsplit(',', 1)[1])}" for line in text[1:])], "is not after that of shot"),
            "jump": ([line.replace("20,4,", "20,4,9", 1) for line in text], "from where it was at the shot before"),
        }
        for name, (lines, words) in cases.items():
            path = SCRATCH / f"{name}.csv"
            path.write_text("\n".join(lines) + "\n")
            process = hawser(1, "replay", path, "-o", SCRATCH / "never", "--spacing", "25")
            self.assertEqual(process.returncode, 3, name)
            self.assertIn(words, process.stderr, name)
        for options, words in ((["--fit", "cd"], "--fit: there is no 'cd'"), (["--set", "density"], "density"), (["--fit", "mass"], "there is no 'mass'")):
            process = hawser(1, "replay", self.csv, "-o", SCRATCH / "never", "--spacing", "25", *options)
            self.assertNotEqual(process.returncode, 0)
            self.assertIn(words, process.stderr)
        process = hawser(1, "replay", self.csv, "-o", self.folder.parent / "sailed_again", "--speed", "2", "--spacing", "25")
        self.assertIn("the file has times; a speed would contradict them", process.stderr)


if __name__ == "__main__":
    main()

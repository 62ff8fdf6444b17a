"""Disks that fail, checkpoints that are spoilt, decks and meshes and tables that are mangled."""
import resource
import shutil

from harness import ROOT, SCRATCH, fresh
from trials import DECK, HERE, Count, chance, copy, differ, environment, go_on, reference, run

KINDS = {"eio": 400, "full": 400, "readonly": 120, "lost": 400, "short": 400}  # calls that go well before, at most


def disks(count, seed):
    """Exit code 7 with one sentence, and the last good checkpoint intact; or the same end, where a layer below has
    made good what went wrong."""
    dice, whole, good = chance(seed), reference("disks.whole"), True
    for kind in KINDS:
        result, refused = Count(f"{kind}: exit code 7 and resumed, or the same end"), 0
        for _ in range(max(1, count // len(KINDS)) if count < 50 else count):
            folder = fresh("disks")
            code, said = run("run", DECK, "-o", folder, "-q",
                             env=environment(kind, "run/reliability/disks/", dice.randrange(KINDS[kind])))
            if code == 0:
                result.add(differ(whole, folder))
                continue
            refused += 1
            # Open MPI has words of its own for some of them.
            sentences = [line for line in said.splitlines() if not line.startswith("mca_")]
            if code != 7 or len(sentences) != 1:
                result.add(f"{kind}: exit code {code}: {said}")
            else:
                result.add(go_on(whole, folder))
        good = result.report() and good
        print(f"  {refused} of them with exit code 7")
    return good


def spoil(dice, data):
    """Bytes with a flipped bit, a byte of another value, a stretch of zeros, or cut short."""
    data, kind = bytearray(data), dice.choice(["flip", "flip", "flip", "byte", "zeros", "cut"])
    at = dice.randrange(len(data))
    if kind == "flip":
        data[at] ^= 1 << dice.randrange(8)
    elif kind == "byte":
        data[at] = (data[at] + dice.randrange(1, 256)) % 256
    elif kind == "zeros":
        data[at:at + dice.randrange(1, 5000)] = bytes(len(data[at:at + 4999]))[:len(data[at:])]
    else:
        del data[at:]
    return bytes(data), f"{kind} at {at}"


def flips(count, seed):
    """Told, or harmless as the same end shows; with the one before it beside it, gone on from that one."""
    dice, result, told = chance(seed), Count("spoilt checkpoints: told, or harmless"), 0
    whole = reference("flips.whole")
    source = fresh("flips.source")
    run("run", DECK, "-o", source, "-q", "--end", "100")
    intact = (source / "checkpoint.h5").read_bytes()
    for trial in range(count):
        folder = copy(source, "flips")
        spoilt, what = spoil(dice, intact)
        (folder / "checkpoint.h5").write_bytes(spoilt)
        fall_back = trial % 10 == 0
        if not fall_back:
            (folder / "checkpoint.previous.h5").unlink()
        code, said = run("restart", folder / "checkpoint.h5", "-q", "--end", "200")
        if fall_back or spoilt == intact:
            warned = spoilt == intact or "going on from the checkpoint before it" in said
            result.add(differ(whole, folder) if code == 0 and warned else f"{what}: {code} {said}")
        elif code == 7 and said.count("\n") == 1 and "checkpoint.h5" in said:
            told += 1
            result.add(None)
        else:
            result.add(differ(whole, folder) if code == 0 else f"{what}: {code} {said}")
    print(f"  {told} told")
    return result.report()


def mangled(dice, text):
    """A text with a few characters changed, doubled, taken away or moved."""
    for _ in range(dice.randrange(1, 4)):
        at, other = dice.randrange(len(text)), dice.randrange(len(text))
        length = dice.randrange(1, 20)
        text = dice.choice([
            text[:at] + dice.choice("<>/=\"' \n\t\0;,.-+eE0123456789xyzNaN#$%\xe4\u20ac") + text[at + 1:],
            text[:at] + text[at + length:],
            text[:at] + text[other:other + length] + text[at:],
            text[:at] + dice.choice(["nan", "inf", "-1", "1e400", "99999999999", "0x10", "\ufeff"]) + text[at:],
        ])
    return text


def processor_seconds():
    """Of all processes that have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def mutants(count, seed):
    """Of decks, tables and meshes: an answer or a sentence with the file's name, never a crash, never more than 10 s."""
    dice, good = chance(seed), True
    folder = SCRATCH / "mutants"
    texts = {"chain.xml": (HERE / "chain.xml").read_text(), "track.csv": (HERE / "track.csv").read_text()}
    waters = ROOT / "inputs/tutorials"
    texts_of_mesh = {"two_waters.xml": (waters / "two_waters.xml").read_text(),
                     "two_waters.msh": (waters / "two_waters.msh").read_text()}
    for victim, deck, all_texts in (("chain.xml", "chain.xml", texts), ("track.csv", "chain.xml", texts),
                                    ("two_waters.msh", "two_waters.xml", texts_of_mesh)):
        result = Count(f"mutants of {victim}: no crash, no hang, every refusal with the file's name")
        for _ in range(count // 3):
            shutil.rmtree(folder, ignore_errors=True)
            folder.mkdir(parents=True)
            for name, text in all_texts.items():
                (folder / name).write_text(mangled(dice, text) if name == victim else text, errors="replace")
            before = processor_seconds()
            code, said = run("run", folder / deck, "--dry-run")
            if processor_seconds() - before > 10:
                code = "takes more than 10 s"
            named = any(name in said for name in all_texts)
            fault = None if code == 0 or code in (3, 4, 5, 6) and named else f"{code}: {said[-500:]}"
            if fault:
                shutil.copytree(folder, SCRATCH / f"mutant-{victim}-{result.all}", dirs_exist_ok=True)
            result.add(fault)
        good = result.report() and good
    return good



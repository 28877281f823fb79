"""run_test.py: the golden runner passes what is right, and fails, at the right place, what is not."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent

# skyway-fake SCRIPT: prints what SCRIPT says, in the words of printf(1), to stdout and stderr, and ends with its code.
FAKE = """#!/bin/sh
printf "$1"
printf "$2" >&2
exit ${3:-0}
"""

RIGHT = """# A comment.

== it succeeds
$ skyway-fake 'one\\ntwo\\n'
one
two

== it fails
# Another comment.
$ skyway-fake 'out\\n' 'err\\n' 3
out
! err
[3]

== a third
$ skyway-fake ''
"""


class Runner(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.golden = pathlib.Path(folder.name)
        for name in ("run.py", "transcript.py"):
            shutil.copy(HERE / name, self.golden)
        (self.golden / "data").mkdir()
        (self.golden / "data" / "given").write_text("given\n")
        (self.golden / "bin").mkdir()
        (self.golden / "bin" / "skyway-fake").write_text(FAKE)
        (self.golden / "bin" / "skyway-fake").chmod(0o755)
        self.setups = ""

    def run_golden(self, text, update=False):
        """The exit code and what was printed."""
        (self.golden / "skyway-fake.txt").write_bytes(text.encode())
        (self.golden / "setups.txt").write_text(self.setups or "# None.\n")
        env = dict(os.environ, UPDATE_GOLDEN="1" if update else "0")
        done = subprocess.run([sys.executable, self.golden / "run.py", self.golden / "bin", "skyway-fake"],
                              capture_output=True, text=True, env=env)
        return done.returncode, done.stdout + done.stderr

    def rewritten(self):
        return (self.golden / "skyway-fake.txt").read_bytes().decode()

    def passes(self, text):
        code, said = self.run_golden(text)
        self.assertEqual(code, 0, said)
        self.assertIn(" 0 failures", said)

    def fails(self, text, *says):
        code, said = self.run_golden(text)
        self.assertEqual(code, 1, said)
        for words in says:
            self.assertIn(words, said)
        self.assertNotIn("Traceback", said)


class Differences(Runner):
    def test_what_is_right_passes(self):
        self.passes(RIGHT)

    def test_each_difference_fails_its_case(self):
        for right, wrong, case in (
                ("one\ntwo\n\n", "one\nthree\n\n", "it succeeds"),  # another line
                ("one\ntwo\n\n", "one\n\n", "it succeeds"),  # one too few
                ("one\ntwo\n\n", "one\ntwo\nthree\n\n", "it succeeds"),  # one too many
                ("one\ntwo\n\n", "one\ntwo\n\\\n\n", "it succeeds"),  # an empty one too many
                ("one\ntwo\n\n", "one\ntwo \n\n", "it succeeds"),  # a blank
                ("one\ntwo\n\n", "one\n\\ two\\c\n\n", "it succeeds"),  # no newline at the end
                ("'one\\ntwo\\n'", "'one\\ntwo'", "it succeeds"),
                ("'one\\ntwo\\n'", "'one\\ntwo\\n\\n'", "it succeeds"),
                ("'one\\ntwo\\n'", "'one\\r\\ntwo\\n'", "it succeeds"),
                ("'one\\ntwo\\n'", "'one\\ntwo\\n' '' 1", "it succeeds"),  # an exit code, silently
                ("'one\\ntwo\\n'", "'one\\ntwo\\n' 'x'", "it succeeds"),  # stderr, with success
                ("! err\n", "! other\n", "it fails"),
                ("! err\n", "", "it fails"),
                ("! err\n", "! err\n! err\n", "it fails"),
                ("! err\n", "!\\ err\\c\n", "it fails"),
                ("out\n! err\n", "! out\n! err\n", "it fails"),  # on the other stream
                ("[3]\n", "[4]\n", "it fails"),
                ("[3]\n", "", "it fails"),
                ("skyway-fake ''\n", "skyway-fake ''\n[1]\n", "a third")):
            with self.subTest(wrong=wrong):
                self.assertEqual(RIGHT.count(right), 1)
                self.fails(RIGHT.replace(right, wrong), f": {case}: $ ", "1 failures")

    def test_every_command_of_a_case_counts(self):
        self.fails(RIGHT + "$ false\n$ true\n", "skyway-fake.txt:17: a third: $ false")
        self.fails(RIGHT + "$ true\n$ echo x\n$ true\n", "skyway-fake.txt:18: a third: $ echo x")

    def test_a_part_file_left_behind_fails(self):
        self.fails(RIGHT + "$ touch x.part\n", "a third: left behind: x.part")
        self.fails(RIGHT + "$ mkdir d\n$ touch d/x.part\n", "a third: left behind: d/x.part")

    def test_three_cases_are_required_with_success_and_failure(self):
        self.fails(RIGHT[:RIGHT.index("== a third")], "at least three cases")
        self.fails(RIGHT.replace("[3]\n", "").replace(" 3\n", "\n"), "at least three cases")
        only_failures = RIGHT.replace("'one\\ntwo\\n'\n", "'one\\ntwo\\n' '' 1\n").replace("two\n\n", "two\n[1]\n\n")
        self.fails(only_failures.replace("skyway-fake ''\n", "true\n"), "at least three cases")
        # That another program fails does not do.
        self.fails(RIGHT.replace("[3]\n", "$ test -e nothing\n[1]\n").replace(" 3\n", "\n"), "at least three cases")


class Session(Runner):
    def test_a_case_is_one_session(self):
        self.passes(RIGHT + "$ x=5\n$ mkdir d\n$ cd d\n$ echo $x $(basename $PWD)\n5 d\n"
                    "$ (exit 7)\n[7]\n$ echo $?\n7\n")

    def test_a_pipe_has_the_exit_code_of_what_failed(self):
        self.passes(RIGHT + "$ false | cat\n[1]\n")

    def test_commands_of_many_lines(self):
        self.passes(RIGHT + "$ cat <<'END' |\n> a  b\n>\n> c\n> END\n>   tr a-z A-Z\nA  B\n\\\nC\n")

    def test_what_stands_after_an_exit_fails(self):
        self.fails(RIGHT + "$ exit 0\n$ true\n", "skyway-fake.txt:18: a third: not run to its end")
        self.passes(RIGHT + "$ exit 5\n[5]\n")

    def test_what_takes_too_long_fails_also_in_an_update(self):
        run = self.golden / "run.py"
        run.write_text(run.read_text().replace("TIME_LIMIT = 400", "TIME_LIMIT = 1"))
        text = RIGHT + "$ sleep 60\n$ true\n"
        for update in (False, True):
            code, said = self.run_golden(text, update)
            self.assertEqual(code, 1, said)
            self.assertIn("skyway-fake.txt:17: a third: not run to its end", said)
            self.assertIn("2 failures", said)
            self.assertEqual(self.rewritten(), text)

    def test_cases_do_not_share_a_folder(self):
        self.passes(RIGHT + "$ cat given\ngiven\n$ rm given\n$ touch new\n\n== next\n$ ls\ngiven\n")


class SetUps(Runner):
    def test_set_ups_begin_with_each_other_and_run_once(self):
        count = self.golden / "count"
        self.setups = f"== setup base\n$ echo base > base\n$ echo x >> {count}\n"
        self.passes(RIGHT + "\n== setup more\nwith base\n$ cat base base > more\n"
                    "\n== one\nwith more\n$ cat more\nbase\nbase\n$ echo changed >> more\n$ rm base given\n"
                    "\n== two\nwith more\n$ cat more\nbase\nbase\n$ ls\nbase\ngiven\nmore\n"
                    "\n== three\nwith base\n$ ls\nbase\ngiven\n")
        self.assertEqual(count.read_text(), "x\n")

    def test_a_set_up_that_fails_fails_its_cases(self):
        cases = "\n== one\nwith base\n$ true\n\n== setup more\nwith base\n$ true\n\n== two\nwith more\n$ true\n"
        for command in ("false", "echo x", "echo x >&2", "touch x.part", "exit 0\n$ true"):
            with self.subTest(command=command):
                self.setups = f"# Shared.\n\n== setup base\n$ {command}\n"
                self.fails(RIGHT + cases, ': one: the set-up "base" (setups.txt:3)' if "part" not in command else
                           ": one: left behind: x.part", ": two: ", "2 failures")


class Malformed(Runner):
    def test_the_place_is_told(self):
        lines = RIGHT.count("\n")
        for added, line, says in (
                ("\n== it fails\n$ true\n", 2, '"it fails" is also at skyway-fake.txt:8'),
                ("\n== empty\n", 2, '"empty" has no command'),
                ("\n== \n$ true\n", 2, "a title is missing"),
                ("\n== x\nwith nothing\n$ true\n", 3, 'no set-up "nothing"'),
                ("\n== x\nwith late\n$ true\n\n== setup late\n$ true\n", 3, 'no set-up "late"'),
                ("\n== setup x\nwith x\n$ true\n", 3, 'no set-up "x"'),
                ("\n== setup x\n$ true\n\n== y\nwith x\nwith x\n$ true\n", 7, "a second set-up"),
                ("\n== setup x\n$ true\n\n== setup x\n$ true\n", 5, '"x" is also at'),
                ("\n== setup x\n$ true\nout\n", 4, "a set-up prints nothing"),
                ("\n== x\nout\n$ true\n", 3, "output stands directly below its command"),
                ("\nout\n", 2, "output stands directly below its command"),
                ("# A comment.\nout\n", 2, "output stands directly below its command"),
                ("out\n> more\n", 2, '"> " continues the line of a command'),
                ("! err\nout\n", 2, "stdout stands above stderr"),
                ("[1]\nout\n", 2, "the exit code ends"),
                ("[0]\n", 1, "an exit code is 1 to 255"),
                ("[256]\n", 1, "an exit code is 1 to 255"),
                ("\\ a\\c\nb\n", 2, "a line follows the one that has no newline"),
                ("\\ \\n\n", 1, "behind a backslash stand"),
                ("\\ a\\cb\n", 1, "behind a backslash stand"),
                ("\\a\n", 1, "a blank is missing"),
                ("!\n", 1, "a blank is missing"),
                ("$\n", 1, "a blank is missing"),
                ("out\r\n", 1, "a carriage return"),
                ("out", 1, "the last line has no newline")):
            with self.subTest(added=added):
                self.fails(RIGHT + added, f"skyway-fake.txt:{lines + line}: {says}")

    def test_what_is_malformed_is_not_rewritten(self):
        malformed = RIGHT + "$ echo a\n[0]\n"
        code, said = self.run_golden(malformed, update=True)
        self.assertEqual(code, 1, said)
        self.assertEqual(self.rewritten(), malformed)

    def test_a_transcript_without_cases(self):
        self.fails("# Nothing.\n", "skyway-fake.txt:1: no case")
        self.fails("", "skyway-fake.txt:1: ")
        self.fails("$ true\n", 'skyway-fake.txt:1: a case begins with "== "')

    def test_bytes_that_are_not_utf_8(self):
        (self.golden / "setups.txt").write_bytes(b"# a\n\n# \xff\n")
        (self.golden / "skyway-fake.txt").write_text(RIGHT)
        done = subprocess.run([sys.executable, self.golden / "run.py", self.golden / "bin", "skyway-fake"],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 1)
        self.assertIn("setups.txt:3: not UTF-8", done.stderr)

    def test_cases_among_the_shared_set_ups(self):
        self.setups = "== a case\n$ true\n"
        self.fails(RIGHT, "setups.txt:1: cases stand")


class Update(Runner):
    def test_nothing_changes_where_nothing_did(self):
        code, said = self.run_golden(RIGHT, update=True)
        self.assertEqual(code, 0, said)
        self.assertEqual(self.rewritten(), RIGHT)

    def test_only_results_are_rewritten(self):
        wrong = RIGHT.replace("one\ntwo\n\n", "three\n! four\n[5]\n\n").replace("out\n! err\n[3]\n", "")
        wrong = wrong.replace("skyway-fake ''\n", "skyway-fake ''\nx\n")
        code, said = self.run_golden(wrong, update=True)
        self.assertEqual(code, 0, said)
        self.assertEqual(self.rewritten(), RIGHT)

    def test_any_bytes_come_back(self):
        marks = ["$", ">", "!", "#", "==", "\\", "!\\", "[1]", "[12", "[a]"]
        hard = [*marks, *(mark + " a" for mark in marks), "with x", "", " ", "a ", " a", "\\\\x", "\t", "a\tb",
                "\r", "a\r", "\x1b[1m", "\x00", "\x7f", "grün", "\u2028", "\u00a0", "\ufeff", "\ufffd"]
        raw = [text.encode() for text in hard] + [b"\xff", b"a\xc3", bytes(range(10)), bytes(range(11, 256))]
        whole = b"\n".join(raw)
        for i, content in enumerate(raw + [whole, whole + b"\n", b"\n\n", b"\n"]):
            for end in (b"", b"\n"):
                (self.golden / "data" / f"{i}.{len(end)}").write_bytes(content + end)
        cases = "".join(f"\n== {name}\n$ cat {name}\n$ cat {name} >&2\n$ cat {name}; cat {name} >&2; (exit 9)\n"
                        for name in sorted(os.listdir(self.golden / "data")))
        code, said = self.run_golden(RIGHT + cases, update=True)
        self.assertEqual(code, 0, said)
        updated = self.rewritten()
        self.assertGreater(len(updated), len(RIGHT + cases))
        self.assertTrue(all(c.isprintable() or c in "\t\n" for c in updated))
        self.assertNotIn(" \n", updated)
        self.passes(updated)
        self.run_golden(updated, update=True)
        self.assertEqual(self.rewritten(), updated)

    def test_a_set_up_that_fails_changes_nothing(self):
        self.setups = "== setup base\n$ false\n"
        text = RIGHT + "\n== one\nwith base\n$ echo a\nb\n"
        code, said = self.run_golden(text, update=True)
        self.assertEqual(code, 1, said)
        self.assertEqual(self.rewritten(), text)


unittest.main()

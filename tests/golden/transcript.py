r"""The text of golden cases: sessions at a shell, one file a tool.

    # A line like this is a comment.

    == setup village
    $ skyway-import village.csv -q -o m.boxmap

    == the start is inside a building
    with village
    $ skyway-plan m.boxmap --from 20,20,5 --to 70,10,5 |
    >   tee p.jsonl
    {"type":"path","id":"q0","status":"start_blocked"}
    ! skyway-plan: warning: q0: start_blocked
    [1]

A case has a title, the set-up that it begins with (if any), and commands. Below a command stand its
stdout as it is, its stderr after "! ", and its exit code in brackets unless that is 0. A blank line ends
them. A set-up is written the same way; its commands print nothing and succeed. It may begin with
another one, and stands before all that begin with it; those of setups.txt are known to every file.

What cannot stand as it is (an empty line, one that looks like a mark, one that ends in a blank, bytes
that are not printable UTF-8, a last line without its newline) stands behind a backslash and a blank, on
stderr behind "!\ ". There \\ is a backslash, \x1b a byte, and \c at the end says that no newline follows.
"""

import dataclasses
import re

MARK = re.compile(r"(\$|>|!|#|==)( |$)|!?\\|\[[0-9]+\]$")
ESCAPE = re.compile(r"\\(?:(\\)|x([0-9a-f]{2})|(c)$|)")


class Malformed(Exception):
    pass


@dataclasses.dataclass
class Result:
    stdout: bytes = b""
    stderr: bytes = b""
    exit: int = 0


@dataclasses.dataclass
class Command:
    line: int  # where it begins, from 1
    text: str
    below: int = 0  # its result stands in lines[below:end]
    end: int = 0
    expected: Result = dataclasses.field(default_factory=Result)


@dataclasses.dataclass
class Session:
    place: str  # file and line, for messages
    title: str
    setup: "Session | None" = None
    commands: list = dataclasses.field(default_factory=list)


@dataclasses.dataclass
class Transcript:
    lines: list
    setups: dict
    cases: dict


def show_line(line, is_stderr):
    """One line of output as it stands in a transcript."""
    body = line.removesuffix(b"\n")
    text = body.decode(errors="replace")
    as_it_is = (line != body and text and text.encode() == body and text == text.rstrip()
                and text.replace("\t", "").isprintable())
    if as_it_is and (is_stderr or not MARK.match(text)):
        return "! " + text if is_stderr else text
    escaped = "".join(r"\\" if c == 0x5C else chr(c) if 0x20 <= c < 0x7F else f"\\x{c:02x}" for c in body)
    if line == body:
        escaped += r"\c"
    elif escaped.endswith(" "):
        escaped = escaped[:-1] + r"\x20"
    return ("!" if is_stderr else "") + ("\\ " + escaped).rstrip()


def show(result):
    """The lines below a command that gave `result`; Result() gives none."""
    lines = [show_line(line, is_stderr)
             for is_stderr, stream in enumerate((result.stdout, result.stderr))
             for line in re.findall(rb"[^\n]*\n|[^\n]+", stream)]
    return lines + [f"[{result.exit}]"] * (result.exit != 0)


def unescape(text, place):
    """The bytes that stand behind a backslash and a blank."""
    data, at, newline = b"", 0, b"\n"
    for escape in ESCAPE.finditer(text):
        data += text[at:escape.start()].encode()
        at = escape.end()
        backslash, byte, no_newline = escape.groups()
        if backslash:
            data += b"\\"
        elif byte:
            data += bytes.fromhex(byte)
        elif no_newline:
            newline = b""
        else:
            raise Malformed(f"{place}: behind a backslash stand \\, x and two small hexadecimal digits, or a last c")
    return data + text[at:].encode() + newline


class Reader:
    """Takes the lines of a transcript one by one."""

    def __init__(self, name, known):
        self.name = name
        self.known = known
        self.found = Transcript([], {}, {})
        self.session = None  # that we are in
        self.command = None  # whose result may still go on
        self.typing = False  # the last line was a command's

    def fail(self, message):
        raise Malformed(f"{self.place}: {message}")

    def take(self, line):
        self.found.lines.append(line)
        self.place = f"{self.name}:{len(self.found.lines)}"
        typing, self.typing = self.typing, False
        if line.startswith("== "):
            self.begin(line[3:])
        elif not line or line == "#" or line.startswith("# "):
            self.command = None
        elif self.session is None:
            self.fail('a case begins with "== " and its title')
        elif line.startswith("$ "):
            self.type(line[2:])
        elif line == ">" or line.startswith("> "):
            if not typing:
                self.fail('"> " continues the line of a command (in output, write "\\ > ")')
            self.command.text += "\n" + line[2:]
            self.typing = True
        elif not self.session.commands and line.startswith("with "):
            self.begin_with(line[5:])
        else:
            self.print(line)
        if self.typing:
            self.command.below = len(self.found.lines)
        if self.command:
            self.command.end = len(self.found.lines)

    def begin(self, title):
        self.close()
        is_setup = title.startswith("setup ")
        if is_setup:
            title = title[len("setup "):]
        named = {**self.known, **self.found.setups} if is_setup else self.found.cases
        if not title.strip():
            self.fail("a title is missing")
        if title in named:
            self.fail(f'"{title}" is also at {named[title].place}')
        self.session = Session(self.place, title)
        (self.found.setups if is_setup else self.found.cases)[title] = self.session

    def begin_with(self, name):
        setup = self.known.get(name) or self.found.setups.get(name)
        if setup is None or setup is self.session:
            self.fail(f'no set-up "{name}" stands above or in setups.txt')
        if self.session.setup:
            self.fail("a second set-up: let one begin with the other")
        self.session.setup = setup

    def type(self, text):
        self.command = Command(len(self.found.lines), text)
        self.session.commands.append(self.command)
        self.typing = True

    def print(self, line):
        if self.command is None:
            self.fail('output stands directly below its command (write an empty line of it as "\\")')
        if self.session in self.found.setups.values():
            self.fail("a set-up prints nothing and succeeds")
        result = self.command.expected
        if result.exit:
            self.fail("the exit code ends what a command gave")
        if re.fullmatch(r"\[[0-9]+\]", line):
            result.exit = int(line[1:-1])
            if not 0 < result.exit < 256:
                self.fail("an exit code is 1 to 255; 0 is not written")
            return
        is_stderr = line.startswith(("! ", "!\\"))
        said = line[1:] if is_stderr else line
        if said == "\\" or said.startswith("\\ "):
            data = unescape(said[2:], self.place)
        elif said.startswith("\\") or line in ("!", "$", "=="):
            self.fail('a blank is missing after the mark (output that is this line stands behind "\\ ")')
        else:
            data = (said[1:] if is_stderr else said).encode() + b"\n"
        if result.stderr and not is_stderr:
            self.fail("stdout stands above stderr")
        before = result.stderr if is_stderr else result.stdout
        if before and not before.endswith(b"\n"):
            self.fail("a line follows the one that has no newline")
        if is_stderr:
            result.stderr += data
        else:
            result.stdout += data

    def close(self):
        if self.session and not self.session.commands:
            raise Malformed(f'{self.session.place}: "{self.session.title}" has no command')
        self.command = None


def read(path, known=None):
    """The transcript in `path`, which may begin with the set-ups `known`, too."""
    reader = Reader(path.name, known or {})
    try:
        text = path.read_bytes().decode()
    except UnicodeDecodeError as error:
        line = path.read_bytes().count(b"\n", 0, error.start) + 1
        raise Malformed(f"{path.name}:{line}: not UTF-8 (such output stands behind a backslash)") from error
    for line in text.removesuffix("\n").split("\n"):
        reader.take(line)
        if "\r" in line:
            reader.fail("a carriage return (in output, write it as \\x0d)")
    if not text.endswith("\n"):
        reader.fail("the last line has no newline")
    reader.close()
    return reader.found


def rewritten(transcript, results):
    """The text of `transcript` with `results`, by command line, below its commands."""
    lines = list(transcript.lines)
    commands = [command for case in transcript.cases.values() for command in case.commands]
    for command in sorted(commands, key=lambda c: c.line, reverse=True):
        if command.line in results:
            lines[command.below:command.end] = show(results[command.line])
    return "\n".join(lines) + "\n"

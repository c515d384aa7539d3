"""`python -m proofread` is the program."""

import subprocess
import sys

from ._program import ProofreadError, program


def main() -> int:
    """Runs the program with the arguments of this one, and ends as it ends."""
    try:
        command = [program(), *sys.argv[1:]]
    except ProofreadError as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    try:
        return subprocess.call(command)
    except KeyboardInterrupt:
        return 130


if __name__ == "__main__":
    sys.exit(main())

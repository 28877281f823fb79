from typing import Any

# The compiled part, which the other modules of the package wrap. Its functions are private, so they have no types.
def __getattr__(name: str) -> Any: ...

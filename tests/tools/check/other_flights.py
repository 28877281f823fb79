"""Records of other flights than those that a certificate is of."""

import copy
import random


def tampered_of_record(record):
    """Flights that the certificate is not of."""
    out = copy.deepcopy(record)
    if out["type"] == "trajectory":
        segment = random.choice(out["segments"])
        kind = random.randrange(3)
        if kind == 0:
            segment["z"] = [z + 30 for z in segment["z"]]
        elif kind == 1:
            segment["duration"] *= 1.5
        else:
            out["segments"].append(copy.deepcopy(segment))
    else:
        random.choice(out["points"])[2] += 30
    return out

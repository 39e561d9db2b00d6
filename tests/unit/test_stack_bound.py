"""The bound of the stack, from the call graph that the compiler writes."""

from __future__ import annotations

import pytest

from symscrew.verification.embedded.emulation import EmbeddedError, deepest_frames


def test_functions_that_call_themselves_have_no_bound() -> None:
    node = 'node: { title: "f" label: "f\\na.c:1:1\\n8 bytes (static)" }\n'
    assert deepest_frames(node) == {"f": 8}
    library = 'node: { title: "sinf" label: "sinf\\nmath.h:88:15" shape : ellipse }\n'
    inner = 'node: { title: "a.c:inner" label: "inner\\na.c:2:38\\n328 bytes (static)" }\n'
    calls = [("a.c:inner", "sinf"), ("f", "a.c:inner"), ("f", "sinf")]
    edges = "".join(f'edge: {{ sourcename: "{one}" targetname: "{other}" label: "" }}\n' for one, other in calls)
    assert deepest_frames(node + library + inner + edges) == {"f": 336, "inner": 328}
    with pytest.raises(EmbeddedError, match="functions call themselves: f"):
        deepest_frames(node + 'edge: { sourcename: "f" targetname: "f" }')
    with pytest.raises(EmbeddedError, match="bounded stack, the compiler says dynamic"):
        deepest_frames(node.replace("static", "dynamic"))

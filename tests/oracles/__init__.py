"""Independent oracles: another engine, hand-typed mechanisms, states that no core has computed."""

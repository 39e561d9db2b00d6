"""The demo: the whole job on the source paper's mechanism. `scene` moves, `study` computes, `report` shows."""

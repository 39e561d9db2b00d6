"""Blocks of a mechanism: parts whose loops share no joint, so that their motions are independent.

    Network --biconnected components--> blocks; configuration space = product of those of the blocks

The loops of a graph lie in its biconnected components. Two blocks have at most one body in common, so the
configuration space is the product of those of the blocks; a joint in no loop is a block of its own.
"""

from __future__ import annotations

from dataclasses import replace

from symscrew.mobility.joint_network import Edge, Network, spanning_tree


def blocks_of(network: Network) -> tuple[Network, ...]:
    """The mechanism's blocks, each a network with one of its bodies as ground; the whole where there are couplings."""
    if network.ties:
        return (network,)
    return tuple(_block(network, names) for names in _components(network))


def shifted(edge: Edge, start: int) -> Edge:
    """The same joint with its columns from `start`."""
    motions = tuple((motion, column - edge.start + start) for motion, column in edge.motions)
    return replace(edge, motions=motions, start=start)


def _block(network: Network, names: list[str]) -> Network:
    edges: dict[str, Edge] = {}
    start = 0
    for name in sorted(names, key=list(network.edges).index):
        edges[name] = shifted(network.edges[name], start)
        start += len(edges[name].screws)
    touched = {body for edge in edges.values() for body in (edge.parent, edge.child)}
    bodies = tuple(body for body in network.bodies if body in touched)
    tree = spanning_tree(bodies[0], edges)
    used = {name for name, _ in tree}
    chords = tuple(name for name in edges if name not in used)
    return replace(network, ground=bodies[0], bodies=bodies, edges=edges, tree=tree, chords=chords, driven=())


def _components(network: Network) -> list[list[str]]:
    """Joints of each biconnected component, by depth-first search (Hopcroft, Tarjan 1973), without recursion."""
    neighbours: dict[str, list[tuple[str, str]]] = {body: [] for body in network.bodies}
    for edge in network.edges.values():
        neighbours[edge.parent].append((edge.name, edge.child))
        neighbours[edge.child].append((edge.name, edge.parent))
    depth = {network.ground: 0}
    low = {network.ground: 0}
    passed: set[str] = set()
    stack: list[str] = []
    found: list[list[str]] = []
    path = [(network.ground, "", iter(neighbours[network.ground]))]
    while path:
        body, entered, following = path[-1]
        step = next(following, None)
        if step is None:
            path.pop()
            if path:
                above = path[-1][0]
                low[above] = min(low[above], low[body])
                if low[body] >= depth[above]:
                    cut = stack.index(entered)
                    found.append(stack[cut:])
                    del stack[cut:]
            continue
        name, other = step
        if name in passed:
            continue
        passed.add(name)
        stack.append(name)
        if other in depth:
            low[body] = min(low[body], depth[other])
        else:
            depth[other] = low[other] = depth[body] + 1
            path.append((other, name, iter(neighbours[other])))
    return found

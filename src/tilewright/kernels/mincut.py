"""Minimum cut of a 4-connected grid with two labels.

The augmenting-path algorithm of Boykov & Kolmogorov 2004 ("An experimental comparison of
min-cut/max-flow algorithms for energy minimization in vision"), on a grid stored as arrays: two search
trees grow from the source and the sink, and are mended rather than rebuilt after each augmentation.

Node ``p`` is a flat index into a grid of width ``stride`` whose outermost ring is never part of the
graph. Directions are 0 east, 1 south, 2 west, 3 north; the opposite of ``d`` is ``(d + 2) % 4``.
"""

import numpy as np

from tilewright.kernels.compiled import kernel

FREE, SOURCE, SINK = 0, 1, 2
NO_PARENT, TERMINAL, ORPHAN = -1, 4, 5


@kernel()
def cut_grid(capacity, terminal, stride, in_sink):
    """Fill ``in_sink`` with 1 where a node ends on the sink's side of a minimum cut.

    capacity : int32 (4, n), residual capacity from each node towards each direction; changed.
    terminal : int32 (n,), capacity from the source (positive) or to the sink (negative); changed.
    stride : width of the padded grid.
    in_sink : uint8 (n,), filled. Nodes no flow tells apart go to the source's side.
    """
    n = terminal.size
    step = np.array([1, stride, -1, -stride], np.int64)
    tree = np.zeros(n, np.uint8)
    parent = np.full(n, NO_PARENT, np.int8)
    stamp = np.zeros(n, np.int32)
    depth = np.zeros(n, np.int32)
    queue = np.empty(n + 1, np.int32)
    queued = np.zeros(n, np.uint8)
    orphans = np.empty(n + 1, np.int32)
    head = tail = 0
    for p in range(n):
        if terminal[p] != 0:
            tree[p] = SOURCE if terminal[p] > 0 else SINK
            parent[p] = TERMINAL
            depth[p] = 1
            queue[tail] = p
            queued[p] = 1
            tail += 1
    time = 0
    while head != tail:
        p = queue[head]
        if tree[p] == FREE:
            queued[p] = 0
            head = (head + 1) % (n + 1)
            continue
        # Growth: p takes free neighbors into its tree until it touches the other tree.
        meeting = -1
        for d in range(4):
            q = p + step[d]
            room = capacity[d, p] if tree[p] == SOURCE else capacity[(d + 2) % 4, q]
            if room <= 0:
                continue
            if tree[q] == FREE:
                tree[q] = tree[p]
                parent[q] = (d + 2) % 4
                stamp[q] = stamp[p]
                depth[q] = depth[p] + 1
                if not queued[q]:
                    queue[tail] = q
                    queued[q] = 1
                    tail = (tail + 1) % (n + 1)
            elif tree[q] != tree[p]:
                meeting = d
                break
            elif stamp[q] <= stamp[p] and depth[q] > depth[p] + 1 and parent[q] != TERMINAL:
                parent[q] = (d + 2) % 4
                stamp[q] = stamp[p]
                depth[q] = depth[p] + 1
        if meeting < 0:
            queued[p] = 0
            head = (head + 1) % (n + 1)
            continue
        time += 1
        if tree[p] == SOURCE:
            count = augment(p, meeting, capacity, terminal, step, parent, orphans)
        else:
            q = p + step[meeting]
            count = augment(q, (meeting + 2) % 4, capacity, terminal, step, parent, orphans)
        tail = adopt(count, time, capacity, step, tree, parent, stamp, depth, orphans, queue, queued, tail)
    for p in range(n):
        in_sink[p] = tree[p] == SINK


@kernel()
def augment(p, d, capacity, terminal, step, parent, orphans):
    """Push the bottleneck along source .. p -> p + step[d] .. sink; returns the number of orphans made."""
    q = p + step[d]
    push = capacity[d, p]
    at = p
    while parent[at] != TERMINAL:
        up = parent[at]
        push = min(push, capacity[(up + 2) % 4, at + step[up]])
        at += step[up]
    push = min(push, terminal[at])
    at = q
    while parent[at] != TERMINAL:
        up = parent[at]
        push = min(push, capacity[up, at])
        at += step[up]
    push = min(push, -terminal[at])

    count = 0
    capacity[d, p] -= push
    capacity[(d + 2) % 4, q] += push
    at = p
    while parent[at] != TERMINAL:
        up = parent[at]
        above = at + step[up]
        capacity[(up + 2) % 4, above] -= push
        capacity[up, at] += push
        if capacity[(up + 2) % 4, above] == 0:
            parent[at] = ORPHAN
            orphans[count] = at
            count += 1
        at = above
    terminal[at] -= push
    if terminal[at] == 0:
        parent[at] = ORPHAN
        orphans[count] = at
        count += 1
    at = q
    while parent[at] != TERMINAL:
        up = parent[at]
        above = at + step[up]
        capacity[up, at] -= push
        capacity[(up + 2) % 4, above] += push
        if capacity[up, at] == 0:
            parent[at] = ORPHAN
            orphans[count] = at
            count += 1
        at = above
    terminal[at] += push
    if terminal[at] == 0:
        parent[at] = ORPHAN
        orphans[count] = at
        count += 1
    return count


@kernel()
def depth_to_terminal(q, time, step, parent, stamp, depth):
    """Steps from ``q`` to its terminal, or a huge number when it hangs from an orphan."""
    steps = 0
    at = q
    while True:
        if stamp[at] == time:
            steps += depth[at]
            break
        up = parent[at]
        steps += 1
        if up == TERMINAL:
            stamp[at] = time
            depth[at] = 1
            break
        if up in (ORPHAN, NO_PARENT):
            return 1 << 30
        at += step[up]
    # Remember the answer along the way, so that later walks stop early.
    left = steps
    at = q
    while stamp[at] != time:
        stamp[at] = time
        depth[at] = left
        left -= 1
        at += step[parent[at]]
    return steps


@kernel()
def adopt(count, time, capacity, step, tree, parent, stamp, depth, orphans, queue, queued, tail):
    """Give each orphan a new parent in its tree or set it free; returns the queue's new tail."""
    n = tree.size
    first, last = 0, count
    while first != last:
        p = orphans[first]
        first = (first + 1) % (n + 1)
        best, best_depth = -1, 1 << 30
        for d in range(4):
            q = p + step[d]
            room = capacity[(d + 2) % 4, q] if tree[p] == SOURCE else capacity[d, p]
            if room > 0 and tree[q] == tree[p]:
                q_depth = depth_to_terminal(q, time, step, parent, stamp, depth)
                if q_depth < best_depth:
                    best, best_depth = d, q_depth
        if best >= 0:
            parent[p] = best
            stamp[p] = time
            depth[p] = best_depth + 1
            continue
        for d in range(4):
            q = p + step[d]
            if tree[q] != tree[p]:
                continue
            room = capacity[(d + 2) % 4, q] if tree[p] == SOURCE else capacity[d, p]
            if room > 0 and not queued[q]:
                queue[tail] = q
                queued[q] = 1
                tail = (tail + 1) % (n + 1)
            if parent[q] == (d + 2) % 4:
                parent[q] = ORPHAN
                orphans[last] = q
                last = (last + 1) % (n + 1)
        tree[p] = FREE
        parent[p] = NO_PARENT
        stamp[p] = 0
    return tail

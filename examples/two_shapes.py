# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Two shapes with poses, without any robot."""
import numpy as np

import collision_monitor_core as cm

box = cm.Solid.box([0.4, 0.4, 0.2])
roof = cm.Solid.mesh([[0, 0, 1], [1, 1, 0], [-1, 1, 0], [-1, -1, 0], [1, -1, 0]],
                     [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1], [1, 3, 2], [1, 4, 3]])

world_from_box = np.eye(4)
world_from_box[:3, 3] = [0.0, 0.0, 1.5]
found = cm.distance(box, world_from_box, roof, None)
print(found, "from", found.point_on_a, "to", found.point_on_b)
print("lowered by half a metre, they touch:", cm.collide(box, [0.0, 0.0, 1.0], roof, None))

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace bench {

class PeerReport;

/// refine.step.12k and refine.step.100k: a step of a surface of so many vertices, all of them
/// active, towards the boundary of a mask, against ITK's deformable simplex mesh from the same
/// surface; refine.fit.*: from a mask to its surface; refine.chunks and refine.chunks.click: 512
/// 000 voxels divided, and a click there; refine.upload: what a dab of the sphere sends to the GPU.
/// @return why the results are not right; empty: all is added
QString measureRefining(PeerReport& report);

} // namespace bench

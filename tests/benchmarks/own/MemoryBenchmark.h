// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace bench {

class PeerReport;

/// memory.segments: what a session on 512 cubed with 20 painted segments takes of the process's
/// memory, with all that the graphics driver takes of it (llvmpipe: all textures), against three
/// times the bytes of the voxels.
/// @return why the result is not right; empty: it is added
QString measureMemory(PeerReport& report);

} // namespace bench

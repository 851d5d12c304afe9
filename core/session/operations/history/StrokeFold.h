// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/questions/PastCoverage.h"

#include <map>

namespace core {

/// What a revision works out from voxels. What takes long is done on the side thread; until that is
/// through, nobody else uses the fold. Part of ReviseOperation.
struct StrokeFold {
    PastCoverage past;
    StrokeCut cutBefore; ///< of the stroke as it was
    StrokeCut cutAfter; ///< as it is now; nothing if it is removed
    std::map<BrickKey, BrickImage> bricks; ///< those that are computed again, as far as they are

    /// Combines a cut with what is in these bricks so far: carving takes the deeper cut, restoring
    /// what it leaves. Bricks of the cut that are not computed again are left out.
    void lay(const StrokeCut& cut, int layer, bool restoring);
};

} // namespace core

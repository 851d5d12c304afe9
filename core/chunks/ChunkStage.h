// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/ProgressStep.h"

namespace core {

/// The progress of computing chunks.
struct ChunkStage {
    ProgressStep step = ProgressStep::FetchingValues;
    int percent = 0; ///< of all steps, approximately
};

} // namespace core

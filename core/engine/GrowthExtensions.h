// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/GrowthProgress.h"

namespace core {

// The extensions that an open growth takes. GrowAdvance: core/growth/GrowthProgress.h.

/// Cancels growth steps that were requested but not carried out yet.
struct GrowPause { };

/// Begins the open growth again, as if it had been rolled back and opened with this burst. Steps
/// requested before are cancelled.
struct GrowAnew {
    GrowBurst burst;
};

} // namespace core

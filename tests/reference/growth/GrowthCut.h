// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/growth/GrowthCommands.h"
#include "core/growth/GrowthProgress.h"
#include "tests/reference/fields/DenseFields.h"

namespace reference {

struct CutDone {
    std::uint32_t generation = 0; ///< then
    core::BackwardProgress backwards{}; ///< without a bound before everything
};

/// Takes back what grew through some places, by the rules in core/growth/cut/GrowthCut.h, each
/// written down as it stands there.
core::Result<CutDone> cutGrowth(DenseFields& fields, const core::CutGrowth& command);

/// What it would take: the cut is made in a copy, and the two are compared.
core::Result<core::CutPreview> previewCut(
    const DenseFields& fields, const core::CutGrowth& command);

} // namespace reference

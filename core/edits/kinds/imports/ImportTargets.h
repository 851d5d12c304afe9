// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/document/Document.h"
#include "core/sculpt/labels/LayerWrites.h"

#include <bitset>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace core {

struct ImportMask;

/// The labels that receive the segments of a mask, in any volume.
struct ImportTargets {
    std::vector<LabelTarget> targets; ///< one per segment
    bool isNew = true; ///< they are new segments: one for each, or a single one with "as"
};
/// Determines them. Errors: InvalidField (no voxels read, no room for so many segments, a place
/// that is not in the list, not exactly one plane for each segment), UnknownSegment, SegmentLocked.
[[nodiscard]] Result<ImportTargets> importTargets(const ImportMask& edit, const Document& document);

/// The labels of a plane whose voxels an import may overwrite.
[[nodiscard]] std::bitset<256> overwrittenBy(
    const ImportMask& edit, int plane, const Document& document);

/// The segments of a mask, as indices from 0, in the order in which they get voxels that several of
/// them share: first those of ImportMask::ahead, then the others.
[[nodiscard]] std::vector<std::size_t> segmentsByPrecedence(
    const std::optional<std::vector<int>>& ahead, std::size_t count);

/// An import that was carried out.
struct DoneImport {
    std::shared_ptr<const ImportMask> edit;
    std::vector<int> labels; ///< labels that its segments received, one for each
};

} // namespace core

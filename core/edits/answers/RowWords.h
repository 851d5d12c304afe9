// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/titles/RowTitle.h"

#include <QString>

#include <cstdint>

namespace core {
struct RowFacts;
struct SegmentChoice;
} // namespace core

namespace core::rowWords {

// Parts of which titles of rows are composed (rowTitle() of an edit).

/// A count of what the code names: 2 and Voxels for "2 voxels".
[[nodiscard]] RowTitle figure(RowTitleCode code, std::int64_t count);
/// "+12 −3 voxels", or one of both; "−0 voxels" if there is neither.
[[nodiscard]] RowTitle flowTitle(std::int64_t gained, std::int64_t lost);
/// "Mirror 'Liver', +12 −3 voxels": what was done to a segment, and what it gained and lost.
[[nodiscard]] RowTitle segmentChanged(RowTitleCode code, int label, const RowFacts& row);
/// "+12 voxels", or "−12 voxels" for an edit that erases. If only seeds were removed, no label has
/// changed; then their number is stated.
[[nodiscard]] RowTitle voxelsOrSeedsLost(bool erases, const RowFacts& row);

// The name of a segment, layer or piece; its number if there is no such object.
[[nodiscard]] QString segmentName(int label, const Document& document);
[[nodiscard]] QString layerName(int id, const Document& document);
[[nodiscard]] QString pieceName(int id, const Document& document);
/// The name of a segment that receives voxels.
[[nodiscard]] QString targetName(const SegmentChoice& choice, const Document& document);

} // namespace core::rowWords

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

// What titles of rows are put together from (rowTitle() of an edit).

/// How many of what the code says: 2 and Voxels for "2 voxels".
[[nodiscard]] RowTitle figure(RowTitleCode code, std::int64_t count);
/// "+12 −3 voxels", or one of both; "−0 voxels" where there is none.
[[nodiscard]] RowTitle flowTitle(std::int64_t gained, std::int64_t lost);
/// "Mirror 'Liver', +12 −3 voxels": what was done to a segment, and what it gained and lost.
[[nodiscard]] RowTitle segmentChanged(RowTitleCode code, int label, const RowFacts& row);
/// "+12 voxels", or "−12 voxels" for an edit that erases. If only seeds were removed, no label has
/// changed; then their number is stated.
[[nodiscard]] RowTitle voxelsOrSeedsLost(bool erases, const RowFacts& row);

// Names; the number where there is none.
[[nodiscard]] QString segmentName(int label, const Document& document);
[[nodiscard]] QString layerName(int id, const Document& document);
[[nodiscard]] QString pieceName(int id, const Document& document);
/// Of a segment that receives voxels.
[[nodiscard]] QString targetName(const SegmentChoice& choice, const Document& document);

} // namespace core::rowWords

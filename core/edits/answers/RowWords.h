// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"

#include <QString>

#include <cstdint>

namespace core {
struct SegmentChoice;
}

namespace core::rowWords {

// What names of rows are put together from (rowName() of an edit).

[[nodiscard]] QString grouped(std::int64_t count); ///< 18204 → "18 204"
[[nodiscard]] QString counted(std::int64_t count, const char* noun); ///< "1 voxel", "2 voxels"
[[nodiscard]] QString quoted(const QString& name);
[[nodiscard]] QString millimetres(double mm); ///< "42.0 mm"
/// Bare; the number where there is no such segment.
[[nodiscard]] QString segmentName(int label, const Document& document);
/// In quotes, likewise.
[[nodiscard]] QString layerName(int id, const Document& document);
[[nodiscard]] QString pieceName(int id, const Document& document);
/// Of a segment that receives voxels, in quotes.
[[nodiscard]] QString targetName(const SegmentChoice& choice, const Document& document);

} // namespace core::rowWords

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"

#include <bitset>
#include <cstdint>
#include <vector>

namespace core {

/// What to know of a segment before it is exported; ui::exportRemarkText() words it.
enum class ExportRemark : std::uint8_t {
    Empty,
    Hidden,
    GrowthNotFinished,
    SurfaceNotWrittenBack,
    NotCoded,
};

/// One row of the export dialog.
struct ExportChoice {
    Segment segment;
    double millilitres = 0.0;
    bool chosen = false; ///< preselected: visible and not empty
    std::vector<ExportRemark> remarks{};
};

/// All segments of the document, in its order, with the remarks of the dialog.
/// @param growing labels of segments whose growth is not at closure; export commits the burst, so
/// what has grown so far is written
[[nodiscard]] std::vector<ExportChoice> exportChoices(
    const Document& document, const std::bitset<256>& growing);

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"

#include <vector>

namespace ui {

/// The concepts the code chooser offers, from resources/segmentCodes.json, grouped as there.
struct SegmentCode {
    QString group; ///< "Head", "Abdomen" …
    core::CodedConcept code;
};
[[nodiscard]] const std::vector<SegmentCode>& segmentCodes();

} // namespace ui

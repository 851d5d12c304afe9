// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"

#include <vector>

namespace ui {

/// A coded concept that the code chooser offers, from resources/segmentCodes.json, with its group
/// there.
struct SegmentCode {
    QString group; ///< "Head", "Abdomen" …
    core::CodedConcept code;
};
[[nodiscard]] const std::vector<SegmentCode>& segmentCodes();

} // namespace ui

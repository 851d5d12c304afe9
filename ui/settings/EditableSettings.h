// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/edits/kinds/parts/EditableRange.h"

#include <QString>

#include <optional>

namespace ui {

/// Which voxels tools that write labels may change at all, one choice for all of them. Off until
/// somebody switches it on, and with every new study.
struct EditableSettings {
    enum class Where { Anywhere, Inside, Outside, InsideVisible, OutsideVisible };
    bool on = false;
    bool byValue = false;
    double lower = 0.0; ///< modality units, in any order
    double upper = 0.0;
    Where where = Where::Anywhere;
    int segment = 0; ///< label, of Inside and Outside
    bool boxed = false; ///< only in the box that there is, if there is one
    bool operator==(const EditableSettings&) const = default;
};

/// A box to which editing may be limited, and whose it is.
struct EditableBox {
    core::GrowBox box{};
    bool isClip = true; ///< the clip box; else that of growth
};

/// What an edit that is made now has to keep to, the segments by name; none while it is off. Inside
/// a segment that is gone there is nothing.
[[nodiscard]] std::optional<core::EditableRange> editableRange(const EditableSettings& settings,
    const core::Document& document, const std::optional<EditableBox>& box);

/// "editable: only 20 … 80 HU, inside Liver"; empty while it is off.
[[nodiscard]] QString editableText(const EditableSettings& settings, const core::Document& document,
    const std::optional<EditableBox>& box);

} // namespace ui

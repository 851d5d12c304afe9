// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/edits/kinds/parts/EditableRange.h"

#include <QString>

#include <optional>

namespace ui {

/// The user's choice of the editable range: which voxels tools that write labels may change. One
/// choice for all tools. It is off at first and after opening a study.
struct EditableSettings {
    enum class Where { Anywhere, Inside, Outside, InsideVisible, OutsideVisible };
    bool on = false;
    bool byValue = false;
    double lower = 0.0; ///< modality units; may be greater than upper
    double upper = 0.0;
    Where where = Where::Anywhere;
    int segment = 0; ///< label, for Inside and Outside
    bool boxed = false; ///< only within the present box, if there is one
    bool operator==(const EditableSettings&) const = default;
};

/// A box that may limit editing.
struct EditableBox {
    core::GrowBox box{};
    bool isClip = true; ///< true: the clip box; false: the box of growth
};

/// Returns the limits of an edit that is made now, with visible segments listed by their labels;
/// none while the range is off. If the chosen segment has been removed, nothing is inside it.
[[nodiscard]] std::optional<core::EditableRange> editableRange(const EditableSettings& settings,
    const core::Document& document, const std::optional<EditableBox>& box);

/// Returns the choice as a text: "editable: only 20 … 80 HU, inside Liver". Empty while it is off.
[[nodiscard]] QString editableText(const EditableSettings& settings, const core::Document& document,
    const std::optional<EditableBox>& box);

} // namespace ui

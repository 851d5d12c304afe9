// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/masks/MaskNote.h"

#include <QString>

namespace ui {

/// Returns a sentence on what was resampled, left out or assumed when a mask was read.
[[nodiscard]] QString maskNoteText(const core::MaskNote& note);

} // namespace ui

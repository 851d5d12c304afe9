// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/titles/RowTitleCode.h"

namespace ui {

/// What the window says for one title. For translators: %1 and what follows are what the English
/// shows there; of two texts for one and for many the second is told how many there are.
struct TitleWords {
    core::RowTitleCode code = core::RowTitleCode::Nothing;
    const char* text = nullptr; ///< UTF-8; empty or "%1": nothing to translate
    const char* one = nullptr; ///< in place of it where the first argument is 1; null: likewise
    bool isCounted = one != nullptr; ///< the translator of the text is told the first argument
};

} // namespace ui

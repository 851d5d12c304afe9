// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/titles/RowTitleCode.h"

namespace ui {

/// What the window says for one title. For translators: %1, %2 … stand for the same things as in
/// the English text. Where there are two texts, one for a single thing and one for several, the
/// second is translated with the number of things, so that a language can have more than one
/// plural.
struct TitleWords {
    core::RowTitleCode code = core::RowTitleCode::Nothing;
    const char* text = nullptr; ///< UTF-8; empty or "%1": nothing to translate
    const char* one =
        nullptr; ///< in place of the text if the first argument is 1; null: the text is used
    bool isCounted = one != nullptr; ///< the first argument is the number for plurals
};

} // namespace ui

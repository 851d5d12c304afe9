// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/titles/RowTitleCode.h"

#include <QStringView>

#include <optional>

namespace core {

/// How a title is written: in files by its name, in the stored names of rows in English. None of it
/// may change once a session was written with it.
struct TitleForm {
    const char* id = nullptr; ///< null: there is no such code
    const char* text = nullptr; ///< UTF-8, with %1 … for the arguments
    const char* one = nullptr; ///< in place of it where the first argument is 1; null: likewise
};
[[nodiscard]] TitleForm formOf(RowTitleCode code);

/// Between titles that are one argument of this one.
[[nodiscard]] const char* joinerOf(RowTitleCode code);

/// None: of a newer Burin, or nobody's.
[[nodiscard]] std::optional<RowTitleCode> titleCodeFrom(QStringView id);

} // namespace core

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
    /// used instead if the first argument is 1; null: `text` is used then, too
    const char* one = nullptr;
};
[[nodiscard]] TitleForm formOf(RowTitleCode code);

/// The text between titles that are one argument of a title of this code.
[[nodiscard]] const char* joinerOf(RowTitleCode code);

/// The code of this name; none if it is unknown, for example because a newer Burin wrote it.
[[nodiscard]] std::optional<RowTitleCode> titleCodeFrom(QStringView id);

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/titles/RowTitle.h"

#include <QJsonObject>
#include <QString>

#include <optional>

namespace core {

// Titles in session files, which may be a stranger's (core/session/README.md has the form).

/// No title that is read or written has more of it.
struct TitleLimits {
    static constexpr int depth = 8; ///< depthOf()
    static constexpr int arguments = 8; ///< of one title
    static constexpr int titles = 1024; ///< in one argument, or said behind one title
    static constexpr qsizetype letters = 65536; ///< of the whole as text
};

[[nodiscard]] QJsonObject titleToJson(const RowTitle& title);
/// None: it is no title, one that is not known here, or beyond the limits.
[[nodiscard]] std::optional<RowTitle> titleFromJson(const QJsonObject& json);

/// As a file keeps it, compact; empty: it is beyond the limits, and no title is kept.
[[nodiscard]] QString titleText(const RowTitle& title);
/// As of titleFromJson(). What it says is the row's name, or it is not that row's title.
/// @param name that is stored of the row
[[nodiscard]] std::optional<RowTitle> titleFromText(const QString& text, const QString& name);

} // namespace core

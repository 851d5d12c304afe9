// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/titles/RowTitle.h"

#include <QJsonObject>
#include <QString>

#include <optional>

namespace core {

// Titles in session files, which may be a stranger's (core/session/README.md has the form).

/// Limits of the titles that are read and written.
struct TitleLimits {
    static constexpr int depth = 8; ///< depthOf()
    static constexpr int arguments = 8; ///< of one title
    static constexpr int titles = 1024; ///< in one argument, or following one title
    static constexpr qsizetype letters = 65536; ///< of the whole as text
};

[[nodiscard]] QJsonObject titleToJson(const RowTitle& title);
/// None: it is not a title, has an unknown code, or exceeds the limits.
[[nodiscard]] std::optional<RowTitle> titleFromJson(const QJsonObject& json);

/// The title as compact JSON for a file; empty if it exceeds the limits, in which case no title is
/// stored.
[[nodiscard]] QString titleText(const RowTitle& title);
/// Parses a stored title, as titleFromJson(). None also if its canonicalName() differs from the
/// stored name, since it then belongs to another row.
/// @param name the stored name of the row
[[nodiscard]] std::optional<RowTitle> titleFromText(const QString& text, const QString& name);

} // namespace core

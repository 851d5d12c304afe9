// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Said.h"
#include "core/titles/RowTitle.h"

#include <QString>
#include <QStringList>

#include <cstdint>

namespace core {

/// A language in which titles are worded: English for stored names here, the window's language in
/// ui.
class TitleLanguage {
public:
    virtual ~TitleLanguage() = default;

    /// The text of one title without its further parts.
    /// @param arguments its arguments as text
    [[nodiscard]] virtual QString text(
        const RowTitle& title, const QStringList& arguments) const = 0;
    /// The text between titles that are one argument of @p code.
    [[nodiscard]] virtual QString joiner(RowTitleCode code) const = 0;
    /// The text before a further part.
    [[nodiscard]] virtual QString comma() const = 0;
};

[[nodiscard]] QString worded(const RowTitle& title, const TitleLanguage& language);

/// 18204 → "18 204"
[[nodiscard]] QString grouped(std::int64_t count);
/// Whether the first argument is a count of exactly one.
[[nodiscard]] bool isOfOne(const RowTitle& title);
} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Said.h"
#include "core/titles/RowTitle.h"

#include <QString>
#include <QStringList>

#include <cstdint>

namespace core {

/// A language that titles are worded in: the English of stored names here, that of the window in
/// ui.
class TitleLanguage {
public:
    virtual ~TitleLanguage() = default;

    /// What one title says, without what is said behind it.
    /// @param arguments of it, worded
    [[nodiscard]] virtual QString text(
        const RowTitle& title, const QStringList& arguments) const = 0;
    /// Between titles that are one argument of @p code.
    [[nodiscard]] virtual QString joiner(RowTitleCode code) const = 0;
    /// Before what is said behind a title.
    [[nodiscard]] virtual QString comma() const = 0;
};

[[nodiscard]] QString worded(const RowTitle& title, const TitleLanguage& language);

/// 18204 → "18 204"
[[nodiscard]] QString grouped(std::int64_t count);
/// Whether the first argument is exactly one of something.
[[nodiscard]] bool isOfOne(const RowTitle& title);
} // namespace core

// SPDX-License-Identifier: Apache-2.0
#include "core/titles/TitleForms.h"

#include <QHash>
#include <QString>

#include <iterator>

namespace core {

TitleForm formOf(RowTitleCode code)
{
    static constexpr TitleForm forms[] = {
#define ROW_TITLE(code, ...) {__VA_ARGS__},
#include "core/titles/RowTitles.def"
#undef ROW_TITLE
    };
    return std::size_t(code) < std::size(forms) ? forms[std::size_t(code)] : TitleForm{};
}

const char* joinerOf(RowTitleCode code)
{
    // No comma: behind the last one stands what a row changed.
    return code == RowTitleCode::Changes ? " and " : "; ";
}

std::optional<RowTitleCode> titleCodeFrom(QStringView id)
{
    static const QHash<QString, RowTitleCode> codes = [] {
        QHash<QString, RowTitleCode> all;
        for (std::uint16_t number = 0; formOf(RowTitleCode(number)).id; ++number)
            all.insert(QLatin1String(formOf(RowTitleCode(number)).id), RowTitleCode(number));
        return all;
    }();
    const auto known = codes.constFind(id.toString());
    return known == codes.cend() ? std::nullopt : std::optional(*known);
}

} // namespace core

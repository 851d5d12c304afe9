// SPDX-License-Identifier: Apache-2.0
#include "ui/texts/ClauseText.h"

#include "core/base/words/Said.h"

#include <QCoreApplication>
#include <QStringList>

namespace ui {

QString clauseText(const core::Clause& clause)
{
    if (clause.form() == nullptr)
        return clause;
    QStringList arguments;
    for (const core::Clause& argument : clause.arguments())
        arguments += clauseText(argument);
    return core::filledIn(QCoreApplication::translate("core::Clause", clause.form()), arguments);
}

} // namespace ui

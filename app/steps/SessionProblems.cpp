// SPDX-License-Identifier: Apache-2.0
#include "app/steps/SessionProblems.h"

#include "app/steps/Arguments.h"
#include "core/sessionfile/records/SessionContents.h"
#include "ui/texts/SessionTexts.h"

#include <QStringList>

namespace app {

void reportProblems(const QString& file, const core::SessionContents& contents)
{
    const QStringList problems = ui::problemTexts(contents);
    if (!problems.isEmpty())
        reportFailure(
            {core::ErrorCode::SessionDamaged, {file, problems.join(QStringLiteral("; "))}});
}

} // namespace app

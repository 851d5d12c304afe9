// SPDX-License-Identifier: Apache-2.0
#include "app/steps/SessionProblems.h"

#include "app/steps/Arguments.h"
#include "core/sessionfile/records/SessionContents.h"

#include <QStringList>

namespace app {

void reportProblems(const QString& file, const core::SessionContents& contents)
{
    const std::vector<QString> problems = contents.problems();
    if (!problems.empty())
        reportFailure({core::ErrorCode::SessionDamaged,
            {file, QStringList(problems.begin(), problems.end()).join(QStringLiteral("; "))}});
}

} // namespace app

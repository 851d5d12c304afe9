// SPDX-License-Identifier: Apache-2.0
#include "app/steps/SessionProblems.h"

#include "app/steps/Arguments.h"
#include "core/sessionfile/database/SessionUse.h"
#include "core/sessionfile/records/SessionContents.h"
#include "ui/texts/ClauseText.h"
#include "ui/texts/SessionTexts.h"

#include <QStringList>

#include <cstdio>

namespace app {

namespace {

void reportLeftBeside(const QString& file, const core::Clause& left)
{
    if (!left.isEmpty())
        std::fprintf(
            stderr, "%s: %s\n", qUtf8Printable(file), qUtf8Printable(ui::clauseText(left)));
}

} // namespace

void reportProblems(const QString& file, const core::SessionContents& contents)
{
    const QStringList problems = ui::problemTexts(contents);
    if (!problems.isEmpty())
        reportFailure(
            {core::ErrorCode::SessionDamaged, {file, problems.join(QStringLiteral("; "))}});
    reportLeftBeside(file, contents.leftBeside);
}

void reportLeft(const QString& file, const core::SessionContents& contents)
{
    if (!contents.leftOpen.isEmpty())
        reportFailure({core::ErrorCode::SessionDamaged, {file, contents.leftOpen}});
    reportLeftBeside(file, contents.leftBeside);
}

int reportUnfollowed(const core::Error& why, const QString& file)
{
    const int status = reportFailure(why);
    // If the file that has its name lacks something itself, what lies beside is told with that.
    const core::SessionLoss loss = core::sessionLoss(file);
    reportLeftBeside(file, loss.leftBeside.isEmpty() ? loss.leftOpen : loss.leftBeside);
    return status;
}

} // namespace app

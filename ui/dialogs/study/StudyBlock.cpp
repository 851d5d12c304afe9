// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/study/StudyBlock.h"

#include "ui/base/StudyTexts.h"
#include "ui/base/Theme.h"
#include "ui/base/TimeText.h"
#include "ui/texts/ProblemTexts.h"

#include <QLabel>
#include <QVBoxLayout>

namespace ui {

StudyBlock::StudyBlock(const core::Volume& volume, QWidget* parent)
    : QFrame(parent)
{
    setProperty("role", QStringLiteral("bar"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(
        theme::padding, theme::smallPadding, theme::padding, theme::smallPadding);
    column->setSpacing(4);
    addLine(patientText(volume.identity), "heading", "exportPatient");
    QStringList study{studyText(volume.identity), seriesText(volume.identity), timeText(volume)};
    study.removeAll(QString());
    addLine(study.join(QStringLiteral(" · ")), "secondary");
    QStringList cautions;
    for (const core::VolumeProblem& problem : volume.problems) {
        if (problem.caution)
            cautions += problemText(problem.said);
    }
    // One for each damaged slice may be more than a screen has lines.
    constexpr qsizetype mostLines = 3;
    const qsizetype shown = cautions.size() > mostLines ? mostLines - 1 : cautions.size();
    for (const QString& caution : cautions.mid(0, shown))
        addLine(tr("Caution: %1").arg(caution), "caution");
    if (shown < cautions.size())
        addLine(tr("Caution: %1 more, which the series doctor lists.").arg(cautions.size() - shown),
            "caution");
}

void StudyBlock::addLine(const QString& text, const char* role, const char* name)
{
    if (text.isEmpty())
        return;
    auto* label = new QLabel(text, this);
    label->setObjectName(QLatin1String(name));
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    label->setProperty("role", QLatin1String(role));
    layout()->addWidget(label);
}

} // namespace ui

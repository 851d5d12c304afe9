// SPDX-License-Identifier: Apache-2.0
#include "ui/frame/MendingStrip.h"

#include "ui/base/Icons.h"
#include "ui/base/SmallLabel.h"
#include "ui/base/Theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace ui {

namespace {

struct StepTexts {
    const char* name; ///< of the button, for tests and style sheets
    QString text;
    QString tip;
};

std::array<StepTexts, MendingStrip::steps> stepTexts()
{
    return {StepTexts{"mendingLook", MendingStrip::tr("1 Look"),
                MendingStrip::tr("Lists places of the active segment that may be wrong")},
        StepTexts{"mendingMend", MendingStrip::tr("2 Mend"),
            MendingStrip::tr("Divides the active segment into chunks, of which a click adds what "
                             "is missing and takes what is too much")},
        StepTexts{"mendingCompare", MendingStrip::tr("3 Compare"),
            MendingStrip::tr("What you have added and taken since the mask was imported")},
        StepTexts{"mendingExport", MendingStrip::tr("4 Export"),
            MendingStrip::tr("Writes the segments into a file, and checks it")}};
}

QString styleOf(bool isNext, bool isDone)
{
    const QColor& colour = isNext ? theme::text : isDone ? theme::good : theme::secondary;
    const QString back = isNext ? theme::selected.name() : QStringLiteral("transparent");
    const QString rim = isNext ? theme::accent.name() : theme::line.name();
    // Each has a rim: else the dots would be near to that of the next step, and far from words.
    return QStringLiteral("QToolButton { color: %1; background: %2; border: 1px solid %3; "
                          "border-radius: %4px; padding: 1px 10px; }")
        .arg(colour.name(), back, rim)
        .arg(theme::cornerRadius);
}

} // namespace

MendingStrip::MendingStrip(QWidget* parent)
    : QFrame(parent)
{
    setObjectName(QStringLiteral("mendingStrip"));
    setProperty("role", QStringLiteral("panel"));
    setFixedHeight(theme::rowHeight);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(theme::padding, 0, 6, 0);
    row->setSpacing(4);
    row->addWidget(smallNote(tr("Mending a mask"), this));
    row->addSpacing(theme::smallPadding);
    const auto texts = stepTexts();
    for (std::size_t i = 0; i < steps; ++i) {
        if (i > 0)
            row->addWidget(smallNote(QStringLiteral("·"), this));
        auto* button = new QToolButton(this);
        button->setObjectName(QLatin1String(texts[i].name));
        button->setText(texts[i].text);
        button->setToolTip(texts[i].tip);
        row->addWidget(button);
        connect(button, &QToolButton::clicked, this,
            [this, step = Step(i)] { Q_EMIT stepRequested(step); });
        m_buttons[i] = button;
    }
    row->addStretch(1);
    auto* close = new QToolButton(this);
    close->setObjectName(QStringLiteral("mendingClose"));
    close->setIcon(stateIcon(QStringLiteral("close")));
    close->setIconSize(QSize(16, 16));
    close->setToolTip(tr("Close; it comes back by the menu Segments"));
    close->setAccessibleName(tr("Close"));
    row->addWidget(close);
    connect(close, &QToolButton::clicked, this, &MendingStrip::closeRequested);
    showSteps({}, Step::Look);
}

void MendingStrip::showSteps(const std::array<bool, steps>& done, std::optional<Step> next)
{
    if (m_done == done && m_next == next)
        return;
    m_done = done;
    m_next = next;
    for (std::size_t i = 0; i < steps; ++i) {
        const bool isNext = next && std::size_t(*next) == i;
        m_buttons[i]->setStyleSheet(styleOf(isNext, done[i]));
    }
}

} // namespace ui

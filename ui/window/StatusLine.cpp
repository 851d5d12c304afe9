// SPDX-License-Identifier: Apache-2.0
#include "ui/window/StatusLine.h"

#include "ui/base/Theme.h"
#include "ui/input/Tool.h"
#include "ui/widgets/FittingLabel.h"

#include <QHBoxLayout>
#include <QLabel>

namespace ui {

namespace {

constexpr int saidMilliseconds = 8000;

QLabel* label(QWidget* parent, Qt::Alignment alignment)
{
    auto* result = new FittingLabel(alignment, parent);
    result->setFont(theme::smallFont());
    return result;
}

} // namespace

StatusLine::StatusLine(Workspace& workspace, QWidget* parent)
    : QFrame(parent)
    , m_workspace(workspace)
    , m_readout(workspace)
    , m_where(label(this, Qt::AlignLeft))
    , m_hint(label(this, Qt::AlignHCenter))
    , m_machine(label(this, Qt::AlignRight))
{
    setProperty("role", QStringLiteral("bar"));
    setFixedHeight(26);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(theme::padding, 0, theme::padding, 0);
    layout->setSpacing(theme::padding);
    layout->addWidget(m_where, 4);
    layout->addWidget(m_hint, 5);
    layout->addWidget(m_machine, 2);
    m_hint->setProperty("role", QStringLiteral("secondary"));
    m_machine->setProperty("role", QStringLiteral("secondary"));

    m_saidTimer.setSingleShot(true);
    m_saidTimer.setInterval(saidMilliseconds);
    connect(&m_saidTimer, &QTimer::timeout, this, &StatusLine::showHint);
    connect(
        &m_readout, &Readout::textChanged, this, [this] { m_where->setText(m_readout.text()); });
    connect(&workspace, &Workspace::activeToolChanged, this, [this] {
        m_saidTimer.stop();
        if (const Tool* tool = m_workspace.activeTool())
            connect(tool, &Tool::nameChanged, this, &StatusLine::showHint, Qt::UniqueConnection);
        showHint();
    });
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        m_frameMilliseconds = 0.0;
        m_pressure = -1.0;
        showHint();
        showMachine();
    });
    connect(&workspace, &Workspace::documentChanged, this, [this] {
        if (!m_saidTimer.isActive())
            showHint();
    });
    connect(&workspace, &Workspace::said, this, [this](const QString& sentence) {
        m_hint->setText(sentence);
        m_saidTimer.start();
    });
    connect(&workspace, &Workspace::pressureChanged, this, [this](double pressure) {
        m_pressure = pressure;
        showMachine();
    });
}

QString StatusLine::readout() const
{
    return m_where->text();
}

void StatusLine::showHint()
{
    const Tool* tool = m_workspace.activeTool();
    m_hint->setText(tool && m_workspace.volume() ? tool->hint() : QString());
}

void StatusLine::showFrameTime(double milliseconds)
{
    m_frameMilliseconds = milliseconds;
    showMachine();
}

void StatusLine::showMachine()
{
    QString text;
    if (m_pressure >= 0.0)
        text = tr("pen %1 · ").arg(m_pressure, 0, 'f', 2);
    if (m_frameMilliseconds > 0.0)
        text += tr("picture %1 ms")
                    .arg(m_frameMilliseconds, 0, 'f', m_frameMilliseconds < 10.0 ? 1 : 0);
    m_machine->setText(text);
}

} // namespace ui

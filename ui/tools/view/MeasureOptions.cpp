// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/view/MeasureOptions.h"

#include "core/edits/kinds/views/Measurements.h"
#include "ui/base/Theme.h"
#include "ui/measure/MeasureTexts.h"
#include "ui/overlays/MeasurementLines.h"
#include "ui/tools/view/MeasureTool.h"
#include "ui/workspace/Workspace.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolButton>

namespace ui {

namespace {

constexpr int axesItem = -1; ///< behind the kinds

} // namespace

MeasureOptions::MeasureOptions(Workspace& workspace, MeasureTool& tool, QWidget* parent)
    : QWidget(parent)
    , m_workspace(workspace)
    , m_tool(tool)
    , m_kinds(new QComboBox(this))
    , m_text(new QLineEdit(this))
    , m_list(new QToolButton(this))
{
    using Kind = MeasureTool::Kind;
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(theme::smallPadding);
    m_kinds->setObjectName(QStringLiteral("measureShape"));
    m_kinds->setFixedHeight(theme::controlHeight);
    for (const Kind kind : {Kind::Distance, Kind::Angle, Kind::Ellipse, Kind::Rectangle,
             Kind::Outline, Kind::Ball, Kind::Probe, Kind::Arrow, Kind::Text})
        m_kinds->addItem(kindText(kind), int(kind));
    m_kinds->addItem(tr("axes of a segment"), axesItem);
    m_kinds->setToolTip(tr("What is measured or noted; regions show how large they are, and mean, "
                           "deviation and range of the values in them"));
    m_text->setObjectName(QStringLiteral("measureText"));
    m_text->setFixedHeight(theme::controlHeight);
    m_text->setMaxLength(256); // as a name may have
    m_text->setPlaceholderText(tr("what it says"));
    m_text->setAccessibleName(tr("What an arrow or a text says"));
    m_list->setObjectName(QStringLiteral("measurements"));
    m_list->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(m_list);
    m_list->setMenu(menu);
    layout->addWidget(m_kinds);
    layout->addWidget(m_text);
    layout->addWidget(m_list);
    connect(m_kinds, &QComboBox::activated, this, [this] {
        const int item = m_kinds->currentData().toInt();
        if (item == axesItem)
            m_tool.suggestAxes();
        else
            m_tool.setKind(MeasureTool::Kind(item));
    });
    connect(m_text, &QLineEdit::textChanged, &tool, &MeasureTool::setText);
    connect(&tool, &MeasureTool::kindChanged, this, &MeasureOptions::showTool);
    connect(&tool, &MeasureTool::textChanged, this, &MeasureOptions::showTool);
    connect(menu, &QMenu::aboutToShow, this, &MeasureOptions::fillMenu);
    connect(
        &workspace, &Workspace::documentChanged, this, [this](const core::DocumentChange& change) {
            if (change.what == core::DocumentChange::What::Measurements)
                showCount();
        });
    connect(&workspace, &Workspace::sessionChanged, this, &MeasureOptions::showCount);
    showTool();
    showCount();
}

void MeasureOptions::showTool()
{
    const QSignalBlocker kinds(m_kinds);
    m_kinds->setCurrentIndex(
        m_kinds->findData(m_tool.suggestsAxes() ? axesItem : int(m_tool.kind())));
    m_text->setVisible(
        m_tool.kind() == MeasureTool::Kind::Arrow || m_tool.kind() == MeasureTool::Kind::Text);
    if (m_text->text() != m_tool.text()) {
        const QSignalBlocker text(m_text);
        m_text->setText(m_tool.text());
    }
}

void MeasureOptions::showCount()
{
    const core::EditSession* session = m_workspace.session();
    const qsizetype count = session ? std::ssize(session->document().measurements) : 0;
    m_list->setText(count == 1 ? tr("1 measurement") : tr("%1 measurements").arg(count));
    m_list->setEnabled(count > 0);
}

void MeasureOptions::fillMenu()
{
    QMenu* menu = m_list->menu();
    menu->clear();
    const core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    for (const core::Measurement& each : session->document().measurements) {
        const QStringList lines = measurementLines(each, m_workspace);
        menu->addAction(tr("Remove %1: %2")
                            .arg(each.id)
                            .arg(lines.isEmpty() ? kindText(each.kind) : lines.front()),
            this, [this, id = each.id] { removeMeasurement(m_workspace, id); });
    }
}

void removeMeasurement(Workspace& workspace, int measurement)
{
    core::EditSession* session = workspace.session();
    if (!session)
        return;
    const core::RemoveMeasurement edit{.measurement = measurement};
    if (const auto removed = session->apply(edit); !removed)
        workspace.fail(removed.error());
}

} // namespace ui

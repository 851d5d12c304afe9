// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/common/PenMenu.h"

#include "ui/base/Theme.h"
#include "ui/widgets/PressureCurve.h"
#include "ui/widgets/fields/FieldMenu.h"
#include "ui/workspace/Workspace.h"

#include <QCheckBox>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <cmath>

namespace ui {

PenMenu::PenMenu(Workspace& workspace, QWidget* parent)
    : QToolButton(parent)
    , m_workspace(workspace)
{
    setObjectName(QStringLiteral("drillPen"));
    setPopupMode(QToolButton::InstantPopup);
    setToolButtonStyle(Qt::ToolButtonTextOnly);
    setFixedHeight(theme::controlHeight);
    auto* content = new QWidget;
    m_curve = new PressureCurve(content);
    m_turns = new QCheckBox(tr("Mask turns with the pen"), content);
    m_turns->setObjectName(QStringLiteral("drillTurnsWithPen"));
    m_turns->setToolTip(tr("With the pen's rotation; where it does not tell that, with the way "
                           "it leans"));
    m_foreshortened = new QCheckBox(tr("Tilt foreshortens the mask"), content);
    m_foreshortened->setObjectName(QStringLiteral("drillForeshortened"));
    m_foreshortened->setToolTip(tr("A pen that leans makes the mask narrower that way"));
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(
        theme::smallPadding, theme::smallPadding, theme::smallPadding, theme::smallPadding);
    layout->setSpacing(theme::smallPadding);
    layout->addWidget(m_curve);
    layout->addWidget(m_turns);
    layout->addWidget(m_foreshortened);
    setMenu(new FieldMenu(content, this));
    showSettings();
    connect(&m_workspace, &Workspace::drillSettingsChanged, this, &PenMenu::showSettings);
    connect(m_curve, &PressureCurve::exponentChosen, this, [this](int exponent) {
        Workspace::DrillSettings settings = m_workspace.drillSettings();
        settings.pressureExponent = exponent;
        m_workspace.setDrillSettings(settings);
    });
    const auto take = [this] {
        Workspace::DrillSettings settings = m_workspace.drillSettings();
        settings.turnsWithPen = m_turns->isChecked();
        settings.foreshortened = m_foreshortened->isChecked();
        m_workspace.setDrillSettings(settings);
    };
    connect(m_turns, &QCheckBox::toggled, this, take);
    connect(m_foreshortened, &QCheckBox::toggled, this, take);
}

void PenMenu::showSettings()
{
    const QSignalBlocker turns(m_turns);
    const QSignalBlocker foreshortened(m_foreshortened);
    const Workspace::DrillSettings& settings = m_workspace.drillSettings();
    m_turns->setChecked(settings.turnsWithPen);
    m_foreshortened->setChecked(settings.foreshortened);
    const int exponent = settings.pressureExponent;
    m_curve->setExponent(exponent);
    static const QString powers[]{QString(), QStringLiteral("²"), QStringLiteral("³")};
    setText(tr("p") + powers[exponent - 1]);
    setToolTip(tr("Pen: half the pressure cuts %1 % of the depth; how the mask follows it")
                   .arg(std::lround(100.0 * std::pow(0.5, exponent))));
}

} // namespace ui

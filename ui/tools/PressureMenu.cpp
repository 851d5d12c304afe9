// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/PressureMenu.h"

#include "ui/Theme.h"
#include "ui/Workspace.h"
#include "ui/widgets/PressureCurve.h"

#include <QMenu>
#include <QWidgetAction>

#include <cmath>

namespace ui {

PressureMenu::PressureMenu(Workspace& workspace, QWidget* parent)
    : QToolButton(parent)
    , m_workspace(workspace)
    , m_curve(new PressureCurve)
{
    setObjectName(QStringLiteral("drillPressure"));
    setPopupMode(QToolButton::InstantPopup);
    setToolButtonStyle(Qt::ToolButtonTextOnly);
    setFixedHeight(theme::controlHeight);
    auto* menu = new QMenu(this);
    auto* holder = new QWidgetAction(menu);
    holder->setDefaultWidget(m_curve);
    menu->addAction(holder);
    setMenu(menu);
    showSettings();
    connect(&m_workspace, &Workspace::drillSettingsChanged, this, &PressureMenu::showSettings);
    connect(m_curve, &PressureCurve::exponentChosen, this, [this](int exponent) {
        Workspace::DrillSettings settings = m_workspace.drillSettings();
        settings.pressureExponent = exponent;
        m_workspace.setDrillSettings(settings);
    });
}

void PressureMenu::showSettings()
{
    const int exponent = m_workspace.drillSettings().pressureExponent;
    m_curve->setExponent(exponent);
    static const QString powers[]{QString(), QStringLiteral("²"), QStringLiteral("³")};
    setText(tr("p") + powers[exponent - 1]);
    setToolTip(tr("Pressure curve: half the pressure cuts %1 % of the depth")
                   .arg(std::lround(100.0 * std::pow(0.5, exponent))));
}

} // namespace ui

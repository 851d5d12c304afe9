// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/common/PenPressure.h"

#include "ui/base/Icons.h"
#include "ui/base/Theme.h"

#include <QToolButton>

#include <algorithm>

namespace ui {

namespace {

constexpr double leastPressedShare = 0.1;
constexpr double harderBy = 0.02;

} // namespace

double pressedShare(const PointerSample& sample)
{
    return sample.isPen ? std::clamp(sample.pressure, leastPressedShare, 1.0) : 1.0;
}

bool pressesHarder(double share, double before)
{
    return share > before + harderBy;
}

QToolButton* pressureButton(QWidget* parent)
{
    auto* button = new QToolButton(parent);
    button->setObjectName(QStringLiteral("radiusByPressure"));
    button->setIcon(stateIcon(QStringLiteral("pressure")));
    button->setAccessibleName(QObject::tr("Pressure: radius"));
    button->setToolTip(QObject::tr(
        "Pressure: radius, that is, the radius follows the pressure of the pen, up to the one that "
        "is set. Off: pressure does nothing, as with a mouse."));
    button->setCheckable(true);
    button->setFixedHeight(theme::controlHeight);
    return button;
}

} // namespace ui

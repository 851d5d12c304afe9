// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/common/PenPressure.h"

#include "ui/base/Icons.h"
#include "ui/base/Theme.h"

#include <QToolButton>

#include <algorithm>
#include <cmath>

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

void StrokePressure::begin(const PointerSample& sample, bool counts)
{
    m_counts = counts && sample.isPen;
    m_share = m_counts ? pressedShare(sample) : 1.0;
}

void StrokePressure::extend(const PointerSample& sample)
{
    if (m_counts)
        m_share = std::max(m_share, pressedShare(sample));
}

double StrokePressure::of(double setMm, double leastMm) const
{
    if (m_share == 1.0 || setMm <= leastMm)
        return setMm;
    // Rounded as fields and cursor show it, so that the edit has the number that the user reads.
    return std::clamp(std::round(10.0 * m_share * setMm) / 10.0, leastMm, setMm);
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

QToolButton* depthPressureButton(QWidget* parent)
{
    QToolButton* button = pressureButton(parent);
    button->setObjectName(QStringLiteral("depthByPressure"));
    button->setAccessibleName(QObject::tr("Pressure: depth"));
    button->setToolTip(QObject::tr(
        "Pressure: depth, that is, a curve cuts as deep as the pen is pressed at most while it is "
        "drawn, up to the depth that is set. Off: pressure does nothing, as with a mouse."));
    return button;
}

} // namespace ui

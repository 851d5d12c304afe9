// SPDX-License-Identifier: Apache-2.0
#include "ui/input/EveryPointerEvent.h"

#include <QCoreApplication>

namespace ui {

EveryPointerEvent::EveryPointerEvent()
    : m_mouseBefore(QCoreApplication::testAttribute(Qt::AA_CompressHighFrequencyEvents))
    , m_penBefore(QCoreApplication::testAttribute(Qt::AA_CompressTabletEvents))
{
    QCoreApplication::setAttribute(Qt::AA_CompressHighFrequencyEvents, false);
    QCoreApplication::setAttribute(Qt::AA_CompressTabletEvents, false);
}

EveryPointerEvent::~EveryPointerEvent()
{
    QCoreApplication::setAttribute(Qt::AA_CompressHighFrequencyEvents, m_mouseBefore);
    QCoreApplication::setAttribute(Qt::AA_CompressTabletEvents, m_penBefore);
}

} // namespace ui

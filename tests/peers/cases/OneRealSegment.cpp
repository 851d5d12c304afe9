// SPDX-License-Identifier: Apache-2.0
#include "tests/peers/cases/OneRealSegment.h"

#include "core/session/EditSession.h"
#include "tests/support/program/LongRun.h"

#include <QStringList>

namespace peer {

RealSegment* OneRealSegment::of(core::EditEngine& engine, std::size_t series)
{
    if (m_series == series)
        return m_segment.get();
    close(); // its session ends before another begins on the engine
    m_series = series;
    constexpr int side = 64;
    auto opened = RealSegment::open(engine, realSeries().at(series), test::longRun() ? 0 : side);
    if (!opened)
        qWarning("%s: %s", realSeries().at(series).name,
            qPrintable(opened.error().arguments.join(QStringLiteral(", "))));
    else
        m_segment = *std::move(opened);
    return m_segment.get();
}

} // namespace peer

// SPDX-License-Identifier: Apache-2.0
#include "tests/reenactment/sighted/SightedLog.h"

#include <ctime>

namespace reenact {

SightedLog::SightedLog(RefinementBench& bench, const Inspection& inspection)
    : m_bench(bench)
    , m_inspection(inspection)
    , m_seen(bench.seen())
{
}

QString SightedLog::timed(const core::Edit& edit)
{
    const std::clock_t start = std::clock();
    QString why = m_bench.tried(edit);
    m_run.seconds += double(std::clock() - start) / double(CLOCKS_PER_SEC);
    return why;
}

void SightedLog::countOne(const QString& what)
{
    m_run.steps.push_back({what, runsOf(m_seen)});
}

bool SightedLog::act(const core::Edit& edit, const QString& what)
{
    if (const QString why = timed(edit); !why.isEmpty()) {
        countOne(what + QStringLiteral(", refused: ") + why);
        return false;
    }
    const Mask before = m_seen;
    m_seen = m_bench.seen();
    countOne(what);
    const std::size_t was = m_inspection.wrongIn(before);
    const std::size_t is = m_inspection.wrongIn(m_seen);
    if (is > was && m_bench.undone().isEmpty()) {
        m_seen = m_bench.seen();
        countOne(QStringLiteral("take back"));
    }
    return is < was;
}

bool SightedLog::prepare(const core::Edit& edit, const QString& what)
{
    const QString why = timed(edit);
    m_seen = m_bench.seen();
    countOne(why.isEmpty() ? what : what + QStringLiteral(", refused: ") + why);
    return why.isEmpty();
}

SightedRun SightedLog::finished(int looks)
{
    m_run.mask = runsOf(m_bench.segment());
    // What is left in the end is the segment, of which a surface may still stand beside.
    if (!m_run.steps.empty())
        m_run.steps.back().seen = m_run.mask;
    m_run.looks = looks;
    return std::move(m_run);
}

} // namespace reenact

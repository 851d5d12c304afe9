// SPDX-License-Identifier: Apache-2.0
#include "ui/settings/SegmentIntervals.h"

#include "core/session/EditSession.h"

#include <QJsonObject>

#include <algorithm>
#include <cmath>

namespace ui {

void SegmentIntervals::clear()
{
    m_known.clear();
    m_since.clear();
    m_early.clear();
}

void SegmentIntervals::follow(const core::EditSession& session)
{
    const core::Document& document = session.document();
    std::erase_if(m_since,
        [&document](const auto& each) { return each.first != 0 && !document.segment(each.first); });
    const core::History& history = session.history();
    for (const core::Segment& segment : document.segments) {
        const int label = segment.label;
        if (m_since.contains(label))
            continue;
        // Redo brings back a segment whose interval is known; a branch makes another one.
        const std::vector<core::RowId> path = history.pathTo(history.position());
        const auto isOnPath = [&path](core::RowId row) {
            return row == 0 || std::find(path.begin(), path.end(), row) != path.end();
        };
        const auto known = std::find_if(m_known.begin(), m_known.end(),
            [&](const Known& each) { return each.label == label && isOnPath(each.since); });
        m_since[label] = known == m_known.end() ? history.position() : known->since;
        if (const auto early = m_early.extract(label))
            set(label, early.mapped());
    }
}

std::optional<SegmentIntervals::Interval> SegmentIntervals::takeFirst()
{
    const std::optional<Interval> first = of(0);
    std::erase_if(m_known, [](const Known& each) { return each.label == 0; });
    return first;
}

const SegmentIntervals::Known* SegmentIntervals::find(int label) const
{
    const auto since = m_since.find(label);
    if (label != 0 && since == m_since.end())
        return nullptr;
    const core::RowId row = label == 0 ? 0 : since->second;
    const auto known = std::find_if(m_known.begin(), m_known.end(),
        [&](const Known& each) { return each.label == label && each.since == row; });
    return known == m_known.end() ? nullptr : &*known;
}

std::optional<SegmentIntervals::Interval> SegmentIntervals::of(int label) const
{
    if (const auto early = m_early.find(label); early != m_early.end())
        return early->second;
    const Known* known = find(label);
    return known ? std::optional(known->interval) : std::nullopt;
}

void SegmentIntervals::set(int label, const Interval& interval)
{
    if (label != 0 && !m_since.contains(label)) {
        m_early[label] = interval;
        return;
    }
    if (const Known* known = find(label)) {
        m_known[std::size_t(known - m_known.data())].interval = interval;
        return;
    }
    m_known.push_back(
        {.label = label, .since = label == 0 ? 0 : m_since.at(label), .interval = interval});
}

QJsonArray SegmentIntervals::json() const
{
    QJsonArray list;
    for (const Known& each : m_known) {
        if (find(each.label) != &each)
            continue; // of one that was undone
        list.append(QJsonObject{{QStringLiteral("segment"), each.label},
            {QStringLiteral("lower"), each.interval.lower},
            {QStringLiteral("upper"), each.interval.upper},
            {QStringLiteral("byHand"), each.interval.byHand}});
    }
    return list;
}

void SegmentIntervals::read(const QJsonArray& json, const core::EditSession& session)
{
    clear();
    follow(session);
    for (const QJsonValue& value : json) {
        const int label = value[QLatin1String("segment")].toInt(-1);
        const QJsonValue lower = value[QLatin1String("lower")];
        const QJsonValue upper = value[QLatin1String("upper")];
        const bool exists = label == 0 || (label > 0 && session.document().segment(label));
        if (exists && lower.isDouble() && upper.isDouble() && lower.toDouble() <= upper.toDouble())
            set(label,
                {.lower = lower.toDouble(),
                    .upper = upper.toDouble(),
                    .byHand = value[QLatin1String("byHand")].toBool()});
    }
}

} // namespace ui

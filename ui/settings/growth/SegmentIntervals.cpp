// SPDX-License-Identifier: Apache-2.0
#include "ui/settings/growth/SegmentIntervals.h"

#include "core/edits/kinds/EditParts.h"
#include "core/edits/kinds/growth/ChangeInterval.h"
#include "core/edits/kinds/parts/GrowthPlane.h"
#include "core/session/EditSession.h"
#include "core/session/past/RecentGrowth.h"

#include <QJsonObject>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace ui {

namespace {

constexpr double mostTolerance = 100.0; ///< of a file; the slider has its own range

/// The last growth in effect; 0: nothing has grown.
core::RowId lastGrowth(const core::History& history)
{
    const std::vector<core::RowId> rows = history.standing();
    const auto last = std::find_if(rows.rbegin(), rows.rend(),
        [&](core::RowId row) { return core::growCriteriaOf(history.row(row).edit) != nullptr; });
    return last == rows.rend() ? 0 : *last;
}

/// Whether a growth leaves the interval of a segment as it is: it took place in one that holds
/// those of several.
bool grewInOneOfSeveral(const core::Edit& growth)
{
    const core::GrowCriteria& criteria = *core::growCriteriaOf(growth);
    return !growth.is<core::ChangeInterval>() && criteria.segments && criteria.segments->size() > 1;
}

/// Whether the last growth grew a segment.
bool grew(
    const core::GrowCriteria& last, const core::Segment& segment, const core::History& history)
{
    if (!last.segments)
        return !segment.locked && segment.plane == core::growthPlaneOf(last.plane)
            && core::hasGrown(history, segment);
    return std::find(last.segments->begin(), last.segments->end(), segment.label)
        != last.segments->end();
}

} // namespace

void SegmentIntervals::clear()
{
    m_known.clear();
    m_since.clear();
    m_early.clear();
    m_then.clear();
    m_rows = 0;
    m_position = 0;
}

void SegmentIntervals::follow(const core::EditSession& session)
{
    followSegments(session);
    followGrowth(session);
}

void SegmentIntervals::followGrowth(const core::EditSession& session)
{
    const core::History& history = session.history();
    const core::RowId from = std::exchange(m_position, history.position());
    const bool walked = std::exchange(m_rows, history.rows().size()) == history.rows().size();
    if (walked && from == m_position)
        return;
    // A new step has the intervals that were wanted, and those may have been moved on since.
    if (!walked)
        return remember(session);
    std::bitset<256> affected;
    const std::vector<core::RowId> before = history.standing(from);
    const std::vector<core::RowId> now = history.standing();
    std::vector<core::RowId> over;
    std::set_symmetric_difference(
        before.begin(), before.end(), now.begin(), now.end(), std::back_inserter(over));
    for (const core::RowId row : over) {
        const core::GrowCriteria* criteria = core::growCriteriaOf(history.row(row).edit);
        if (criteria && !criteria->segments)
            affected |= session.document().labelsIn(core::growthPlaneOf(criteria->plane));
        else if (criteria) {
            for (const int label : *criteria->segments)
                affected.set(std::size_t(label));
        }
    }
    if (affected.any())
        goBack(session, affected);
}

void SegmentIntervals::remember(const core::EditSession& session)
{
    const core::History& history = session.history();
    const core::RowId growth = lastGrowth(history);
    if (growth == 0 || m_then.contains(growth))
        return;
    const core::Edit& edit = history.row(growth).edit;
    const core::GrowCriteria& criteria = *core::growCriteriaOf(edit);
    std::map<int, Interval>& then = m_then[growth];
    for (const core::Segment& segment : session.document().segments) {
        std::optional<Interval> interval = of(segment.label);
        if (!interval)
            continue;
        if (!grewInOneOfSeveral(edit) && grew(criteria, segment, history)) {
            interval->lower = criteria.lower;
            interval->upper = criteria.upper;
        }
        then.emplace(segment.label, *interval);
    }
}

void SegmentIntervals::goBack(const core::EditSession& session, const std::bitset<256>& segments)
{
    const core::History& history = session.history();
    const core::RowId growth = lastGrowth(history);
    if (growth == 0)
        return;
    const auto then = m_then.find(growth);
    for (const core::Segment& segment : session.document().segments) {
        // What has not grown yet keeps what is set for it.
        if (!segments.test(std::size_t(segment.label)) || !core::hasGrown(history, segment))
            continue;
        const bool known = then != m_then.end() && then->second.contains(segment.label);
        if (known) {
            set(segment.label, then->second.at(segment.label));
        } else if (const auto own = core::recentCriteria(history, segment.plane);
                   own && grew(*own, segment, history)) { // in a window that was closed since
            Interval interval = of(segment.label).value_or(Interval{.byHand = true});
            interval.lower = own->lower;
            interval.upper = own->upper;
            set(segment.label, interval);
        }
    }
}

void SegmentIntervals::followSegments(const core::EditSession& session)
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

void SegmentIntervals::setByHand(int label, double lower, double upper)
{
    Interval interval = of(label).value_or(Interval());
    interval.lower = lower;
    interval.upper = upper;
    interval.byHand = true;
    set(label, interval);
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
            {QStringLiteral("byHand"), each.interval.byHand},
            {QStringLiteral("tolerance"), each.interval.tolerance}});
    }
    return list;
}

void SegmentIntervals::read(const QJsonArray& json, const core::EditSession& session)
{
    clear();
    followSegments(session);
    m_position = session.history().position();
    m_rows = session.history().rows().size();
    for (const QJsonValue& value : json) {
        const int label = value[QLatin1String("segment")].toInt(-1);
        const QJsonValue lower = value[QLatin1String("lower")];
        const QJsonValue upper = value[QLatin1String("upper")];
        const bool exists = label == 0 || (label > 0 && session.document().segment(label));
        if (exists && lower.isDouble() && upper.isDouble() && lower.toDouble() <= upper.toDouble())
            set(label,
                {.lower = lower.toDouble(),
                    .upper = upper.toDouble(),
                    .byHand = value[QLatin1String("byHand")].toBool(),
                    .tolerance =
                        std::clamp(value[QLatin1String("tolerance")].toDouble(usualTolerance), 0.0,
                            mostTolerance)});
    }
    remember(session);
}

} // namespace ui

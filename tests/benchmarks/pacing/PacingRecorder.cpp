// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/pacing/PacingRecorder.h"

#include "ui/views/ViewGrid.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace bench {

namespace {

QString wordFor(const std::optional<gpu::Frame::Quality>& quality)
{
    if (!quality)
        return QStringLiteral("of a scene before");
    switch (*quality) {
    case gpu::Frame::Quality::Coarse:
        return QStringLiteral("coarse");
    case gpu::Frame::Quality::Full:
        return QStringLiteral("full");
    case gpu::Frame::Quality::Refined:
        return QStringLiteral("refined");
    }
    return {};
}

} // namespace

PacingRecorder::PacingRecorder(PacedApplication& application, const ui::ViewGrid& views)
    : m_application(application)
    , m_views(views)
{
    m_application.setPainted([this](const QObject& widget) { painted(widget); });
    m_beat.setTimerType(Qt::PreciseTimer);
    m_beat.setInterval(beat);
    m_beat.callOnTimeout([this] { look(); });
}

PacingRecorder::~PacingRecorder()
{
    m_application.setPainted({});
}

double PacingRecorder::sinceBegin(Clock::time_point time) const
{
    return std::chrono::duration<double, std::milli>(time - m_begin).count();
}

void PacingRecorder::begin()
{
    m_record = {};
    static_cast<void>(m_application.takeHandled());
    m_begin = m_looked = Clock::now();
    m_records = true;
    m_beat.start();
}

void PacingRecorder::endPhase()
{
    if (!m_record.phases.empty())
        m_record.phases.back().end = sinceBegin(Clock::now());
}

void PacingRecorder::beginPhase(const QString& id, const ui::ImageView& seenIn)
{
    endPhase();
    m_record.phases.push_back(
        {.id = id, .view = seenIn.title(), .begin = sinceBegin(Clock::now())});
}

PacingRecord PacingRecorder::end()
{
    endPhase();
    look();
    m_beat.stop();
    m_records = false;
    return std::exchange(m_record, {});
}

int PacingRecorder::picturesOf(const ui::ImageView& view) const
{
    const auto found = m_counts.find(&view);
    return found == m_counts.end() ? 0 : found->second;
}

void PacingRecorder::painted(const QObject& widget)
{
    const auto views = m_views.views();
    const auto found = std::find(views.begin(), views.end(), &widget);
    if (found == views.end() || (*found)->picture().isNull())
        return;
    const ui::ImageView& view = **found;
    const qint64 key = view.picture().cacheKey();
    // What lies over a picture is painted more often than there is a new one.
    if (std::exchange(m_shown[&view], key) == key)
        return;
    ++m_counts[&view];
    if (m_records)
        m_record.pictures.push_back({.at = sinceBegin(Clock::now()),
            .view = view.title(),
            .quality = wordFor(view.quality())});
}

void PacingRecorder::look()
{
    const Clock::time_point now = Clock::now();
    const Clock::time_point before = std::exchange(m_looked, now);
    const std::vector<PacedApplication::Handled> handled = m_application.takeHandled();
    if (now - before < late)
        return;
    PacingRecord::Gap gap{
        .begin = sinceBegin(before), .lasted = sinceBegin(now) - sinceBegin(before)};
    for (const PacedApplication::Handled& event : handled) {
        const double took = sinceBegin(event.end) - sinceBegin(event.begin);
        if (took > gap.ofThat) {
            gap.name = event.name;
            gap.ofThat = took;
        }
    }
    m_record.gaps.push_back(std::move(gap));
}

} // namespace bench

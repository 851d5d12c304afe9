// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/benchmarks/pacing/PacedApplication.h"
#include "tests/benchmarks/pacing/PacingRecord.h"

#include <QTimer>

#include <map>

namespace ui {
class ImageView;
class ViewGrid;
} // namespace ui

namespace bench {

/// Watches a window: which pictures reach it, and when the loop of its events does not come round.
class PacingRecorder {
public:
    /// @param views outlive the recorder, as does the application
    PacingRecorder(PacedApplication& application, const ui::ViewGrid& views);
    ~PacingRecorder();
    PacingRecorder(const PacingRecorder&) = delete;
    PacingRecorder& operator=(const PacingRecorder&) = delete;

    void begin(); ///< a record anew
    /// What is done from now on, until the next phase or the end.
    void beginPhase(const QString& id, const ui::ImageView& seenIn);
    [[nodiscard]] PacingRecord end();

    /// How many pictures a view has shown since the recorder was made.
    [[nodiscard]] int picturesOf(const ui::ImageView& view) const;

private:
    using Clock = PacedApplication::Clock;
    /// How often the loop is looked at, and from when on a look comes late.
    static constexpr std::chrono::milliseconds beat{4};
    static constexpr std::chrono::milliseconds late{10};

    void painted(const QObject& widget);
    void look();
    void endPhase();
    [[nodiscard]] double sinceBegin(Clock::time_point time) const;

    PacedApplication& m_application;
    const ui::ViewGrid& m_views;
    PacingRecord m_record;
    bool m_records = false;
    Clock::time_point m_begin;
    Clock::time_point m_looked;
    QTimer m_beat;
    std::map<const ui::ImageView*, qint64> m_shown; ///< the picture's key
    std::map<const ui::ImageView*, int> m_counts;
};

} // namespace bench

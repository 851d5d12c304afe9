// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QJsonArray>
#include <QString>

#include <vector>

namespace bench {

/// What a window showed in a scripted minute, and when its thread heard nobody. All times are
/// milliseconds since the minute began.
struct PacingRecord {
    /// A stretch of one kind of work.
    struct Phase {
        QString id; ///< "orbit"
        QString view; ///< the one that the work is seen in
        double begin = 0.0;
        double end = 0.0;
    };
    /// A picture that has reached the window.
    struct Picture {
        double at = 0.0;
        QString view;
        QString quality;
    };
    /// The event loop did not come round.
    struct Gap {
        double begin = 0.0;
        double lasted = 0.0;
        QString name; ///< the longest event meanwhile; empty: none took a millisecond
        double ofThat = 0.0; ///< what that event took
    };
    /// How long nothing new was seen in the view of a phase, until then.
    struct Wait {
        double at = 0.0;
        double lasted = 0.0;
    };

    std::vector<Phase> phases;
    std::vector<Picture> pictures; ///< in the order of time
    std::vector<Gap> gaps;

    /// Of a phase, the first since it began. What is left behind its last picture is one as well if
    /// it is longer than all others: then nothing came any more.
    [[nodiscard]] std::vector<Wait> waits(const Phase& phase) const;
    [[nodiscard]] Gap longestGap() const;
    [[nodiscard]] QString phaseAt(double at) const; ///< its id; empty: none

    /// Median (pacing.PHASE), 95th percentile (.p95) and longest (.worst) of the waits, and the
    /// longest gap (pacing.longestStall), as burin_bench writes its figures.
    [[nodiscard]] QJsonArray figures() const;
    /// One line a picture and a gap, with a line of titles.
    [[nodiscard]] QByteArray csv() const;
};

} // namespace bench
